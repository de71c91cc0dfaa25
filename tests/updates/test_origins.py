"""A rename exchanges the package's own names; where a name comes from decides, not its look."""

import re
from dataclasses import replace

import pytest

from hooks.merge import languages
from hooks.merge.languages import CMAKE, MARKDOWN, PYTHON
from hooks.merge.renaming import Renaming, _as_made, _classes, _heads
from hooks.merge.scopes import declared
from hooks.merge.tokens import exchange, words
from hooks.merge.uses import uses
from hooks.merge.versions import Versions
from support.arm import SPEC
from support.laboratory.trials import tree_of
from support.repository import commit, git

KINDS = {
    "directSubscriber": "say",
    "subscriber": "goal",
    "serviceServer": "load",
    "dynParameter": "gain",
    "publisher": "pose",
}
NAMES = {"say": "speak", "goal": "target", "load": "fetch", "gain": "factor", "pose": "place"}
ITEMS = [{"kind": kind, "name": name, "type": 0, "text": ""} for kind, name in KINDS.items()]
NEW_ITEMS = [{**item, "name": NAMES[item["name"]], "was": item["name"]} for item in ITEMS]
OLD = {"name": "reach", "frequency": 10, "items": ITEMS}
NEW = {"name": "grasp", "was": "reach", "frequency": 10, "items": NEW_ITEMS}


OWN = {"python_model": "lab/tools.py", "cpp_model": "src/tools.cpp"}


@pytest.fixture(scope="module")
def pairs(laboratory):
    specs = [{"description": "Arms", "nodes": [node]} for node in (OLD, NEW)]
    return {
        model: laboratory.pair(*specs, model, ("kilted", "kilted"), "1.0.0", own=[path])
        for model, path in OWN.items()
    }


