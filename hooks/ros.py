"""What the hook knows about ROS itself: distributions, and packages that changed name."""

from __future__ import annotations

DISTROS = {"noetic": 1, "humble": 2, "jazzy": 2, "kilted": 2, "lyrical": 2, "rolling": 2}
"""The ROS distributions that can be chosen, each with its generation (REP 3, REP 2000)."""

DEFAULT_DISTRO = "lyrical"

# A package of one generation and what stands for it in the other; None: nothing is needed.
_SUCCESSORS: dict[int, dict[str, str | None]] = {
    1: {
        "actionlib": None,
        "actionlib_msgs": "action_msgs",
        "catkin": None,
        "cv_bridge": "cv_bridge",
        "dynamic_reconfigure": None,
        "genmsg": None,
        "message_generation": "rosidl_default_generators",
        "message_runtime": "rosidl_default_runtime",
        "nodelet": "rclcpp_components",
        "rosconsole": None,
        "roscpp": "rclcpp",
        "roslaunch": "launch_ros",
        "roslib": "ament_index_python",
        "rospy": "rclpy",
        "rostest": "launch_testing_ros",
        "tf": "tf2_ros",
        "tf_conversions": "tf2_geometry_msgs",
        "tf2_ros": "tf2_ros",
    },
    2: {
        "action_msgs": "actionlib_msgs",
        "ament_cmake": None,
        "ament_index_cpp": "roslib",
        "ament_index_python": "roslib",
        "ament_python": None,
        "launch": "roslaunch",
        "launch_ros": "roslaunch",
        "launch_testing_ros": "rostest",
        "lifecycle_msgs": None,
        "rcl_interfaces": None,
        "rclcpp": "roscpp",
        "rclcpp_action": "actionlib",
        "rclcpp_components": "nodelet",
        "rclcpp_lifecycle": "roscpp",
        "rclpy": "rospy",
        "rosidl_default_generators": "message_generation",
        "rosidl_default_runtime": "message_runtime",
        "tf2_ros_py": "tf2_ros",
    },
}


def translate_dependency(package: str, generation: int) -> tuple[str | None, str | None]:
    """Return what `package` is called in a ROS generation, and a note where that differs.

    A package that is not known to belong to the other generation keeps its name.
    """
    successors = _SUCCESSORS[3 - generation]
    if package not in successors or successors[package] == package:
        return package, None
    successor = successors[package]
    meaning = f"became {successor}" if successor else "was left out"
    return (
        successor,
        f"<depend>{package}</depend> has no meaning in ROS {generation}: it {meaning}",
    )
