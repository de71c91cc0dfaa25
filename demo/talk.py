"""Talk to the robot of the demo through ROS, as another node would, and print what it answers.

Run by the Python of a ROS: talk.py PEER, where PEER is ros1 or ros2.
"""

import importlib
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests/ros/peers"))


def talk(peer):
    """Enable the robot, let it drive a spiral, and look at its velocities meanwhile."""
    velocities = peer.hear("cmd_vel", "geometry_msgs/msg/Twist")
    answer = peer.call("enable", "std_srvs/srv/SetBool", data=True)
    print(f"service enable   {answer.success}: {answer.message}")
    goal = peer.goal("spiral", "test_msgs/action/Fibonacci", order=8)
    outcome, radii = goal.result()
    print(f"action spiral    {outcome}: {radii}, after {len(goal.feedback)} feedbacks")
    fastest = max(velocity.angular.z for velocity in velocities)
    end = time.monotonic() + 5
    while velocities[-1].linear.x and time.monotonic() < end:
        time.sleep(0.01)
    still = "stands still" if velocities[-1].linear.x == 0 else "still moves"
    print(f"topic cmd_vel    turned with up to {fastest:.2f} rad/s, now {still}")


def main():
    """Talk, and leave ROS whatever happens."""
    peer = importlib.import_module(sys.argv[1]).Peer()
    try:
        talk(peer)
    finally:
        peer.close()


if __name__ == "__main__":
    main()