FOREIGN = [
    "from kinematics import ReachConfig\n\nuse(ReachConfig(gain=1))\n",
    "from serial_lib import (\n    A,\n    SayMessage as B,\n    SayMessage,\n)\n\nSayMessage()\n",
    "from vendor import *\n\nuse(ReachConfig)\n",
    "import serial_lib\n\nserial_lib.SayMessage().in_goal\n",
    "import vendor.lab.reach_interface as r\n\nr.ReachData()\n",
    "from vendor import reach_interface\n\nreach_interface.ReachData()\n",
    "import reach_interface\n\nreach_interface.ReachData()\n",
    "def turn(msg):\n    return msg.in_goal + msg.data.in_goal\n",
    "class ReachData:\n    in_goal = 1\n\n\nReachData().in_goal\n",
    "def receive_say(in_goal):\n    return in_goal\n",
    "try:\n    from vendor import ReachData\nexcept ImportError:\n    ReachData = None\n",
    "import vendor as data\n\ndata.in_goal\n",
    "in_goal = 3\nprint(f'{in_goal} {x.in_goal}')\n",
    "move(in_goal=3)\n",
    "from vendor import A\n\nA(gain=1)\nmove(\n    data, gain=ReachConfig(gain=2))\n",
    "def f(data):\n    return f'{{data.in_goal}} {{{1}}}'\n",
    "from lab.pid import PidConfig\n\n\ndef f(config: PidConfig):\n    return config.gain\n",
    "def f(x: int, *, data: 'vendor.Data | None' = None):\n    return data.in_goal\n",
    "from lab.pid import PidConfig\n\nconfig = PidConfig(gain=3)\nprint(config.gain)\n",
    "import yaml\n\ndata = yaml.safe_load(open('x'))\nprint(data.in_goal)\n",
    "def f():\n    config: Pid = make()\n    return [config.gain for _ in x]\n",
    "class A:\n    def __init__(self):\n        self._config = Pid()\n\n    def f(self):\n"
    "        return self._config.gain\n",
    "@dataclass\nclass A:\n    config: Pid\n\n    def f(self):\n        return self.config.gain\n",
    "if config := Pid(1):\n    config.gain\n",
    "from vendor.harness import run_cycle\n\ndata = run_cycle(a)\ndata.in_goal\n",
    "@pytest.fixture\ndef impl():\n    return Pid(1)\n\n\ndef f(impl):\n    impl.in_goal\n",
    "def impl():\n    return use()\n\n\ndef f(impl):\n    impl.in_goal\n",
]
OURS = {
    "from lab.reach_interface import ReachConfig\n\nReachConfig(gain=1)\n": (
        "from lab.grasp_interface import GraspConfig\n\nGraspConfig(factor=1)\n"
    ),
    "from lab.reach_interface import (  # a\n    A,\n    ReachData as B,\n)\n\nB(in_goal=1)\n": (
        "from lab.grasp_interface import (  # a\n    A,\n    GraspData as B,\n)\n\nB(in_goal=1)\n"
    ),
    "from .reach_interface import ReachData\n\nReachData(in_goal = 1).x\n": (
        "from .grasp_interface import GraspData\n\nGraspData(in_target = 1).x\n"
    ),
    "from . import reach_impl, reach_interface\n\nx = reach_interface.ReachData()\nx.in_goal\n": (
        "from . import grasp_impl, grasp_interface\n\n"
        "x = grasp_interface.GraspData()\nx.in_target\n"
    ),
    "import lab.reach_interface as r\n\n\ndef f(d: r.ReachData):\n    d.in_goal\n": (
        "import lab.grasp_interface as r\n\n\ndef f(d: r.GraspData):\n    d.in_target\n"
    ),
    "import lab.reach_interface\n\nlab.reach_interface.ReachData\n": (
        "import lab.grasp_interface\n\nlab.grasp_interface.GraspData\n"
    ),
    "import lab.reach_interface as r, vendor\n": "import lab.grasp_interface as r, vendor\n",
    "def f(data, config):\n    return f'{data.in_goal} {config.gain}'\n": (
        "def f(data, config):\n    return f'{data.in_target} {config.factor}'\n"
    ),
    "class A:\n    def f(self):\n        self._data.in_goal = self.msg.in_goal\n": (
        "class A:\n    def f(self):\n        self._data.in_target = self.msg.in_goal\n"
    ),
    "from lab.reach_impl import ReachImpl\n\nimpl = ReachImpl()\nimpl.receive_say(1)\n": (
        "from lab.grasp_impl import GraspImpl\n\nimpl = GraspImpl()\nimpl.receive_speak(1)\n"
    ),
    "from .reach_impl import ReachImpl\n\nimpl = ReachImpl()\nimpl.gain = impl.in_goal\n"
    "a = impl\na.gain + a.receive_say(1)\n": (
        "from .grasp_impl import GraspImpl\n\nimpl = GraspImpl()\nimpl.gain = impl.in_goal\n"
        "a = impl\na.gain + a.receive_speak(1)\n"
    ),
    "from .reach_impl import ReachImpl\n\n\nclass A(ReachImpl):\n    def receive_say(self, m):\n"
    "        super().receive_say(m)\n        self.receive_say(self.gain, self.in_goal)\n"
    "        use(receive_say, m.receive_say, x().receive_say)\n\n\nA().receive_say(1)\n"
    "def f(a: A, b):\n    a.receive_say(b.receive_say(a.gain))\n": (
        "from .grasp_impl import GraspImpl\n\n\nclass A(GraspImpl):\n"
        "    def receive_speak(self, m):\n        super().receive_speak(m)\n"
        "        self.receive_speak(self.gain, self.in_goal)\n"
        "        use(receive_say, m.receive_say, x().receive_say)\n\n\nA().receive_say(1)\n"
        "def f(a: A, b):\n    a.receive_speak(b.receive_say(a.gain))\n"
    ),
    "from v import V\nfrom .reach_impl import ReachImpl\n\n\nclass T:\n"
    "    class A(V, ReachImpl):\n        def receive_say(self):\n"
    "            super().receive_say(self.receive_say)\n\n"
    "    def receive_say(self):\n        self.receive_say(super().receive_say)\n": (
        "from v import V\nfrom .grasp_impl import GraspImpl\n\n\nclass T:\n"
        "    class A(V, GraspImpl):\n        def receive_speak(self):\n"
        "            super().receive_say(self.receive_speak)\n\n"
        "    def receive_say(self):\n        self.receive_say(super().receive_say)\n"
    ),
    "def f(d: 'ReachData'):\n    d.in_goal\n": "def f(d: 'ReachData'):\n    d.in_target\n",
    "from lab import reach_ros\n\nreach_ros.main()\n": (
        "from lab import grasp_ros\n\ngrasp_ros.main()\n"
    ),
    "def f(data):\n    return f'{data.in_goal:{data.in_goal}} {{{data.in_goal}}}'\n": (
        "def f(data):\n    return f'{data.in_target:{data.in_target}} {{{data.in_target}}}'\n"
    ),
    "from .reach_interface import ReachConfig\n\nuse(ReachConfig(\n    gain=1),\n  gain=2)\n": (
        "from .grasp_interface import GraspConfig\n\nuse(GraspConfig(\n    factor=1),\n  gain=2)\n"
    ),
    "from . import reach_interface as r\n\nmatch c:\n  case r.ReachConfig(gain=0):\n    d\n": (
        "from . import grasp_interface as r\n\nmatch c:\n  case r.GraspConfig(factor=0):\n    d\n"
    ),
    "config.gain\ndef f(config: Pid): return replace(config, gain=1)\n": (
        "config.factor\ndef f(config: Pid): return replace(config, gain=1)\n"
    ),
    "def f(a: 'ReachImpl'):\n    run_cycle(a, in_goal=low)\n": (
        "def f(a: 'ReachImpl'):\n    run_cycle(a, in_target=low)\n"
    ),
    "def f(a):\n    b = run_cycle(a)\n    b.in_goal + run_cycle(a, None).in_goal\n": (
        "def f(a):\n    b = run_cycle(a)\n    b.in_target + run_cycle(a, None).in_target\n"
    ),
    "from support.harness import run_cycle\n\n\ndef f(a: 'ReachImpl'):\n"
    "    data = run_cycle(a, in_goal=1)\n    data.in_goal + run_cycle(a).in_goal\n": (
        "from support.harness import run_cycle\n\n\ndef f(a: 'ReachImpl'):\n"
        "    data = run_cycle(a, in_target=1)\n    data.in_target + run_cycle(a).in_target\n"
    ),
    "from support.harness import fake\nfrom lab import reach_interface as r\n\n"
    "a = fake(r.ReachData)\na.in_goal\n": (
        "from support.harness import fake\nfrom lab import grasp_interface as r\n\n"
        "a = fake(r.GraspData)\na.in_target\n"
    ),
    "import lab.reach_impl as r\n\n\n@pytest.fixture\ndef a():\n    return r.ReachImpl()\n\n\n"
    "@fixture()\nasync def b():\n    yield r.ReachImpl(1)\n\n\ndef test(a, b):\n"
    "    a.receive_say(b.receive_say)\n": (
        "import lab.grasp_impl as r\n\n\n@pytest.fixture\ndef a():\n    return r.GraspImpl()\n\n\n"
        "@fixture()\nasync def b():\n    yield r.GraspImpl(1)\n\n\ndef test(a, b):\n"
        "    a.receive_speak(b.receive_speak)\n"
    ),
    "low = replace(config, gain=config.gain)\n": ("low = replace(config, factor=config.factor)\n"),
    "def f(config: Pid):\n    config.gain\n\n\ndef g(config):\n    config.gain\n": (
        "def f(config: Pid):\n    config.gain\n\n\ndef g(config):\n    config.factor\n"
    ),
    "config = Pid()\n\n\ndef f(config):\n    config.gain\n": (
        "config = Pid()\n\n\ndef f(config):\n    config.factor\n"
    ),
    "def f(config: Optional[Any], data: T):\n    config.gain, data.in_goal\n": (
        "def f(config: Optional[Any], data: T):\n    config.factor, data.in_target\n"
    ),
    "def f(config):\n    a = config.gain\n    config = Pid(config)\n    config.gain\n": (
        "def f(config):\n    a = config.factor\n    config = Pid(config)\n    config.gain\n"
    ),
    "from .reach_interface import ReachConfig as C\n\n\ndef f(config: C):\n    config.gain\n": (
        "from .grasp_interface import GraspConfig as C\n\n\ndef f(config: C):\n    config.factor\n"
    ),
    "from .reach_interface import ReachConfig\n\n\nclass A(ReachConfig):\n    pass\n\n\n"
    "def f(config: A):\n    config.gain\n": (
        "from .grasp_interface import GraspConfig\n\n\nclass A(GraspConfig):\n    pass\n\n\n"
        "def f(config: A):\n    config.factor\n"
    ),
    "from .reach_interface import ReachConfig\n\nC: TypeAlias = ReachConfig | None\n"
    "D = Optional[ReachConfig]\n\n\ndef f(config: C, data: vendor.D):\n"
    "    config.gain, data.in_goal\n\n\ndef g(config: D, e: D):\n    config.gain, e.gain\n": (
        "from .grasp_interface import GraspConfig\n\nC: TypeAlias = GraspConfig | None\n"
        "D = Optional[GraspConfig]\n\n\ndef f(config: C, data: vendor.D):\n"
        "    config.factor, data.in_goal\n\n\ndef g(config: D, e: D):\n"
        "    config.factor, e.factor\n"
    ),
    "config = fetch(config)\nconfig.gain\n": "config = fetch(config)\nconfig.factor\n",
    "from .reach_interface import ReachData\n\n__all__ = [\n    'f', \"ReachData\",\n]\n"
    "__all__ += ('ReachData', ReachData)\n": (
        "from .grasp_interface import GraspData\n\n__all__ = [\n    'f', \"GraspData\",\n]\n"
        "__all__ += ('GraspData', GraspData)\n"
    ),
    "from .reach_interface import InGoal\n\n\ndef f(a: 'InGoal' = \"InGoal\") -> 'list[InGoal]':\n"
    "    b: '''InGoal''' = \"InGoal\"\n    c: Literal['InGoal'] = None\n    'InGoal'\n": (
        "from .grasp_interface import InTarget\n\n\n"
        "def f(a: 'InTarget' = \"InGoal\") -> 'list[InTarget]':\n"
        "    b: '''InTarget''' = \"InGoal\"\n    c: Literal['InGoal'] = None\n    'InGoal'\n"
    ),
}
CPP_FOREIGN = [
    "#include <vendor/reach_interface.hpp>\nvendor::ReachConfig a;\nReachConfig b;\n",
    "#include <vendor/a.hpp>\nnamespace test\n{\nReachConfig a;\n}\n",
    "#include <ros/ros.h>\nReachConfig a;\nint b = ros::use(a.in_goal);\n",
    '#include "vendor/lab/reach_interface.hpp"\n',
    '#include "../vendor/reach_interface.hpp"\n',
    '#include "lab/mine.hpp"\nvendor::SayMessage a;\nint b = a.in_goal;\n',
    "struct Own\n{\n  int in_goal;\n};\nint f(const Own & msg) {return msg.in_goal;}\n",
    "#include <lab/mine.hpp>\nusing vendor::ReachData;\nReachData a;\nint b = a.in_goal;\n",
    "#include <lab/mine.hpp>\nusing namespace vendor;\nReachData a;\n",
    "ReachData a;\n",
    "#include <lab/mine.hpp>\nlab::vendor::ReachData a;\n",
    "#include <lab/mine.hpp>\nstruct A\n{\n  int in_goal;\n};\nstruct B : A\n{\n};\n",
    "#include <lab/mine.hpp>\nint a = f() -> in_goal;\n",
    "namespace vendor {ReachData a;}\nnamespace b = vendor;\nb::ReachData c;\n",
    "namespace lab {\nstd::function<int(int)> A::f(int a = b::c(1))\n{\n  return in_goal;\n}\n}\n",
    "namespace lab {\nenum Kind {in_goal, kTwo};\nstruct C : B<int>\n{\n  int in_goal;\n};\n}\n",
    "namespace lab\n{\nint f(const PidConfig & config)\n{\n  return config.gain;\n}\n}\n",
    "namespace lab {\nvoid f() {PidConfig config; config.gain = 2;}\n}\n",
    "namespace lab {\nvoid f() {\n  auto data = Data{};\n  data.in_goal;\n}\n}\n",
    "void f(vendor::data_t * data) {data->in_goal;}\n",
    "void f(std::shared_ptr<const vendor::Data> data) {data->in_goal;}\n",
    *(
        '#include "lab/loader.hpp"\nnamespace lab\n{\nvoid Loader::serve_load() {}\n'
        f"void Loader::all() {after}\n{{\n  serve_load();\n}}\n}}\n"
        for after in ("", "const", "noexcept", "&", "try")
    ),
    "class A\n{\n  int f() {return config_.gain;}\n\n  Pid config_;\n};\n",
    "void f() {\n  vendor::Pid config(1.0);\n  config.gain;\n}\n",
]
CPP_OURS = {
    '#include "lab/reach_interface.hpp"\nint f(const lab::ReachData & d) {d.in_goal;}\n': (
        '#include "lab/grasp_interface.hpp"\nint f(const lab::GraspData & d) {d.in_target;}\n'
    ),
    '#include "lab/reach_impl.hpp"\nusing lab::ReachImpl;\nReachImpl i;\ni.receive_say(m);\n': (
        '#include "lab/grasp_impl.hpp"\nusing lab::GraspImpl;\nGraspImpl i;\ni.receive_speak(m);\n'
    ),
    "#include <lab/reach_impl.hpp>\nauto i = make<lab::ReachImpl>();\ni->receive_say(m);\n": (
        "#include <lab/grasp_impl.hpp>\nauto i = make<lab::GraspImpl>();\ni->receive_speak(m);\n"
    ),
    "#include <lab/mine.hpp>\nauto a = &lab::ReachData::in_goal;\n": (
        "#include <lab/mine.hpp>\nauto a = &lab::GraspData::in_target;\n"
    ),
    "#include <lab/mine.hpp>\nstruct A : lab::ReachData\n{\n  int b = in_goal;\n};\n": (
        "#include <lab/mine.hpp>\nstruct A : lab::GraspData\n{\n  int b = in_target;\n};\n"
    ),
    "namespace lab {\nclass ReachImpl\n{\n  void mine() {receive_say(1);}\n};\n}\n": (
        "namespace lab {\nclass GraspImpl\n{\n  void mine() {receive_speak(1);}\n};\n}\n"
    ),
    "namespace lab {\nclass LAB_API ReachImpl final {void mine() {receive_say(1);}};\n}\n": (
        "namespace lab {\nclass LAB_API GraspImpl final {void mine() {receive_speak(1);}};\n}\n"
    ),
    "#include <lab/mine.hpp>\nvoid lab::Loader::all()\n{\n}\nauto b = in_goal;\n": (
        "#include <lab/mine.hpp>\nvoid lab::Loader::all()\n{\n}\nauto b = in_target;\n"
    ),
    "namespace lab {\nvoid ReachImpl::f() {if (Loader::has()) {receive_say(1);}}\n}\n": (
        "namespace lab {\nvoid GraspImpl::f() {if (Loader::has()) {receive_speak(1);}}\n}\n"
    ),
    "#include <lab/mine.hpp>\nstruct A\n{\n  int in_goal;\n};\nauto b = in_goal;\n": (
        "#include <lab/mine.hpp>\nstruct A\n{\n  int in_goal;\n};\nauto b = in_target;\n"
    ),
    '#include "reach_interface.hpp"\n': '#include "grasp_interface.hpp"\n',
    '#include "./reach_interface.hpp"\n': '#include "./grasp_interface.hpp"\n',
    '#include "../lab/reach_interface.hpp"\n': '#include "../lab/grasp_interface.hpp"\n',
    "namespace lab {\nauto f() const -> reach_types::InGoal;\nauto g() -> ReachData;\n}\n": (
        "namespace lab {\nauto f() const -> grasp_types::InTarget;\nauto g() -> GraspData;\n}\n"
    ),
    "#include <lab/mine.hpp>\nauto f() -> lab::reach_types::InGoal;\n": (
        "#include <lab/mine.hpp>\nauto f() -> lab::grasp_types::InTarget;\n"
    ),
    "#include <lab/mine.hpp>\nstruct A {reach_types::InGoal in_goal;};\n": (
        "#include <lab/mine.hpp>\nstruct A {grasp_types::InTarget in_goal;};\n"
    ),
    "#include <lab/mine.hpp>\nusing namespace std;\nReachData a;\n": (
        "#include <lab/mine.hpp>\nusing namespace std;\nGraspData a;\n"
    ),
    '#include "../mine.hpp"\nlab::reach_types::InGoal a;\n': (
        '#include "../mine.hpp"\nlab::grasp_types::InTarget a;\n'
    ),
    "namespace lab {struct ReachData;}\n": "namespace lab {struct GraspData;}\n",
    "namespace a = lab::reach_types;\na::InGoal b;\n": (
        "namespace a = lab::grasp_types;\na::InTarget b;\n"
    ),
    "namespace lab {\nusing reach_types::InGoal;\nnamespace t = reach_types;\nInGoal a;\n"
    "t::InGoal b;\n}\n": (
        "namespace lab {\nusing grasp_types::InTarget;\nnamespace t = grasp_types;\nInTarget a;\n"
        "t::InTarget b;\n}\n"
    ),
    "namespace lab {\nusing InGoal = reach_types::InGoal;\nInGoal a;\n}\nlab::InGoal b;\n": (
        "namespace lab {\nusing InGoal = grasp_types::InTarget;\nInGoal a;\n}\nlab::InGoal b;\n"
    ),
    "#include <lab/mine.hpp>\nnamespace a = ::lab;\na::ReachData b;\n": (
        "#include <lab/mine.hpp>\nnamespace a = ::lab;\na::GraspData b;\n"
    ),
    "lab::reach_types::InGoal a;\n": "lab::grasp_types::InTarget a;\n",
    "lab::ReachHarness h;\nh.data.in_goal = h.config.gain;\nh.impl.receive_say(1);\n": (
        "lab::GraspHarness h;\nh.data.in_target = h.config.factor;\nh.impl.receive_speak(1);\n"
    ),
    "lab::ReachHarness h;\nh.in_a(f(m)).in_goal(m).run_cycle().in_goal;\n": (
        "lab::GraspHarness h;\nh.in_a(f(m)).in_target(m).run_cycle().in_target;\n"
    ),
    "lab::ReachHarness h;\nh.mine().in_goal + g.run_cycle().in_goal + (h).in_goal;\n": (
        "lab::GraspHarness h;\nh.mine().in_goal + g.run_cycle().in_goal + (h).in_goal;\n"
    ),
    "lab::ReachHarness h;\nauto & g = h;\ng.data.in_goal;\n": (
        "lab::GraspHarness h;\nauto & g = h;\ng.data.in_target;\n"
    ),
    "lab::ReachHarness h;\nh.impl.gain = h.config.gain;\nlab::ReachImpl i;\ni.gain = 1;\n": (
        "lab::GraspHarness h;\nh.impl.gain = h.config.factor;\nlab::GraspImpl i;\ni.gain = 1;\n"
    ),
    "lab::ReachConfig a{.gain = 1};\n": "lab::GraspConfig a{.factor = 1};\n",
    "void f() {data_  // mine\n  .in_goal;}\n": "void f() {data_  // mine\n  .in_target;}\n",
    "namespace lab {\nvoid f(Pid & config) {config.gain;}\nvoid g() {config.gain;}\n}\n": (
        "namespace lab {\nvoid f(Pid & config) {config.gain;}\nvoid g() {config.factor;}\n}\n"
    ),
    "template<class Any>\nvoid f(Any & config, T data) {config.gain, data.in_goal;}\n": (
        "template<class Any>\nvoid f(Any & config, T data) {config.factor, data.in_target;}\n"
    ),
    "void f() {return config; g(a * config, x & data); config.gain;}\n": (
        "void f() {return config; g(a * config, x & data); config.factor;}\n"
    ),
    "namespace lab\n{\nvoid ReachImpl::mine() {receive_say(1);}\n}\n": (
        "namespace lab\n{\nvoid GraspImpl::mine() {receive_speak(1);}\n}\n"
    ),
    "using C = lab::ReachConfig;\nvoid f(const C & config) {config.gain;}\n": (
        "using C = lab::GraspConfig;\nvoid f(const C & config) {config.factor;}\n"
    ),
    "namespace lab {\ntypedef ReachConfig C;\nvoid f(C & config, C e) {config.gain, e.gain;}}\n": (
        "namespace lab {\ntypedef GraspConfig C;\n"
        "void f(C & config, C e) {config.factor, e.factor;}}\n"
    ),
    "void f() {data_.in_goal = this->config_.gain + config->gain;}\n": (
        "void f() {data_.in_target = this->config_.factor + config->factor;}\n"
    ),
}
CASES = [("lab/tools.py", text, text) for text in FOREIGN]
CASES += [("lab/tools.py", *case) for case in OURS.items()]
CASES += [("src/tools.cpp", text, text) for text in CPP_FOREIGN]
CASES += [("src/tools.cpp", *case) for case in CPP_OURS.items()]


