"""A package has no function and no class in its runtime that nothing in the package uses."""

import re
from collections import Counter

import pytest

from support.model_checks import Model
from support.repository import ROOT

FOR_THE_LOGIC = """
  debug_once info_once warning_once error_once
  debug_throttle info_throttle warning_throttle error_throttle
  ok set set_hardware_id abort lookup broadcast broadcast_static
""".split()
FOR_A_LIBRARY = """
  on_configure on_activate on_deactivate on_cleanup on_error on_shutdown initialize result_type
""".split()
"""What rclpy, rclcpp, actionlib and message_filters call."""
COMMENTS = {".py": r'"""(?:.|\n)*?"""|#.*', ".hpp": "//.*", ".cpp": "//.*"}
DEFINITIONS = {
    ".py": r"^ *(?:async )?(?:def|class) (\w+)",
    ".hpp": r"(?:^|[\s*&])(\w+)\([^;{}()]*\) *(?:const)? *(?:override)? *\{"
    r"|\b(?:class|struct) (\w+)",
}
WORDS = "if for while switch catch return".split()


def unused(files):
    """Return what the files of a runtime define and no file of the package's own code names."""
    code = {
        path: re.sub(comment, "", text)
        for path, text in files.items()
        for suffix, comment in COMMENTS.items()
        if path.endswith(suffix) and not path.startswith("test/")
    }
    named = Counter(word for text in code.values() for word in re.findall(r"\w+", text))
    defined = {
        name
        for path, text in code.items()
        for suffix, definition in DEFINITIONS.items()
        if path.endswith(suffix) and "/ros/" in path
        for names in re.findall(definition, text, re.MULTILINE)
        for name in ([names] if isinstance(names, str) else filter(None, names))
    }
    exempt = {*FOR_THE_LOGIC, *FOR_A_LIBRARY, *WORDS}
    return {name for name in defined - exempt if named[name] == 1 and not name.startswith("__")}


@pytest.mark.parametrize("distro", ["kilted", "noetic"])
@pytest.mark.parametrize("name", ["cpp_model", "python_model"])
def test_runtime_of_one_kind(renderers, name, distro):
    model = Model(ROOT / name)
    found = []
    for owner in model.owners:
        elements = [(owner, model.base(owner))]
        if owner.component == "node" and owner.kind:
            # A deadline without diagnostics has no one to complain to.
            elements += [(owner, v) for n, _, v in model.variants(owner) if n == "deadline"][:1]
        for each in elements:
            context = model.context(model.spec([each]), distro)
            names = context and unused(renderers[name].render(context, distro))
            found += [(str(owner), *names)] if names else []
    assert not found
