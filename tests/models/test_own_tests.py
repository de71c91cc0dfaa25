"""The tests that a package brings know every interface kind and attribute of the dictionary.

`ros/test_mutants.py` sees that they notice a node that is of another spec.
"""

import pytest

from support.model_checks import Model
from support.own_tests import UNTESTED, UNTESTED_IN_ROS1, differences
from support.packages import MODELS
from support.repository import ROOT


@pytest.mark.parametrize(
    ("distro", "untested"), [("kilted", UNTESTED), ("noetic", UNTESTED_IN_ROS1)]
)
@pytest.mark.parametrize("name", MODELS)
def test_every_kind_and_attribute(renderers, name, distro, untested):
    model = Model(ROOT / name)

    def tests(spec):
        files = renderers[name].render(spec, distro)
        return {path: text for path, text in files.items() if path.endswith("_node.py")}

    seen = {}
    for what, *elements in differences(model, untested):
        specs = [model.context(model.spec(each), distro) for each in elements]
        if all(specs) and not seen.get(what):
            seen[what] = tests(specs[0]) != tests(specs[1])
    unseen = [what for what, is_seen in seen.items() if not is_seen]
    assert not unseen, f"the tests of a package do not depend on: {', '.join(unseen)}"
