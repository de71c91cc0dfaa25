"""A ROS 1 master that tells of a new publisher at once, where rosmaster takes up to 0.1 s."""

import sys

from rosmaster.main import rosmaster_main
from rosmaster.threadpool import ThreadPoolThread

ThreadPoolThread.threadSleepTime = 0.005  # s, between two looks for what there is to tell
rosmaster_main(["rosmaster", "--core", *sys.argv[1:]])
