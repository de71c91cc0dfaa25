"""A peer of the nodes under test: carries out requests in ROS.

Run by the Python of a ROS, with ros1 or ros2. Each line of its input is a request in JSON,
{"id": 1, "method": "call", "arguments": {...}}; each gets a line of answer, with "result" or
"error", as soon as it is done: requests do not wait for each other.
"""

import importlib
import json
import os
import sys
import threading
import traceback
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2] / "ros/peers"))  # what all peers share

lock = threading.Lock()
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)  # ROS logs to both


def carry_out(peer, request):
    answer = {"id": request["id"]}
    try:
        answer["result"] = getattr(peer, request["method"])(**request["arguments"])
    except BaseException:
        answer["error"] = traceback.format_exc()
    with lock:
        print(json.dumps(answer), file=answers, flush=True)


peer = importlib.import_module(sys.argv[1]).Peer()
for line in sys.stdin:
    threading.Thread(target=carry_out, args=(peer, json.loads(line)), daemon=True).start()
os._exit(0)  # whatever threads of ROS still run