CASES += [
    (
        "CMakeLists.txt",
        "link(reach)\nset(target_b c reach)\n",
        "link(reach)\nset(target_b c reach)\n",
    ),
    ("CMakeLists.txt", "ADD_EXECUTABLE(reach a.cpp)\n", "ADD_EXECUTABLE(grasp a.cpp)\n"),
    ("CMakeLists.txt", "install(TARGETS reach)\n", "install(TARGETS grasp)\n"),
    # A letter that is used as a mark
    ("src/tools.cpp", "lab::ReachData a;  // a\ua78f\n", "lab::GraspData a;  // a\ua78f\n"),
]


@pytest.mark.parametrize(("path", "text", "wanted"), CASES)
def test_names_in_own_files(pairs, path, text, wanted):
    model = "python_model" if path.endswith(".py") else "cpp_model"
    assert pairs[model].renaming.text(path, text) == wanted


OWN_STRUCT = "struct ReachConfig\n{\n  int gain;\n  int in_goal;\n};\n"
OWN_USE = "int f(const ReachConfig & config) {return config.gain + config.in_goal;}\n"
OURS_USE = "int g(const ReachConfig & config) {return config.gain;}\n"
"""C++ with names of the model that are the developer's in one scope, and not in others."""
IN_SCOPES = [
    f"namespace lab {{ namespace own {{\n{OWN_STRUCT}{OWN_USE}}}\n|{OURS_USE}|}}\n",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nnamespace lab {{ namespace own {{ {OWN_USE} }} }}\n",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nint f(lab::own::ReachConfig a) {{return a.gain;}}\n",
    f"namespace own {{\n{OWN_STRUCT}{OWN_USE}}}\nnamespace lab {{\n|{OURS_USE}|}}\n",
    f"namespace lab {{ namespace {{\n{OWN_STRUCT}}}\n{OWN_USE}}}\n",
    f"namespace lab {{\nclass Own {{\n{OWN_STRUCT}  ReachConfig c_;\n}};\n|{OURS_USE}|}}\n",
    f"namespace lab {{\nclass Own : A<int> {{\n{OWN_STRUCT}void f();\n}};\n"
    "void Own::f() {ReachConfig c; c.gain;}\nint g() {return Own::ReachConfig{}.gain;}\n}\n",
    f"namespace lab {{\nclass Own {{\n{OWN_STRUCT}void f(ReachConfig c);\n}};\n"
    "Own::Own(ReachConfig c) : a_(c) {c.gain;}\n}\n",
    f"namespace lab {{\nint h() {{\n{OWN_STRUCT}  ReachConfig c; return c.gain;\n}}\n"
    f"|{OURS_USE}|}}\n",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nusing namespace lab::own;\n{OWN_USE}",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nnamespace lab {{\nint h()\n{{\n"
    f"  using namespace lab::own;\n  ReachConfig c; return c.gain;\n}}\n|{OURS_USE}|}}\n",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nusing lab::own::ReachConfig;\n{OWN_USE}",
    f"namespace lab::own {{\n{OWN_STRUCT}}}\nnamespace o = lab::own;\no::ReachConfig c;\n",
    "namespace lab::own {\ntemplate<class T>\nstruct ReachData {T in_goal;};\n"
    "ReachData<int> data;\nint a = data.in_goal;\n}\nlab::own::ReachData<int> b;\n",
    "namespace lab::own {\nenum class InGoal {kOne, in_goal};\nInGoal a = InGoal::in_goal;\n}\n",
    "namespace lab::own {\nenum {in_goal, kTwo};\nint a = in_goal;\n}\nint b = own::in_goal;\n",
    "namespace lab::own {\nusing ReachData = int;\nReachData a;\n}\nlab::own::ReachData b;\n",
    "namespace lab::own {\ntypedef int ReachData;\nReachData a;\n}\n",
    "namespace lab::own {\nstruct ReachData;\nvoid f(ReachData *);\n}\n",
    "namespace lab::own {\ndouble in_goal(int);\n}\nint a = lab::own::in_goal(1);\n",
    "namespace lab::own {\nint in_goal = 1;\nint f() {return in_goal;}\n}\n",
    "template<class T> struct Own {\nstruct ReachData {};\n};\nOwn<int>::ReachData a;\n",
]


