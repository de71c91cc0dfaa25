"""Run the nodes of tests/contract, watch them, and talk to them through ROS."""

import itertools
import json
import os
import re
import signal
import subprocess
import threading
import time
from concurrent.futures import Future
from pathlib import Path

from support import ros
from support.packages import shared_runtime, without_tf

CONTRACT = Path(__file__).parents[1] / "contract"
METHODS = ("configure", "activate", "update", "deactivate", "cleanup")
GOALS = ("work", "line", "single", "choice", "crowd")
LATES = ("late_speed", "late_order")
CALLBACKS = (
    "receive",
    "serve",
    "accept",
    *GOALS,
    "read",
    "poll",
    "exact",
    "near",
    "take",
    "order",
    *LATES,
)
NOISE = (
    "Traceback",
    "Exception",
    "terminate called",
    "not shut down",
    "Segmentation",
    "[FATAL]",
    "[ERROR]",
)
STRANGERS = (
    r".*\[ERROR\].* (received a tcpros connection for a nonexistent service"
    r"|a header of over a gigabyte was predicted in tcpros).*\n"
)
"""What roscpp 1.15 logs of who connects to it by mistake.

A caller may do so just after the server has gone; the master, when a node that was killed had the
port before.
"""
IDLE = (
    "update begin {'number': None, 'map': None, 'gain': 1.0}",
    "update begin {'number': None, 'map': None, 'gain': 1}",
    "update end True",
)
TIMEOUT = 20.0  # s; much more than anything takes on an idle machine
_names = itertools.count(1)


def wait_for(condition, what, timeout=TIMEOUT):
    """Return the first true value of a condition; fail after `timeout` seconds."""
    end = time.monotonic() + timeout
    while True:
        value = condition()
        if value:
            return value
        assert time.monotonic() < end, what() if callable(what) else what
        time.sleep(0.01)


