"""Compare a cycle of a generated node with one that copies its data, as the original's does.

Run by a Python that has rclpy, with the folder of the package `fast` (see the Makefile) in
PYTHONPATH. The node has one input and one output of 10,000 floats.
"""

import array
import copy
import statistics
import time

import rclpy
from fast.relay_impl import RelayImpl
from fast.relay_ros import RelayNode
from std_msgs.msg import Float64MultiArray

ROUNDS = 15
CYCLES = 50


def relay(self, data, config):
    data.out_floats_out = data.in_floats_in


def relay_copies(self, data, config):
    relay(self, copy.deepcopy(data), config)


def cycle_time(node, message):
    start = time.perf_counter()
    for _ in range(CYCLES):
        node._receive_floats_in(message)
        node._update()
    return (time.perf_counter() - start) / CYCLES


def main():
    rclpy.init()
    node = RelayNode()
    node.trigger_configure()
    message = Float64MultiArray(data=array.array("d", [1.0] * 10000))
    times = {"handed over": [], "copied in each cycle": []}
    for _ in range(ROUNDS):
        for what, update in zip(times, (relay, relay_copies), strict=True):
            RelayImpl.update = update
            times[what].append(cycle_time(node, message))
    base = statistics.median(times["handed over"])
    for what, taken in times.items():
        median = statistics.median(taken)
        print(f"10,000 floats {what:22}{median * 1e6:8.0f} us a cycle  x {median / base:.1f}")


if __name__ == "__main__":
    main()