@pytest.mark.parametrize("text", IN_SCOPES)
def test_names_of_scopes_of_the_developers_own(pairs, text):
    """What is between strokes is of the model."""
    head = "#include <lab/mine.hpp>\n"
    renaming = pairs["cpp_model"].renaming
    parts = (head + text).split("|")
    parts[1::2] = [p.replace("Reach", "Grasp").replace(".gain", ".factor") for p in parts[1::2]]
    assert renaming.text("src/tools.cpp", head + text.replace("|", "")) == "".join(parts)


@pytest.mark.parametrize(
    ("path", "is_there"), [("test/own.cpp", True), ("test/../test/a.cc", True), ("a.cpp", False)]
)
@pytest.mark.parametrize("sign", ["", "./"])
def test_header_of_the_model_that_is_included_from_the_folder_beside_it(
    pairs, path, is_there, sign
):
    text = f'#include "{sign}support/reach_harness.hpp"\n#include <support/reach_harness.hpp>\n'
    wanted = text.replace("reach", "grasp", 1) if is_there else text
    assert pairs["cpp_model"].renaming.text(path, text) == wanted


@pytest.mark.parametrize("space", ["acme::lab", "lab::v2", "acme"])
def test_generated_code_takes_the_new_name_in_a_namespace_of_the_developers(pairs, space):
    pair, spaces = pairs["cpp_model"], ("namespace lab", f"namespace {space}")
    texts = {p: text for p, text in pair.old.items() if p.endswith((".hpp", ".cpp"))}
    renaming = replace(pair.renaming, _texts={}, scopes=set())
    renaming.know(tree_of({path: text.replace(*spaces) for path, text in texts.items()}))
    for path, text in texts.items():
        found = renaming.text(path, text.replace(*spaces))
        assert found == pair.renaming.text(path, text).replace(*spaces)


