"""Check that the node `relay` of the package `fast` hands messages on without copying them."""

import time

import rclpy
from fast.relay_impl import RelayImpl
from fast.relay_ros import RelayNode
from std_msgs.msg import Float64MultiArray

message = Float64MultiArray(data=[1.0] * 10000)
heard = []
RelayImpl.update = lambda self, data, config: heard.append(
    (data.in_floats_in, data.in_floats_in_updated)
)

rclpy.init()
node = RelayNode()
node.trigger_configure()
node.trigger_activate()
node._receive_floats_in(message)
end = time.monotonic() + 10
while not any(updated for _, updated in heard) and time.monotonic() < end:
    time.sleep(0.01)
node.destroy_node()
(new,) = [latest for latest, updated in heard if updated]
assert new is message, "the message was copied"
assert heard[-1][0] is message, "the latest message is not kept"
