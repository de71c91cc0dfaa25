"""Where ROS is on this machine, and how to build and run packages in it."""

import atexit
import contextlib
import functools
import os
import random
import re
import shlex
import shutil
import signal
import socket
import socketserver
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from xmlrpc.client import ServerProxy
from xmlrpc.server import SimpleXMLRPCServer

PEERS = Path(__file__).parents[1] / "ros/peers"
WHEELS = Path(__file__).parents[2] / ".venv" / "ros2"
NO_ROS1 = "ROS 1 (Debian's packages) is not installed"
NO_ROS2 = "ROS 2 (sourced, or its wheels in .venv/ros2) is not there"
# The environment before the tests change it: a ROS 2 may be sourced in it. The Makefile keeps
# the modules of that ROS out of pytest, which has a Python of its own.
SHELL = os.environ | {"PYTHONPATH": os.environ.get("ROS_PYTHONPATH", "")}
GCC = {"CXX": "g++", "CXXFLAGS": "--param ggc-min-heapsize=500000"}
"""The compiler of most users; it needs less time where it frees less memory."""
FASTEST = {"CXX": "clang++", "CXXFLAGS": ""} if shutil.which("clang++") else GCC
"""For nodes in ROS 1: clang 14 needs two thirds of the time of g++ 12."""
TF = r" *<(listener|broadcaster) [^\n]*\n"
SYNCHRONIZER = r" *<synchronizer .*?</synchronizer>\n"
PATIENCE = 120  # s, which tests of packages give a node that shares the machine with others


@dataclass(frozen=True)
class Ros:
    """One ROS: how to set it up in a shell, and its environment."""

    distro: str
    setup: str
    environment: dict[str, str]
    workspace_setup: str
    build_command: str
    test_command: str
    result_command: str
    python: str
    failed_option: str = ""
    """What the command of tests takes to run those alone that have failed, if it can."""

    def command(self, command, workspace=None):
        """Return the shell command that sets ROS up and then becomes `command`."""
        steps = [self.setup]
        if workspace and (workspace / self.workspace_setup).exists():
            steps.append(f". {shlex.quote(str(workspace / self.workspace_setup))}")
        return ["bash", "-c", " && ".join([*filter(None, steps), f"exec {command}"])]

    def run(self, command, cwd, workspace=None, check=True, timeout=600):
        """Run a command to its end; what it printed is in the result's stdout."""
        result = subprocess.run(
            self.command(command, workspace),
            cwd=cwd,
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=timeout,
        )
        assert not check or result.returncode == 0, f"{command}:\n{result.stdout}"
        return result

    @contextlib.contextmanager
    def running(self, command, workspace=None, cwd=None, ends_well=True):
        """Run a command in the background; interrupt it at the end, and see that it ends well.

        Gives a function that returns what the command has printed so far. What need not end well
        is killed.
        """
        log = Path(self.environment["ROS_HOME"]) / f"{random.getrandbits(64):x}.log"
        with log.open("w") as output:
            process = subprocess.Popen(
                self.command(command, workspace),
                cwd=cwd,
                env=self.environment,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        try:
            yield log.read_text
            assert process.poll() is None, f"{command} ended by itself:\n{log.read_text()}"
            if not ends_well:
                return
            os.killpg(process.pid, signal.SIGINT)
            code = process.wait(20)
            assert code in (0, -signal.SIGINT, 130), f"{command}: {code}\n{log.read_text()}"
        except BaseException:
            print(f"--- {command}\n{log.read_text()}", file=sys.stderr)
            raise
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)

    def build(self, workspace, underlay=None):
        """Build the packages of a workspace and return what the build printed."""
        return self.run(self.build_command, workspace, underlay, timeout=3600).stdout

    def test(self, workspace):
        """Run the tests of the packages of a workspace and return their results.

        Where one fails they run once more, with a warning that says which: now and then, on a
        busy machine, a server is not discovered, however long a test waits. ROS 2's own CI runs
        such tests up to three times.
        """
        patient = f"env TEST_TIMEOUT={PATIENCE} {self.test_command}"
        self.run(patient, workspace, workspace, timeout=3600)
        found = self.run(self.result_command, workspace, workspace, check=False)
        if found.returncode:
            warnings.warn(f"tested once more:\n{found.stdout}", stacklevel=2)
            self.run(f"{patient} {self.failed_option}", workspace, workspace, timeout=3600)
            found = self.run(self.result_command, workspace, workspace, check=False)
        return found.stdout

    def talk(self, workspace, example, *options):
        """Talk to the running nodes of an example with its program in peers/."""
        peer = f"ros{self.environment['ROS_VERSION']}"
        command = shlex.join([self.python, str(PEERS / f"{example}.py"), peer, *options])
        return self.run(command, workspace, workspace, timeout=180)


