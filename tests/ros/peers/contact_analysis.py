"""Talk to the node of examples/contact_analysis through ROS: contact_analysis.py PEER."""

import importlib
import sys

peer = importlib.import_module(sys.argv[1]).Peer()
cop = peer.publisher("cop", "geometry_msgs/msg/Point")
assert peer.get_parameter("contact_evaluate", "samples") == 200
assert peer.set_parameter("contact_evaluate", "pub_sample", False)
for service in ("load", "store"):
    answer = peer.call(service, "contact_msgs/srv/SetString", data="models")
    assert (answer.success, answer.message) == (False, ""), answer
for action, goal in (("learn", {"contact": "toe"}), ("evaluate", {"duration": 1.0})):
    goal = peer.goal(action, f"contact_msgs/action/{action.capitalize()}Contact", **goal)
    assert goal.result()[0] == "succeeded", goal.result()
assert cop.connected()
if hasattr(peer, "change_state"):
    assert peer.state("contact_evaluate") == "active"
peer.close()
