"""Each interface kind is in the code of every variant: the dictionary says by which names.

`ros/test_mutants.py` sees that running nodes do what it is for.
"""

import re

import pytest

from support.model_checks import Model
from support.packages import MODELS
from support.repository import ROOT

VARIANTS = [(model, distro) for model in MODELS for distro in ("noetic", "kilted")]
DEFINED = {
    "member of the parameters": "_interface.",
    "member of the data": "_interface.",
    "member of the passthrough": "_interface.",
    "method of the logic": "_impl.",
}
"""Which file of a node defines the names of a scope of the dictionary; `_ros` uses them."""
NAMELESS = {"instance": "launch/", "use": "_interface."}
"""The kinds that have no such name, and the files that are about them."""


def missing(model, render, distro):
    """Return the kinds that a variant has no code for, and what of it is not there."""
    node = next(owner for owner in model.owners if owner.path == ("node",))
    kinds = [owner for owner in model.owners if owner.component == "node" and owner.kind]
    found = {}
    for owner in kinds:
        specs = [(owner, model.base(owner))], [(node, model.base(node))]
        files, others = (render(model.context(model.spec(each), distro), distro) for each in specs)
        changed = {path: text for path, text in files.items() if text != others.get(path)}
        lacking = [*lacking_names(model, owner, changed)]
        if lacking or not changed:
            found[owner.kind] = lacking
    return found


def lacking_names(model, owner, files):
    """Yield the first name of a kind in each scope, where the files that need it lack it."""
    scopes = [scope for scope in model.hook.dictionary.scopes if scope.label in DEFINED]
    forms = [
        (scope, form)
        for scope in scopes
        for form in scope.made_by.get(owner.kind, ())[:1]
        if " if " not in form
    ]
    for scope, form in forms:
        name = re.sub(r"\{name(:\w+)?\}", model.base(owner)["name"], form)
        for part in (DEFINED[scope.label], "_ros."):
            code = "\n".join(text for path, text in files.items() if part in path)
            if not re.search(rf"\b{name}_?\b", code):  # members of C++ end in a line
                yield f"{name} in *{part}*"
    if not forms and not any(NAMELESS.get(owner.kind, "_ros.") in path for path in files):
        yield "any code"


@pytest.mark.parametrize(("name", "distro"), VARIANTS)
def test_every_kind_is_in_the_code(renderers, name, distro):
    found = missing(Model(ROOT / name), renderers[name].render, distro)
    assert not found, f"{name} in {distro} has no code for {found}"


@pytest.mark.parametrize(("name", "distro"), VARIANTS)
def test_kind_on_trial_without_templates(renderers, tmp_path, name, distro):
    (tmp_path / "dictionary.yaml").write_text(f"""\
include: {name}/dictionary.yaml
node_interface:
  beacon: [name]
  flare: [name: {{example: red}}]
names:
  method of the logic: {{flare: ["flare_{{name:identifier}}"]}}
""")
    found = missing(Model(tmp_path), renderers[name].render, distro)
    assert found["beacon"] == ["any code"]
    assert found["flare"] == ["flare_red in *_impl.*", "flare_red in *_ros.*"]
    assert len(found) == 2


@pytest.mark.parametrize("kind", ["timer", "subscriber", "serviceClient", "dynParameter"])
def test_variant_without_templates_for_a_kind(renderers, kind):
    """As one without the loop over the elements of this kind."""

    def render(spec, distro):
        nodes = [{**node, f"{kind}s": []} for node in spec["nodes"]]
        return renderers["cpp_model"].render({**spec, "nodes": nodes}, distro)

    assert missing(Model(ROOT / "cpp_model"), render, "noetic").keys() == {kind}