def test_names_that_an_own_header_declares(pairs):
    """In the scope that it declares them in, wherever that is opened again."""
    own = f"namespace lab::own {{\n{OWN_STRUCT}}}\n"
    renaming = replace(pairs["cpp_model"].renaming, _texts={}, scopes=set())
    renaming.know(tree_of({**pairs["cpp_model"].old, "include/lab/own.hpp": own}))
    text = (
        f'#include "lab/own.hpp"\nnamespace lab {{\n{OURS_USE}namespace own {{\n{OWN_USE}}}\n}}\n'
    )
    wanted = text.replace(OURS_USE, OURS_USE.replace("Reach", "Grasp").replace("gain", "factor"))
    assert renaming.text("src/tools.cpp", text) == wanted
    text = "lab::ReachHarness a;\nlab::own::ReachConfig b;\nb.gain + b.in_goal;\n"
    assert renaming.text("src/a.cpp", text) == text.replace("ReachHar", "GraspHar")


OF_OWN_MODULES = {
    "from lab.kin import ReachConfig\n\nReachConfig(gain=1)\n": "",
    "from .kin import ReachConfig as Kin\n\n\ndef f(config: Kin):\n    config.gain\n": "",
    "from lab.vendor.reach_interface import ReachData\n": "",
    "from lab.more import ReachData, x\n\nReachData()\n": (
        "from lab.more import GraspData, x\n\nGraspData()\n"
    ),
    "from .reach_interface import ReachData\n": "from .grasp_interface import GraspData\n",
    "from . import kin\n\n\ndef f(c: kin.ReachConfig):\n    kin.ReachConfig(gain=c.gain)\n": "",
    "import lab.kin as k\n\nk.ReachConfig(gain=1).gain\n": "",
    "import lab.vendor.reach_interface\n\nlab.vendor.reach_interface.ReachData().in_goal\n": "",
    "from .vendor import reach_interface as r\n\nr.ReachData\n": "",
    "from .vendor import reach_interface\n\nreach_interface.ReachData\n": "",
    "from .kin import Own\n\nOwn.ReachData(in_goal=1)\n": "",
    "from .kin import ReachConfig\nfrom .reach_interface import ReachData\n": (
        "from .kin import ReachConfig\nfrom .grasp_interface import GraspData\n"
    ),
    "from . import more\n\nmore.ReachData().in_goal\n": (
        "from . import more\n\nmore.GraspData().in_goal\n"
    ),
    "from .reach_interface import ReachConfig\n\n\nclass A:\n    class ReachConfig:\n"
    "        gain = 1\n\n    def f(self, c: ReachConfig):\n        self.ReachConfig(gain=2)\n"
    "        A.ReachConfig(gain=3)\n        ReachConfig(gain=c.gain)\n": (
        "from .grasp_interface import GraspConfig\n\n\nclass A:\n    class ReachConfig:\n"
        "        gain = 1\n\n    def f(self, c: GraspConfig):\n        self.ReachConfig(gain=2)\n"
        "        A.ReachConfig(gain=3)\n        GraspConfig(factor=c.factor)\n"
    ),
    "from . import mode\n\nuse(mode.gain, mode.in_goal, mode.Mode.gain)\n": "",
    "from .mode import Mode as M, gain\nfrom .reach_interface import ReachConfig\n\n"
    "use(M.gain, M.in_goal, M.receive_say)\nReachConfig(gain=gain)\n": (
        "from .mode import Mode as M, gain\nfrom .grasp_interface import GraspConfig\n\n"
        "use(M.gain, M.in_goal, M.receive_say)\nGraspConfig(factor=gain)\n"
    ),
    "from . import mode\nfrom .mode import ROBOT\n\nuse(ROBOT.gain, mode.ROBOT.in_goal)\n": "",
    "from lab.util import Mode, R, b\nfrom . import util\n\n"
    "use(R.gain, Mode.gain, util.Mode.in_goal, b.in_goal, util.gain)\n": "",
    "from .reach_impl import Mine, ReachImpl\n\nuse(Mine.gain, ReachImpl.receive_say)\n": (
        "from .grasp_impl import Mine, GraspImpl\n\nuse(Mine.gain, GraspImpl.receive_speak)\n"
    ),
    "from .reach_interface import ReachConfig\n\n\ndef f():\n    class ReachConfig:\n"
    "        gain = 1\n\n    ReachConfig(gain=2)\n\n\nReachConfig(gain=3)\n": (
        "from .grasp_interface import GraspConfig\n\n\ndef f():\n    class ReachConfig:\n"
        "        gain = 1\n\n    ReachConfig(gain=2)\n\n\nGraspConfig(factor=3)\n"
    ),
}


@pytest.mark.parametrize(("text", "wanted"), OF_OWN_MODULES.items())
def test_names_that_own_modules_define(pairs, text, wanted):
    """Of what they only import, the model's name is still that."""
    old = pairs["python_model"].old
    renaming = replace(pairs["python_model"].renaming, _texts={}, own=set())
    own = {
        "lab/kin.py": "class ReachConfig:\n    a = 1\n\n\nclass Own:\n"
        "    class ReachData:\n        a = 1\n",
        "lab/vendor/reach_interface.py": "ReachData = 1\n",
        "lab/more.py": "from .reach_interface import ReachData\n\n\ndef x():\n    pass\n",
        "lab/bad.py": "class\n",
        "lab/mode.py": "gain, ROBOT = 1, load()\nif gain:\n    in_goal, b = 2, 3\n\n\n"
        "class Mode(Enum):\n"
        "    gain = 1\n    in_goal: int = 2\n\n    def receive_say(self):\n        pass\n",
        "lab/util/__init__.py": "from ..mode import Mode, b\nfrom .kin import ReachConfig as R\n\n"
        "gain = 1\n",
        "lab/util/kin.py": "class ReachConfig:\n    gain = 1\n",
        "lab/reach_impl.py": f"{old['lab/reach_impl.py']}\n\nclass Mine:\n    gain = 1\n",
    }
    renaming.know(tree_of({**old, **own}))
    assert renaming.text("lab/tools.py", text) == (wanted or text)


