"""Start a node where one that was killed has left its shared memory broken.

As in Fast-DDS #6501. With a folder of tests of a package: in the environment of these tests.
"""

import importlib
import os
import subprocess
import sys
from pathlib import Path

START = "import os, rclpy; rclpy.init(); node = rclpy.create_node('node'); "
TAIL = 1200  # bytes from the end: where its allocator has its records

if len(sys.argv) > 1:
    del os.environ["FASTDDS_DEFAULT_PROFILES_FILE"]
    sys.path.insert(0, sys.argv[1])
    importlib.import_module("support.peer")  # sets the environment
domain = int(os.environ["ROS_DOMAIN_ID"])
shared = os.environ | {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
subprocess.run([sys.executable, "-c", START + "os.kill(os.getpid(), 9)"], env=shared)
first = 7400 + 250 * domain
files = [
    path
    for port in range(first, first + 250)
    for path in Path("/dev/shm").glob(f"fastdds_port{port}*")
]
broken = [path for path in files if path.stat().st_size > TAIL]
assert broken, "no shared memory is left"
try:
    for path in set(files) - set(broken):
        path.unlink()
    for path in broken:
        with path.open("r+b") as file:
            file.seek(-TAIL, os.SEEK_END)
            file.write(bytes(range(1, 256)) * 4)
    sys.exit(subprocess.run([sys.executable, "-c", START]).returncode)
finally:
    for path in broken:
        path.unlink(missing_ok=True)