def _compiler():
    """Return settings for the compiler.

    Two jobs, for other tests run beside; catkin_make alone would wait for a machine without load.
    ccache compiles once what several tests compile alike in folders of the same depth.
    """
    settings = {"ROS_PARALLEL_JOBS": "-j2", **GCC}
    if shutil.which("ccache"):
        settings |= {
            "CMAKE_C_COMPILER_LAUNCHER": "ccache",
            "CMAKE_CXX_COMPILER_LAUNCHER": "ccache",
            "CCACHE_DIR": str(Path(__file__).parents[2] / "build/ccache"),
            "CCACHE_MAXSIZE": "1G",
            "CCACHE_BASEDIR": tempfile.gettempdir(),
            "CCACHE_DEPEND": "1",
            "CCACHE_SLOPPINESS": "include_file_ctime,include_file_mtime",
        }
    return settings


def _linker(environment):
    """Return settings for the linker, where ROS 2 and Debian's ROS 1 are both installed.

    GNU ld 2.40 takes libraries that need libc before others: the message_filters of ROS 1.
    """
    folders = environment.get("LD_LIBRARY_PATH", "").split(os.pathsep)
    found = [Path(folder, "libmessage_filters.so") for folder in filter(None, folders)]
    flags = [environment.get("LDFLAGS", ""), *(str(file) for file in found if file.exists())][:2]
    return {"LDFLAGS": " ".join(flags)} if len(flags) > 1 else {}


def _base(home):
    keep = ("LANG", "LC_ALL", "TMPDIR", "TERM")
    environment = {name: os.environ[name] for name in keep if name in os.environ}
    environment |= {"HOME": str(home), "ROS_HOME": str(home), "ROS_LOG_DIR": str(home)}
    return environment | _compiler()


def _home():
    home = Path(tempfile.mkdtemp(prefix="ros-"))
    atexit.register(shutil.rmtree, home, ignore_errors=True)
    return home


def ros1():
    """Return ROS 1 as Debian has it, with a master address of its own, or None."""
    if not all(shutil.which(word, path="/usr/bin") for word in ("roscore", "catkin_make")):
        return None
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    environment = (
        _base(_home())
        | FASTEST
        | {
            "PATH": "/usr/bin:/bin",
            "ROS_IP": "127.0.0.1",
            "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
            "ROS_VERSION": "1",
        }
    )
    return Ros(
        distro="noetic",
        setup="",
        environment=environment,
        workspace_setup="devel/setup.bash",
        build_command="catkin_make",
        test_command="catkin_make run_tests -j2",
        result_command="catkin_test_results --verbose",
        python="/usr/bin/python3",
    )


def ros2():
    """Return ROS 2, sourced or of the wheels, with a domain of its own, or None."""
    setup = _ros2_setup()
    if setup is None:
        return None
    home = _home()
    environment = _base(home) | {"PATH": SHELL["PATH"]} if setup else SHELL | _compiler()
    environment |= {} if setup else _linker(SHELL)
    environment |= {
        "ROS_HOME": str(home),
        "ROS_LOG_DIR": str(home),
        "ROS_DOMAIN_ID": str(_free_domain()),
        "ROS_VERSION": "2",
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET",
        "FASTDDS_DEFAULT_PROFILES_FILE": str(Path(__file__).with_name("loopback.xml")),
        "PYTHONUNBUFFERED": "1",
        "AMENT_CPPCHECK_ALLOW_SLOW_VERSIONS": "1",  # Debian's is one of them
    }
    return Ros(
        distro="kilted" if setup else SHELL["ROS_DISTRO"],
        setup=setup,
        environment=environment,
        workspace_setup="install/setup.bash",
        build_command="colcon build",
        test_command="colcon test --event-handlers console_cohesion+",
        result_command="colcon test-result --all --verbose",
        python="python3",
        failed_option="--packages-select-test-failures",
    )