OF_RELATIVES = {
    "lab/sub.py": (
        "from .mixin import Mixin\nfrom .reach_impl import ReachImpl\n\n\n"
        "class Sub(Mixin, ReachImpl):\n"
        "    def receive_say(self, m):\n        super().receive_say(m)\n"
    ),
    "lab/sub2.py": (
        "from lab.sub import Sub\n\n\nclass Sub2(Sub):\n    def receive_say(self):\n        a\n"
    ),
    "lab/mixin.py": "class Mixin:\n    def receive_say(self, m):\n        self.gain = 1\n",
    "lab/use.py": (
        "from .sub2 import Sub2\n\nsub = Sub2()\nsub.receive_say(a.receive_say)\n"
        "Sub2.receive_say(sub)\n"
    ),
    "lab/types.py": "from .reach_impl import ReachImpl\n\nSub3 = ReachImpl\n",
    "lab/use3.py": "from .types import Sub3\n\n\ndef f(c: Sub3):\n    c.receive_say(1)\n",
    "include/lab/types.hpp": "namespace lab {\nusing Sub3 = const ReachImpl;\n}\n",
    "src/use3.cpp": "#include <lab/types.hpp>\nlab::Sub3 c;\nc.receive_say(b.receive_say);\n",
    "lab/other.py": (
        "from vendor import Base\n\n\nclass Other(Base):\n    def receive_say(self, m):\n"
        "        super().receive_say(m)\n\n\nclass A:\n    def receive_say(self):\n        a\n"
    ),
    "lab/other2.py": (
        "from vendor import ReachImpl\n\n\nclass Other2(ReachImpl):\n"
        "    def receive_say(self, m):\n        super().receive_say(m)\n"
    ),
    "test/a.py": (
        "from lab.reach_impl import ReachImpl\n\n\nclass Spy(ReachImpl):\n"
        "    def receive_say(self):\n        a\n"
    ),
    "lab/other3.py": "class Spy:\n    def receive_say(self):\n        a\n",
    "include/lab/sub.hpp": (
        "namespace lab {\nclass Sub final : public a::Base<A>, public ReachImpl\n{\n"
        "  void receive_say(A a);\n};\nclass Sub2 : Sub {};\n}\n"
    ),
    "src/sub.cpp": (
        "namespace lab {\nvoid Sub::receive_say(A a)\n{\n"
        "  ReachImpl::receive_say(a); this->receive_say(a);\n}\n}\n"
    ),
    "src/use.cpp": "#include <lab/sub.hpp>\nlab::Sub2 a;\na.receive_say(b.receive_say);\n",
    "src/own.cpp": "namespace lab {\nstruct Spy : ReachImpl {\n  void receive_say(A a);\n};\n}\n",
    "src/other2.cpp": "namespace lab {\nstruct Spy {\n  void receive_say(A a);\n};\n}\n",
    "src/other.cpp": (
        "namespace lab {\nclass Other : public vendor::ReachImpl {};\n"
        "void Other::receive_say(A a)\n{\n  this->receive_say(a);\n}\n}\n"
    ),
}


def test_members_of_a_logic_are_those_of_all_its_files_but_none_of_what_tests_have_for_it():
    texts = {
        "include/lab/reach_impl.hpp": "class ReachImpl {\n  void load();\n};\n",
        "src/reach_impl.cpp": "void ReachImpl::load()\n{\n  gain_ = 1;\n}\n",
        "test/support/recorder/lab/reach_impl.hpp": "class ReachImpl {\n  void record();\n};\n",
    }
    found = _classes(tree_of(texts), texts, ())
    assert {"load", "gain_"} < found["ReachImpl"]
    assert "record" not in found["ReachImpl"]


def test_class_below_a_namespace_that_is_used_is_in_none():
    text = "using namespace std;\nclass Reach {};\n"
    assert declared(text, ["Reach"]) == {((), "Reach")}


def test_classes_that_are_related_to_the_models_in_other_files(pairs):
    """A class derived from the logic has its callbacks, and so has what that one derives from."""
    for model in OWN:
        own = {p: text for p, text in OF_RELATIVES.items() if p.endswith(".py") == ("py" in model)}
        renaming = replace(pairs[model].renaming, _texts={}, own=set(), scopes=set(), kin={})
        for files in (renaming.in_file, renaming.members):
            files |= dict.fromkeys(own, files[OWN[model]])
        renaming.know(tree_of({**pairs[model].old, **own}))
        for path, text in own.items():
            wanted = re.sub(r"(?<![(][ab]\.)\breceive_say", "receive_speak", text)
            wanted = wanted.replace("Reach", "Grasp").replace("reach", "grasp")
            assert renaming.text(path, text) == (text if "other" in path else wanted), path


CLOSED = {
    "namespace arm\n{\n}  // namespace arm\n": "namespace robot\n{\n}  // namespace robot\n",
    "namespace arm::tools {\n}  /* end of namespace arm::tools */\n": (
        "namespace robot::tools {\n}  /* end of namespace robot::tools */\n"
    ),
    "namespace arm {namespace b {\nnamespace {\n}  // namespace\n}}  // namespace arm::b\n": (
        "namespace robot {namespace b {\nnamespace {\n}  // namespace\n}}  // namespace robot::b\n"
    ),
    # What closes another one, is about it, or is in a text
    "namespace own\n{\nnamespace arm {class A;}  // namespace arm\n}\n": None,
    "namespace arms\n{\n}  // namespace arms of namespace arm\n": None,
    "void f()\n{\n}  // namespace arm\n": None,
    'namespace arm {\n// namespace arm\nf("}  // namespace arm");\n}  // namespace arm2\n': (
        'namespace robot {\n// namespace arm\nf("}  // namespace arm");\n}  // namespace arm2\n'
    ),
    "#if A\nnamespace arm {\n#else\nnamespace arm {\n#endif\n}  // namespace arm\n": (
        "#if A\nnamespace robot {\n#else\nnamespace robot {\n#endif\n}  // namespace robot\n"
    ),
}


@pytest.mark.parametrize(("text", "wanted"), CLOSED.items())
def test_comment_where_a_namespace_ends_says_its_name(text, wanted):
    assert Renaming(packages={"arm": "robot"}).text("a.cpp", text) == (wanted or text)


