"""A dictionary may include others: it adds to what they say, and their functions come along."""

import pytest

from hooks.dictionary import load
from hooks.faults import SpecError
from hooks.model import Model

BASE = """
package_attributes: [title]
part_attributes: [label, {size: {choices: {big: [large]}}}]
part_interface:
  port: [at]
names:
  pin: {in: part, reserved: [gnd], port: ["{at}"]}
skeleton: [port]
"""
FILES = {
    "base.yaml": BASE,
    "one/dictionary.yaml": """
include: base.yaml
names:
  pin: {in: part, port: ["{at}_one"]}
""",
    "one/functions.py": """
def speak(word):
    return 'one ' + word


def hum():
    return 1
""",
    "two/dictionary.yaml": """
include: base.yaml
part_attributes: [{size: {choices: {small: []}}}]
part_interface:
  port: [{at: {reserved: [nowhere]}}]
  hole: [depth]
names:
  pin: {in: part, reserved: [vcc], port: ["{at}_two"]}
""",
    "two/functions.py": """
def speak(word):
    return 'two ' + word


def shout(word):
    return word.upper()
""",
    "both/dictionary.yaml": """
include: [one/dictionary.yaml, two/dictionary.yaml]
part_attributes: [{maker: {choices: [one, two]}}]
""",
    "both/functions.py": """
def speak(word):
    return 'both ' + word


def dependencies_from_interface(kind, attributes, ros_distro):
    return [f"{attributes['part']['maker']}_{attributes['package']['title']}_{kind}"]
""",
}


@pytest.fixture
def model(tmp_path):
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return lambda: Model(tmp_path / "both", tmp_path)


def test_mappings_and_lists_are_added_to(model):
    dictionary = model().dictionary
    part = dictionary.components["part"]
    assert list(part.attributes) == ["label", "size", "maker"]
    assert list(part.attributes["size"].choices) == ["small"]
    assert list(part.interfaces) == ["port", "hole"]
    assert part.interfaces["port"].attributes["at"].reserved == ["nowhere"]
    assert dictionary.skeleton == ["port"]
    assert dictionary.naming == "title"
    (pin,) = dictionary.scopes
    assert pin.reserved == ["gnd", "vcc"]
    assert pin.made_by == {"port": ["{at}", "{at}_one", "{at}_two"]}


def test_of_a_list_and_a_mapping_the_own_one_counts(tmp_path):
    (tmp_path / "base.yaml").write_text("a_interface: {b: [x], c: {attributes: [x], doc: d}}\n")
    own = tmp_path / "dictionary.yaml"
    own.write_text("include: base.yaml\na_interface: {b: {attributes: [y]}, c: [y]}\n")
    kinds = load(own, tmp_path).components["a"].interfaces
    assert {kind: list(each.attributes) for kind, each in kinds.items()} == {
        "b": ["y"],
        "c": ["y"],
    }
    assert kinds["c"].doc == ""


def test_functions_come_along(model):
    functions = model().functions
    assert functions["speak"]("up") == "both up"
    assert functions["shout"]("up") == "UP"
    assert functions["hum"]() == 1


def test_function_for_an_interface_sees_what_it_is_in(model):
    spec = """<package title="rig"><part label="a" maker="one" size="small"><port at="x"/></part>
    <part label="b" maker="two" size="small"><hole depth="1"/></part></package>"""
    context = model().context(spec.encode(), "spec", "kilted")
    assert context["depends"] == ["one_rig_port", "two_rig_hole"]


def test_fault_in_an_included_function_names_its_file(model, tmp_path):
    (tmp_path / "two/functions.py").write_text("def speak(word):\n    return missing\n\n\nbad(")
    with pytest.raises(SpecError, match=r"two/functions\.py:5: SyntaxError"):
        model()


@pytest.mark.parametrize("name", ["gone.yaml", "3", "[base.yaml, gone.yaml]"])
def test_missing_dictionary(model, tmp_path, name):
    (tmp_path / "both/dictionary.yaml").write_text(f"include: {name}\n")
    with pytest.raises(SpecError, match="no such file; a model needs it"):
        model()


def test_dictionary_of_another_folder_is_read_once(tmp_path):
    """Copier clones a version for each render; one that says anything else is read anew."""
    said = {"one/dictionary.yaml": "include: more.yaml\na_attributes: [name]\n"}
    said["more.yaml"] = "b_attributes: [name]\n"
    read = []
    for number, text in enumerate((*[said["more.yaml"]] * 2, "b_attributes: [name, other]\n")):
        root = tmp_path / str(number)
        for file, content in (said | {"more.yaml": text}).items():
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(content)
        read.append(load(root / "one/dictionary.yaml", root))
    assert read[0] is read[1]
    attributes = [list(each.components["b"].attributes) for each in read]
    assert attributes[1:] == [["name"], ["name", "other"]]
    (tmp_path / "1/more.yaml").unlink()
    with pytest.raises(SpecError, match=r"^one/dictionary\.yaml:1: include: more\.yaml: no such"):
        load(tmp_path / "1/one/dictionary.yaml", tmp_path / "1")