@functools.cache
def _ros2_setup():
    """Return the shell command that sets ROS 2 up: none where it is sourced already."""
    wheels = (
        f"export VIRTUAL_ENV={WHEELS} PATH={WHEELS}/bin:$PATH"
        f" AMENT_PREFIX_PATH={WHEELS} CMAKE_PREFIX_PATH={WHEELS}"
    )
    for setup in ("", wheels) if "ROS_DISTRO" in SHELL else (wheels,):
        command = f"{setup or 'true'} && python3 -c 'import rclpy' && command -v colcon"
        if subprocess.run(["bash", "-c", command], env=SHELL, capture_output=True).returncode == 0:
            return setup
    return None


def has(ros, module):
    """Say whether the Python of a ROS has a module."""
    result = ros.run(f"{ros.python} -c 'import {module}'", "/", check=False)
    return result.returncode == 0


def has_package(ros, name):
    """Say whether a ROS 2 has a package."""
    code = f"from ament_index_python import get_package_prefix as find; find({name!r})"
    return ros.run(f'{ros.python} -c "{code}"', "/", check=False).returncode == 0


def fitting(ros, spec):
    """Return a spec without the kinds that need a module which the Python of a ROS lacks."""
    for module, kinds in {"tf2_ros": TF, "message_filters": SYNCHRONIZER}.items():
        spec = spec if has(ros, module) else re.sub(kinds, "", spec, flags=re.S)
    return spec


def wait_for(text, look):
    """Look until a text is there, and return all that was seen."""
    end = time.monotonic() + 30
    while not re.search(text, seen := look()):
        assert time.monotonic() < end, f"no {text} in {seen}"
        time.sleep(0.2)
    return seen


def _free_domain():
    """Return a domain whose first port nobody uses (DDS: 7400 + 250 * domain + 10).

    It is unused until its first node starts: no other process of the run may choose the same.
    """
    first = 1 + int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))
    domains = range(first, 100, int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", 1)))
    for domain in random.sample(domains, len(domains)):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as test:
            try:
                test.bind(("127.0.0.1", 7400 + 250 * domain + 10))
            except OSError:
                continue
            return domain
    raise RuntimeError("no free ROS domain")


@contextlib.contextmanager
def master(ros, program="roscore"):
    """Run a ROS 1 master at the address of the environment: roscore, or rosmaster alone.

    rosmaster may wait long for the connections of nodes that were killed.
    """
    port = int(ros.environment["ROS_MASTER_URI"].rpartition(":")[2])
    options = "--core" if program == "rosmaster" else ""
    with ros.running(f"{program} {options} -p {port}", ends_well=program == "roscore"):
        end = time.monotonic() + 30
        while not _is_open(port):
            assert time.monotonic() < end, "the ROS 1 master does not start"
            time.sleep(0.1)
        yield


@dataclass(frozen=True)
class Held:
    """A request that a relay holds back."""

    _came: threading.Event = field(default_factory=threading.Event)
    _released: threading.Event = field(default_factory=threading.Event)

    def wait(self):
        """Wait until it has come."""
        assert self._came.wait(30), "the request does not come"

    def release(self):
        self._released.set()

    def pass_on(self):
        self._came.set()
        self._released.wait()


class Relay(socketserver.ThreadingMixIn, SimpleXMLRPCServer):
    """A ROS 1 master that passes requests on to another, and holds back those it is told to."""

    daemon_threads = True

    def __init__(self, master):
        super().__init__(("127.0.0.1", 0), logRequests=False)
        self.address = f"http://127.0.0.1:{self.server_address[1]}"
        self._master = master
        self._held = {}

    def hold(self, *request):
        """Hold back the requests of a method of the master for a name, or all if none is given."""
        return self._held.setdefault(request, Held())

    def _dispatch(self, method, params):
        held = self._held.get((method, *params[1:2])) or self._held.get(())
        if held:
            held.pass_on()
        return getattr(ServerProxy(self._master), method)(*params)

    @contextlib.contextmanager
    def running(self):
        threading.Thread(target=self.serve_forever, daemon=True).start()
        try:
            yield self
        finally:
            for held in self._held.values():
                held.release()
            self.shutdown()
            self.server_close()


def _is_open(port):
    with socket.socket() as client:
        return client.connect_ex(("127.0.0.1", port)) == 0


@contextlib.contextmanager
def nodes(ros2, workspace, package, *names):
    """Run nodes of a package with the parameter files its launch file names."""
    install = workspace / "install" / package
    with contextlib.ExitStack() as stack:
        yield [
            stack.enter_context(
                ros2.running(
                    f"{install}/lib/{package}/{name} --ros-args"
                    f" --params-file {install}/share/{package}/config/{name}.yaml",
                    workspace,
                )
            )
            for name in names
        ]