OF_PACKAGE = {
    "import arm\n\nuse(arm.x, x.arm)\n": "import robot\n\nuse(robot.x, x.arm)\n",
    "import os, arm\n\nuse(arm)\n": "import os, robot\n\nuse(robot)\n",
    "from arm import arm\n\nuse(arm.x)\n": "from robot import arm\n\nuse(arm.x)\n",
    "def f():\n    from arm import (\n        arm,\n    )\n": (
        "def f():\n    from robot import (\n        arm,\n    )\n"
    ),
    "import arm\nprint arm\n": "import robot\nprint arm\n",
    "import os, arm\nfrom .a import arm as b\n": "import os, robot\nfrom .a import arm as b\n",
    "import arm\nfrom .a import (\n    arm as b,\n)\n": (
        "import robot\nfrom .a import (\n    arm as b,\n)\n"
    ),
    "arm = 1\n": "arm = 1\n",
    "namespace arm\n{\narm::A arm;\n}\n": "namespace robot\n{\nrobot::A arm;\n}\n",
    "namespace arm {auto f() -> arm::A;}\n": "namespace robot {auto f() -> robot::A;}\n",
    "namespace own\n{\nnamespace arm {class A;}\narm::A a;\n}\nown::arm::A a;\narm::A b;\n": (
        "namespace own\n{\nnamespace arm {class A;}\narm::A a;\n}\nown::arm::A a;\nrobot::A b;\n"
    ),
    "namespace own = arm;\narm::A a;\n": "namespace own = robot;\nrobot::A a;\n",
    "link(arm arm::core)\n": "link(arm robot::core)\n",
}


@pytest.mark.parametrize(("text", "wanted"), OF_PACKAGE.items())
def test_name_of_the_package(text, wanted):
    path = "a.cpp" if "::A" in text else "a.cmake" if "link" in text else "a.py"
    assert Renaming(packages={"arm": "robot"}).text(path, text) == wanted


REFERRED = [
    ("a.urdf", '<robot name="arm"><mesh filename="package://{}/arm.stl"/></robot>\n'),
    (
        "a.launch.xml",
        '<node pkg="{}" exec="arm" name="arm"/>\n<a file="$(find-pkg-share {})/a"/>\n',
    ),
    (
        "a.launch",
        "<include file='$(find {})/launch/arm.launch'/>\n<node pkg='arm_msgs' type='arm'/>\n",
    ),
    (
        "a.launch.py",
        "Node(package='{}', name='arm')\nshare = FindPackageShare(\"{}\")\narm = 'arm'\n",
    ),
    ("a.py", "get_package_share_directory('{}')\nget_package_share_directory('arms')\nf('arm')\n"),
    ("a.cpp", 'auto a = b::get_package_share_directory("{}");\nauto arm = c("arm");\n'),
    (
        "a.launch.yaml",
        'launch:\n- node:\n    pkg: "{}"\n    exec: arm\n- arm: $(find-pkg-share {})\n',
    ),
    ("config/a.yaml", "arm:\n  mesh: package://{}/arm\n  other: package://arm-tools/arm\n"),
    (
        "README.md",
        "The arm: `ros2 launch {} arm.launch.xml`, `roslaunch {} a`, `ros2 run {} arm`.\n",
    ),
    ("a.msg", "{}/Arm arm\n{}/msg/Arm[3] arms  # arm/Arm\narm_msgs/Arm a\n"),
    ("a.txt", "vendor://arm/x find arm\n"),
    ("setup.py", "['own={}.own:main', 'b = arms.b:c', 'arm = v.arm:d', \"arm = {}.x.y:z\"]\n"),
    ("b.py", "import_module('{}.x')\nmock.patch(\"{}.x.y\")\nget_parameter('arm.x', 'a=arm')\n"),
]


@pytest.mark.parametrize(("path", "form"), REFERRED)
def test_package_where_ros_looks_for_one_by_its_name(path, form):
    """An address, a substitution of a launch file, a command: no other word of the text."""
    text = form.format(*["arm"] * 3)
    assert Renaming(packages={"arm": "robot"}).text(path, text) == form.format(*["robot"] * 3)


IN_LOGIC = {
    "self.receive_say(message)": "self.receive_speak(message)",
    "data.in_goal.data": "data.in_target.data",
    "message.in_goal": "message.in_goal",
    "self.in_goal": "self.in_goal",
    "in_goal = 1": "in_goal = 1",
    "vendor.ReachConfig()": "vendor.ReachConfig()",
    "move(goal=config.gain)": "move(goal=config.factor)",
}
IN_CPP_LOGIC = {
    "receive_say(message);": "receive_speak(message);",
    "this->receive_say(message);": "this->receive_speak(message);",
    "data.in_goal.data = message.in_goal;": "data.in_target.data = message.in_goal;",
    "message->in_goal;": "message->in_goal;",
    "vendor::ReachConfig a;": "vendor::ReachConfig a;",
    "ReachData & d = data; d.in_goal;": "GraspData & d = data; d.in_target;",
}


@pytest.mark.parametrize(("code", "wanted"), {**IN_LOGIC, **IN_CPP_LOGIC}.items())
def test_names_in_generated_files(pairs, code, wanted):
    model = "cpp_model" if code in IN_CPP_LOGIC else "python_model"
    path = {"python_model": "lab/reach_impl.py", "cpp_model": "src/reach_impl.cpp"}[model]
    before = {"python_model": "        return True\n", "cpp_model": "  return true;\n"}[model]
    pair = pairs[model]
    assert before in pair.old[path]
    margin = before[: len(before) - len(before.lstrip())]
    mine = pair.old[path].replace(before, f"{margin}{code}\n{before}", 1)
    text = pair.renaming.text(path, mine)
    assert f"{margin}{wanted}\n" in text
    assert text.replace(f"{margin}{wanted}\n", "", 1) == pair.renaming.text(path, pair.old[path])


HPP, CPP, PY = "include/lab/reach_impl.hpp", "src/reach_impl.cpp", "lab/reach_impl.py"
GUARD = "LAB__REACH_IMPL_HPP_"
MADE = [
    (
        HPP,
        (f"#ifndef {GUARD}\n#define {GUARD}\n", "#pragma once\n"),
        (f"#endif  // {GUARD}\n", ""),
    ),
    (HPP, ("  // Topic say\n", "")),
    (HPP, ("  // Topic say\n", "  // Topic say, aloud\n")),
    (CPP, ("// Service load\n", "// Service load, twice\n")),
    (PY, ("    # Topic say\n", "")),
    (PY, ("    # Topic say\n", "    # Topic say, aloud\n")),
]


@pytest.mark.parametrize(("path", "changes"), [(path, changes) for path, *changes in MADE])
def test_what_a_developer_makes_of_a_comment_with_the_name_is_no_conflict(pairs, path, changes):
    """The model's comments take the new name, too: a rename does not change them."""
    pair = pairs["python_model" if path == PY else "cpp_model"]
    wanted, text = pair.new[pair.renaming.path(path)], pair.old[path]
    for before, after in changes:
        new = before.replace("say", "speak").replace("load", "fetch").replace("reach", "grasp")
        new = new.replace("REACH", "GRASP")
        assert text.count(before) == wanted.count(new) == 1
        text, wanted = text.replace(before, after), wanted.replace(new, after)
    mine, old, new = map(tree_of, ({**pair.old, path: text}, pair.old, pair.new))
    result, doubts = Versions(mine, old, new, pair.renaming, pair.is_kept).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree[pair.renaming.path(path)].text == wanted


OF_A_PARAMETER = [
    ("python_model", "lab/reach_interface.py", "    gain: ", "  # tuned"),
    ("cpp_model", "include/lab/reach_interface.hpp", "  std::int64_t gain ", "  // tuned"),
]