class Variant:
    """A model in a ROS: the package of the contract, built."""

    def __init__(self, model, ros_, make, once, underlay=None, runtime="inside"):
        self.model = model
        self.runtime = runtime
        self.ros = ros_
        self.is_ros2 = ros_.environment["ROS_VERSION"] == "2"
        self.is_python = model == "python_model"
        self.has_tf = ros.has(ros_, "tf2_ros")
        in_cpp = self.is_ros2 and not self.is_python
        self.has_filters = (ros.has_package if in_cpp else ros.has)(ros_, "message_filters")
        self.workspace = once(
            f"contract_{model}_{ros_.distro}_{runtime}",
            lambda folder: self._build(folder, make, underlay),
        )
        printed = subprocess.run(
            ros_.command("env -0", self.workspace),
            env=ros_.environment,
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        self.environment = dict(item.split("=", 1) for item in printed.split("\0") if item)

    def _build(self, workspace, make, underlay):
        """Build the package, with the logic of the tests in place of the empty one."""
        spec = (CONTRACT / "contract.ros_package").read_text()
        file = workspace / "contract.ros_package"
        spec = spec if self.has_tf else without_tf(spec)
        joiner = r' *<node name="joiner">.*?</node>\n'
        file.write_text(spec if self.has_filters else re.sub(joiner, "", spec, flags=re.S))
        package = workspace / "src/contract"
        if self.runtime == "inside":
            make(package, file, model=self.model, ros_distro=self.ros.distro)
        else:
            shared_runtime(make, self.model, workspace, self.ros.distro, file)
        folders = {".py": "contract", ".hpp": "include/contract", ".cpp": "src"}
        for source in (CONTRACT / "logic").glob("*.py" if self.is_python else "*.[hc]pp"):
            text = source.read_text().replace("HAS_TF", str(int(self.has_tf)))
            if self.runtime != "inside":
                text = re.sub(r"\bcontract([./])ros\1", rf"{self.runtime}\1ros\1", text)
            (package / folders[source.suffix] / source.name).write_text(text)
        option = "--cmake-args -DBUILD_TESTING=OFF" if self.is_ros2 else ""
        self.ros.run(f"{self.ros.build_command} {option}", workspace, underlay, timeout=1800)

    def executable(self, node):
        folder = "install/contract/lib" if self.is_ros2 else "devel/lib"
        return self.workspace / folder / "contract" / node

    def arguments(self, namespace, parameters, remap=None, files=()):
        """Return the command line that gives a node its namespace, parameters and other names."""
        names = [f"{old}:={new}" for old, new in {"__ns": namespace, **(remap or {})}.items()]
        if not self.is_ros2:
            return [*names, *(f"_{n}:={_yaml(v)}" for n, v in parameters.items())]
        settings = [("-r", name) for name in names]
        settings += [("-p", f"{n}:={_yaml(v)}") for n, v in parameters.items()]
        settings += [("--params-file", str(file)) for file in files]
        return ["--ros-args", *itertools.chain(*settings)]


def _yaml(value):
    return str(value).lower() if isinstance(value, bool) else str(value)


class Program:
    """A program that runs, and what it prints."""

    def __init__(self, command, folder, environment, **options):
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        self._log = folder / "log"
        with self._log.open("w") as log:
            self.process = subprocess.Popen(
                list(map(str, command)),
                cwd=folder,
                env=environment | {"PYTHONUNBUFFERED": "1"},
                stderr=log,
                start_new_session=True,
                **({"stdin": subprocess.DEVNULL, "stdout": log} | options),
            )

    def log(self):
        return re.sub(r"\x1b\[[0-9;]*m", "", self._log.read_text(errors="replace"))

    def kill(self):
        """End it as `kill -9` does."""
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


class Peer(Program):
    """A program that does in ROS what a test asks for; its methods are those of peers/ros*.py."""

    def __init__(self, ros_, environment, folder, more=None):
        peers = CONTRACT / "peers"
        name = f"ros{ros_.environment['ROS_VERSION']}"
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
        # The Python of the tests is not that of ROS, which is found on the path.
        command = ["bash", "-c", f"exec {ros_.python} {peers} {name}"]
        super().__init__(command, folder, environment | (more or {}), **pipes)
        self._answers = {}
        self._numbers = itertools.count()
        threading.Thread(target=self._read, daemon=True).start()
        self.ready()

    def begin(self, method, **arguments):
        """Ask for something without waiting; return a future."""
        number = next(self._numbers)
        self._answers[number] = future = Future()
        request = {"id": number, "method": method, "arguments": arguments}
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        return future

    def __getattr__(self, method):
        if method.startswith("_"):
            raise AttributeError(method)

        def ask(**arguments):
            return self.begin(method, **arguments).result(90)

        return ask

    def _read(self):
        for line in self.process.stdout:
            answer = json.loads(line)
            future = self._answers.pop(answer["id"])
            if "error" in answer:
                future.set_exception(AssertionError(answer["error"]))
            else:
                future.set_result(answer["result"])
        for future in list(self._answers.values()):
            future.set_exception(AssertionError(f"the peer has ended:\n{self.log()}"))


class Node(Program):
    """A process with a node under test, or a container of several, and the trace of its logic."""

    def __init__(self, command, folder, environment, told):
        folder.mkdir(parents=True, exist_ok=True)
        self.trace = folder / "trace"
        self.trace.touch()
        self._events = []  # what was read of the trace so far
        self._read = 0
        self.told = folder / "behaviour"
        self.tell(*told)
        self.noise = NOISE
        self.ended_well = True
        files = {"CONTRACT_TRACE": str(self.trace), "CONTRACT_BEHAVIOUR": str(self.told)}
        super().__init__(command, folder, environment | files)

    def tell(self, *lines):
        """Say what the methods do from now on."""
        new = self.told.with_suffix(".new")
        new.write_text("\n".join(lines) + "\n")
        new.rename(self.told)

    def events(self, method=None, event=None, node=None):
        with self.trace.open("rb") as trace:
            trace.seek(self._read)
            lines, end, _ = trace.read().rpartition(b"\n")
        self._read += len(lines + end)
        self._events += map(json.loads, lines.splitlines())
        return [
            found
            for found in self._events
            if method in (None, found["method"])
            and event in (None, found["event"])
            and node in (None, found["node"])
        ]

    def wait(self, method, event="begin", count=1, timeout=TIMEOUT, node=None):
        """Wait for an event of the logic, and return it."""

        def found():
            events = self.events(method, event, node)
            if len(events) < count and self.process.poll() is not None:
                events = self.events(method, event, node)
                assert len(events) >= count, f"the node has ended: {self.story()}"
            return events[count - 1 :]

        return wait_for(found, lambda: f"no {method} {event}: {self.story()}", timeout)[0]

    def value(self, method, event):
        """Wait for what a command gave, and return it."""
        return self.wait(method, event)["value"]

    def wait_log(self, pattern, timeout=TIMEOUT):
        """Wait until the log has a line, and return it."""

        def found():
            return re.search(f".*(?:{pattern}).*", self.log(), re.IGNORECASE)

        return wait_for(found, lambda: f"no {pattern} in the log: {self.story()}", timeout)[0]

    def send_signal(self, number=signal.SIGINT):
        self.process.send_signal(number)

    def exit(self, timeout=TIMEOUT):
        """Wait for the end and return the exit code."""
        try:
            return self.process.wait(timeout)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"the node does not end: {self.story()}")

    def stop(self, number=signal.SIGINT, timeout=TIMEOUT):
        """End the node by a signal, and return its exit code."""
        self.send_signal(number)
        return self.exit(timeout)

    def methods(self, node=None):
        """Return the names of the five methods as they were called, repeated ones once."""
        names = [e["method"] for e in self.events(event="begin", node=node)]
        return [name for name, _ in itertools.groupby(n for n in names if n in METHODS)]

    def story(self):
        """Return what is needed to understand a failure."""
        events = [f"{e['method']} {e['event']} {e['value']}" for e in self.events()]
        shown = [name for name, _ in itertools.groupby(events)]
        shown = [name for name in shown if name not in IDLE]
        return f"exit code {self.process.poll()}\n{self.log()[-4000:]}\n{shown[-60:]}"

    # What the system says of the process
    def _proc(self, *names):
        return Path("/proc", str(self.process.pid), *names)

    def threads(self):
        """Return the names of the threads."""
        names = []
        for task in self._proc("task").iterdir():
            try:
                names.append((task / "comm").read_text().strip())
            except OSError:
                continue  # it has just ended
        return names

    def thread_ids(self):
        """Return the numbers of the threads, in the order of their start."""
        return sorted(int(task.name) for task in self._proc("task").iterdir())

    def handles_signals(self):
        """Return whether the process handles SIGTERM."""
        line = re.search(r"SigCgt:\s+(\w+)", self._proc("status").read_text())
        return bool(int(line[1], 16) >> (signal.SIGTERM - 1) & 1)

    def files(self):
        return len(list(self._proc("fd").iterdir()))

    def memory(self):
        """Return the resident memory in MB."""
        line = re.search(r"VmRSS:\s+(\d+) kB", self._proc("status").read_text())
        return int(line[1]) / 1024

    def processor_time(self):
        """Return the processor time used so far in s."""
        fields = self._proc("stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def expect(self, *noise):
        """Allow words in the log that a quiet node does not print."""
        self.noise = tuple(word for word in self.noise if word not in noise)

    def check(self):
        """Hold what was traced and logged to what is true of every node."""
        log = re.sub(STRANGERS, "", self.log())
        for word in self.noise:
            assert word not in log, f"{word} in the log: {self.story()}"
        events = self.events()
        for _, logic in itertools.groupby(
            sorted(events, key=lambda e: (e["node"], e["logic"])),
            lambda e: (e["node"], e["logic"]),
        ):
            check_order(list(logic), self.story)
        for name in {e["node"] for e in events}:
            check_thread([e for e in events if e["node"] == name], self.story)


def check_order(events, story):
    """See that one logic object was called in the order of the contract."""
    state = "new"
    calls = 0  # callbacks under way

    def where():
        return f"{method} {what} while {state}: {story()}"

    for event in events:
        method, what = event["method"], event["event"]
        failed = what == "raised" or event["value"] is False
        if method == "reconfigure":
            assert state not in ("new", "configure", "over"), where()
        elif method in METHODS and what == "begin":
            allowed = {
                "configure": ("new",),
                "activate": ("inactive",),
                "update": ("active",),
                "deactivate": ("active",),
                "cleanup": ("inactive",),
            }[method]
            assert state in allowed, where()
            assert method != "deactivate" or calls == 0, f"{calls} callbacks under way: {where()}"
            state = method
        elif method in METHODS and what in ("end", "raised"):
            assert state == method, where()
            states = {
                "configure": "over" if failed else "inactive",
                "activate": "inactive" if failed else "active",
                "update": "active",
                "deactivate": "inactive",
                "cleanup": "over",
            }
            state = states[method]
        elif method in CALLBACKS and what == "begin":
            assert state in ("active", "update"), where()
            calls += 1
        elif what == ("over" if method in GOALS else "end") or what == "raised":
            calls -= 1
    assert state in ("over", "new"), f"the life ended {state}: {story()}"


def check_thread(events, story):
    """See that one thread, which has a name, calls the five methods, and no callback."""
    threads = {(e["thread"], e["id"]) for e in events if e["method"] in METHODS}
    assert len(threads) <= 1, f"{threads}: {story()}"
    assert {name for name, _ in threads} <= {"logic"}, f"{threads}: {story()}"
    for event in events:
        if event["method"] in (*CALLBACKS, "reconfigure"):
            assert (event["thread"], event["id"]) not in threads, f"{event}: {story()}"


class Stage:
    """Where a scenario plays: a namespace, the nodes in it and their peer."""

    def __init__(self, variant, peer, folder):
        self.variant = variant
        self.peer = peer
        self.folder = folder
        self.namespace = f"/n{next(_names)}"
        self._programs = []

    def name(self, name):
        """Return a name in the namespace."""
        return f"{self.namespace}/{name}"

    def start(self, node, *told, remap=None, files=(), **parameters):
        """Start a node alone, as `ros2 run` or `rosrun` does; `told` says what its logic does."""
        command = [
            self.variant.executable(node),
            *self.variant.arguments(self.namespace, parameters, remap, files),
        ]
        return self._run(command, told)

    def active(self, *told, **parameters):
        """Start probe, and wait until it runs."""
        node = self.start("probe", *told, **parameters)
        node.wait("update")
        return node

    def container(self, *told, program="component_container"):
        """Start an empty component container, whose nodes will do what `told` says."""
        prefix = self.variant.ros.run(
            'python3 -c "from ament_index_python import get_package_prefix as find;'
            " print(find('rclcpp_components'))\"",
            "/",
        ).stdout.split()[-1]
        command = [
            Path(prefix, "lib/rclcpp_components", program),
            *self.variant.arguments(self.namespace, {}),
        ]
        return self._run(command, told)

    def _run(self, command, told):
        folder = self.folder / f"node{len(self._programs)}"
        node = Node(command, folder, self.variant.environment, told)
        self._programs.append(node)
        return node

    def another_peer(self, **environment):
        """Start a peer that the scenario may kill."""
        folder = self.folder / f"peer{len(self._programs)}"
        peer = Peer(self.variant.ros, self.variant.environment, folder, environment)
        self._programs.append(peer)
        return peer

    # What is asked of the peer, by names in the namespace
    def hear(self, topic, kind="std_msgs/msg/String", **options):
        """Subscribe to a topic; the function returns what was heard so far."""
        name = self.name(topic)
        self.peer.hear(topic=name, kind=kind, **options)
        return lambda: [data for _, data in self.peer.heard(topic=name)]

    def listen(self, node, ask=lambda: None):
        """Hear what a node says; the function returns all but the word that tried the way."""
        heard = self.hear("say")
        told = node.told.read_text()
        node.tell(told, "update: publish hello", "serve: publish hello")
        wait_for(lambda: ask() or heard(), lambda: f"heard nothing: {node.story()}")
        node.tell(told)
        return lambda: [word for word in heard() if word != "hello"]

    def publish(self, topic, data, kind="std_msgs/msg/String", **options):
        self.peer.publish(topic=self.name(topic), kind=kind, data=data, **options)

    def points(self, seconds, value, *topics, **options):
        """Publish a point to each topic, with a value and a stamp."""
        for topic in topics:
            name = self.name(topic)
            self.peer.publish_point(topic=name, seconds=seconds, value=value, **options)

    def serve(self, service="ask", **options):
        self.peer.serve(service=self.name(service), **options)

    def serve_action(self, action="delegate", **options):
        self.peer.serve_action(action=self.name(action), **options)
        return lambda: [tuple(event) for event in self.peer.served_log(name=self.name(action))]

    def call(self, service="serve", **options):
        return self.peer.begin("call", service=self.name(service), **options)

    def goal(self, action, order):
        return self.peer.goal(action=self.name(action), order=order)

    def result(self, goal, **options):
        return self.peer.result(number=goal, **options)

    def transition(self, *transitions, node="probe"):
        for transition in transitions:
            if not self.peer.change_state(node=self.name(node), transition=transition):
                return False
        return True

    def state(self, node="probe"):
        return self.peer.state(node=self.name(node))

    def close(self, passed):
        """End what runs; if the scenario has passed, see that all nodes end well."""
        try:
            nodes = [item for item in self._programs if isinstance(item, Node)]
            for node in nodes if passed else ():
                if node.process.poll() is None:
                    code = node.stop()
                    assert not node.ended_well or code == 0, f"exit code: {node.story()}"
                if node.ended_well:
                    node.check()
        finally:
            for item in self._programs:
                item.kill()
            self.peer.leave(namespace=self.namespace)
