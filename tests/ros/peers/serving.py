"""Talk to the node `clerk` of examples/serving through ROS: serving.py PEER, ros1 or ros2."""

import importlib
import sys
import time

peer = importlib.import_module(sys.argv[1]).Peer()
peer.wait_until_active("clerk")
answer = peer.call("greet", "std_srvs/srv/Trigger")
assert (answer.success, answer.message) == (True, "good day"), answer
goal = peer.goal("count", "test_msgs/action/Fibonacci", order=20)
end = time.monotonic() + 10
while not goal.feedback:
    assert time.monotonic() < end, "no feedback"
    time.sleep(0.01)
# The services go on while the action runs.
assert peer.call("clerk/open", "std_srvs/srv/SetBool", data=True).message == "open: True"
goal.cancel()
assert goal.result()[0] == "canceled", goal.result()
goal = peer.goal("count", "test_msgs/action/Fibonacci", order=3)
assert goal.result() == ("succeeded", [0, 1, 2]), goal.result()
if hasattr(peer, "change_state"):
    for transition in ("deactivate", "cleanup", "configure", "activate"):
        assert peer.change_state("clerk", transition), transition
    assert peer.call("greet", "std_srvs/srv/Trigger").success
peer.close()