@pytest.mark.parametrize(("model", "path", "start", "comment"), OF_A_PARAMETER)
def test_what_a_developer_makes_of_the_default_of_a_parameter(pairs, model, path, start, comment):
    """With another type it is a conflict, of which the proof does not say that it is lost."""
    line = line_of(pairs[model].old, path, start)
    text, other = line.replace("= 1", "= 7") + comment, line.replace("int", "Count")
    assert text != line != other
    assert joined(pairs[model], path, start, text) == (text.replace("gain", "factor"), [], False)
    assert joined(pairs[model], path, start, line + comment)[1:] == ([], False)
    assert joined(pairs[model], path, start, other)[1:] == ([], True)


@pytest.mark.parametrize("model", OWN)
def test_row_of_a_table_with_the_name_keeps_the_last_cell_of_the_developer(pairs, model):
    start = "| `load` |"
    rows = [
        line_of(files, "README.md", start.replace("load", name))
        for files, name in ((pairs[model].old, "load"), (pairs[model].new, "fetch"))
    ]
    text, wanted = (re.sub(r"[^|]*\|$", " Mine, `load` too |", row) for row in rows)
    assert joined(pairs[model], "README.md", start, text) == (wanted, [], False)
    aligned, found = (row.replace(" | Mine", "    | Mine") for row in (text, wanted))
    assert joined(pairs[model], "README.md", start, aligned) == (found, [], False)
    text, wanted = (row.replace("Mine,", r"Mine \| yours,") for row in (text, wanted))
    assert joined(pairs[model], "README.md", start, text) == (wanted, [], False)


def test_head_of_a_line_is_known_by_more_than_a_name():
    lines = {"gain: int = 1": "factor: int = 1", "gain = 1": "factor = 1", "k: a = 1": "k: a = 2"}
    assert _heads(PYTHON, lines) == {"gain: int": "factor: int"}


def test_empty_cell_of_a_row_with_the_name_keeps_its_blanks():
    rows = [f"| `{name}` | `int8[3]` |  |  |" for name in ("load", "fetch")]
    heads = _heads(MARKDOWN, dict([rows]))
    assert _as_made(MARKDOWN, *rows, {}, heads) == rows[1]


NAMED = "{}:\n  # mine\n  ros__parameters:\n    gain: 2\n"


@pytest.mark.parametrize("name", ["reach", "/reach", "/left/reach", "/**/reach", '"reach"'])
def test_name_of_a_node_above_its_parameters(pairs, name):
    """The parameters below it, of which one has another name now, are its."""
    text = NAMED.format(name)
    wanted = text.replace("reach", "grasp").replace("gain", "factor")
    assert pairs["python_model"].renaming.text("config/mine.yaml", text) == wanted


@pytest.mark.parametrize(
    "text", [NAMED.format("reach_2"), NAMED.format("reach/b"), "reach:\n  a: 1\n"]
)
def test_what_is_not_the_name_of_a_node_above_its_parameters(pairs, text):
    assert pairs["python_model"].renaming.text("config/mine.yaml", text) == text


def line_of(files, path, start):
    """Return the line of a file that begins so."""
    text = files[path if path in files else path.replace("reach", "grasp")]
    (line,) = (line for line in text.splitlines() if line.startswith(start))
    return line


def joined(pair, path, start, line):
    """Write a line in the place of one; say what it is after the update, doubts and conflict."""
    files = {**pair.old, path: pair.old[path].replace(line_of(pair.old, path, start), line)}
    mine, old, new = map(tree_of, (files, pair.old, pair.new))
    result, doubts = Versions(mine, old, new, pair.renaming, pair.is_kept).merged()
    target = pair.renaming.path(path)
    texts = {target: result.tree[target].text}
    is_conflict = bool(result.conflicts)
    found = (
        ""
        if is_conflict
        else line_of(texts, target, start.replace("gain", "factor").replace("load", "fetch"))
    )
    return found, doubts, is_conflict


def test_foreign_look_alikes_are_listed_and_ours_renamed(render, copier_command):
    """The whole of an update: a node, its interface and the package have other names."""
    package = render(SPEC, name="arm")
    tools = package / "arm/tools.py"
    foreign = "from vendor import arm\nfrom kinematics import ReachConfig\n"
    tools.write_text(
        f"{foreign}from arm.reach_interface import ReachData\n\narm.go(ReachConfig)\n"
    )
    commit(package, "Write tools")
    git(package, "mv", "arm.ros_package", "robot_arm.ros_package")
    spec = package / "robot_arm.ros_package"
    text = spec.read_text().replace('<package name="arm"', '<package name="robot_arm" was="arm"')
    spec.write_text(text.replace('<node name="reach"', '<node name="grasp" was="reach"'))
    commit(package, "Rename")
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    found = (package / "robot_arm/tools.py").read_text()
    ours = "from robot_arm.grasp_interface import GraspData\n"
    assert found == f"{foreign}{ours}\narm.go(ReachConfig)\n"
    for use in ("1: arm", "2: ReachConfig", "5: ReachConfig", "5: arm"):
        assert f"still     robot_arm/tools.py:{use}\n" in result.stderr


def test_words_of_an_included_path():
    """Its folders are what a namespace is to a name."""
    found = words(languages.CPP, '#include "arm/ros/reach.hpp"\n')
    assert [(word.text, word.after, word.chain) for word in found] == [
        ("arm", "::", ()),
        ("ros", "::", ("arm",)),
        ("reach", ".", ("arm", "ros")),
        ("hpp", '"', ("arm", "ros", "reach")),
    ]


def test_words_of_directives():
    """Those of a macro are of code; what a macro includes is a file whose name it has."""
    text = "#include FOO(arm)\n#define GAIN(data) data->gain \\\n  + 1\nint gain;\n"
    found = {word.text: (word.chain, word.line) for word in words(languages.CPP, text)}
    assert found["arm"] == ((), 0)
    assert found["gain"] == ((), 3)
    chains = [word.chain for word in words(languages.CPP, text) if word.text == "gain"]
    assert chains == [("data",), ()]


def test_constants_of_types_stay():
    text = "def f(call: Callable[..., A], one: Annotated[A, 5], two: 'A') -> None: ...\n"
    found = exchange(PYTHON, text, lambda word: "B", {"A"})
    assert found == text.replace("A]", "B]").replace("A,", "B,").replace("'A'", "'B'")


def test_bracket_argument_of_cmake_hides_no_names():
    """A quote in it begins no text."""
    found = [*words(CMAKE, 'set(mine [[")]])\nadd_executable(reach a.cpp)\nset(a "b")\n')]
    assert [word.text for word in found] == "set mine add_executable reach a cpp set a".split()


def test_target_that_is_named_in_full_is_listed(pairs):
    """The model writes ${PROJECT_NAME}_reach, which is exchanged."""
    pair = pairs["cpp_model"]
    text = "link(cli vendor_reach)\nlink(cli lab_reach)\nlink(cli ${PROJECT_NAME}_reach)\n"
    mine = {**pair.old, "own.cmake": text}
    made = Versions(*map(tree_of, (mine, pair.old, pair.new)), pair.renaming, pair.is_kept)
    result, doubts = made.merged()
    said = [*uses(made.mine, made.old, made.new, result.tree, pair.renaming)]
    assert doubts == []
    assert [use for use in said if "cmake" in use] == ["own.cmake:2: lab_reach"]
