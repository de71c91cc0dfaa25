"""The XML schema that editors complete a spec by: all that the dictionary says, and no more."""

import xml.etree.ElementTree as ET

import pytest

from hooks.faults import SpecError
from hooks.literals import spelled
from hooks.model import Model
from scripts import accept
from support.model_checks import validators
from support.packages import HOSTILE, RUNTIME
from support.repository import EXAMPLES, ROOT

XS = "{http://www.w3.org/2001/XMLSchema}"
MODELS = {file.parent.name: file.parent for file in ROOT.glob("*_model/dictionary.yaml")}
DICTIONARY = """
package_attributes: [title]
arm_attributes:
  - name: {doc: 'name & <place> of "it"'}
  - side: {choices: {left: [l, "left side"], right: []}, default: left}
  - label: {same_as: name}
  - old: {ignored: true, choices: [a]}
  - moves: {format: bool, default: false}
  - speed: {default: 2.0}
arm_interface:
  joint: {doc: a joint, attributes: [name, limit]}
  bool: [name]
  home: {once: true, attributes: [x], interface: {joint: [name, other]}}
leg_attributes: [name]
leg_interface:
  joint: {doc: another joint, attributes: [name]}
  depend: [name]
tag_attributes: [word]
aliases: {limb: leg}
"""
SPEC = """<package title="x" was="y">
  <tag word="w"> <!-- nothing --> </tag>
  <limb name="l" was="m"><joint name="knee"/><depend name="x"/></limb>
  <depend kind="exec"> std_msgs </depend>
  <arm name="a" side=" l&#10;" old="b" moves="Yes">
    <home x="1"><joint name="j" other="o"/></home>
    <joint name="j" limit="1" was="k"/>
    <bool name="b"/>
  </arm>
  <leg name="m"/>
</package>
"""


def model_of(folder, dictionary):
    (folder / "dictionary.yaml").write_text(dictionary)
    return Model(folder, folder)


@pytest.fixture
def is_valid(tmp_path):
    def run(model, spec):
        file = tmp_path / "ros_package.xsd"
        file.write_text(model.schema(), encoding="utf-8")
        verdicts = [accepts(spec) for accepts in validators(file)]
        if not verdicts:
            pytest.skip("needs xmlschema, or xmllint of libxml2")
        return all(verdicts)  # xmlschema takes signs for blanks that are none in XML

    return run


def is_accepted(model, spec):
    try:
        model.context(spec.encode(), "spec", "kilted")
    except SpecError:
        return False
    return True


HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (
            '<?xml-model href="ros_package.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>',
            True,
        ),
        ("<?xml-model schematypens='x' href = './ros_package.xsd'?>", True),
        ('<?xml-model href="other.xsd"?>', False),
        ('<?xml-model xhref="ros_package.xsd"?>', False),
        ('<?xml-stylesheet href="ros_package.xsd"?>', False),
        ('<!-- <?xml-model href="ros_package.xsd"?> -->', False),
        ("", False),
    ],
)
def test_spec_that_names_its_schema(tmp_path, line, expected):
    """Where it does, anywhere in the file, the package has the schema."""
    model = model_of(tmp_path, DICTIONARY)
    for spec in (HEAD + line + SPEC, "\ufeff" + HEAD + SPEC + line):
        assert model.context(spec.encode(), "spec", "kilted")["schema"] is expected


def test_dictionary_of_another(tmp_path, is_valid):
    """Kinds of one name that differ, at any depth; aliases; names that the schema uses itself."""
    model = model_of(tmp_path, DICTIONARY)
    assert is_accepted(model, SPEC)
    assert is_valid(model, SPEC)
    assert ">the name before, so that the code of a renamed one is kept; " in model.schema()


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ('side=" l&#10;"', 'side="up"'),
        ('side=" l&#10;"', 'side="&#160;l"'),
        ('moves="Yes"', 'moves="yess"'),
        ('moves="Yes"', 'moves="&#8195;yes"'),
        ('kind="exec"', 'kind=""'),
        ('word="w"', 'word="w" was="v"'),
        ("<!-- nothing -->", "something"),
        ("<!-- nothing -->", "\u00a0"),
        ('<joint name="knee"/>', '<joint name="knee" limit="1"/>'),
        ('name="j" limit="1"', 'name="j" other="o"'),
        ('<home x="1">', '<home x="1" was="y">'),
        ("<leg ", "<foot "),
        ("package", "arm"),
        ("  <leg", "text\n  <leg"),
        (SPEC, '<package title="x"/>'),
    ],
)
def test_both_refuse(tmp_path, is_valid, right, wrong):
    model = model_of(tmp_path, DICTIONARY)
    assert right in SPEC
    spec = SPEC.replace(right, wrong)
    assert not is_accepted(model, spec)
    assert not is_valid(model, spec)


EXAMPLES_OF = [(accept.models(file)[0], file) for file in EXAMPLES.glob("*.ros_package")]
EXAMPLES_OF += [("python_model", HOSTILE), ("runtime_model", RUNTIME)]


@pytest.mark.parametrize(("name", "spec"), EXAMPLES_OF, ids=lambda each: getattr(each, "stem", ""))
def test_examples_are_valid(is_valid, name, spec):
    assert is_valid(Model(MODELS[name], ROOT), spec.read_text())


@pytest.mark.parametrize("name", MODELS)
def test_words_of_the_dictionary(name):
    """Each doc, choice and default is where it belongs."""
    model = Model(MODELS[name], ROOT)
    root = ET.fromstring(model.schema())
    types = {each.get("name"): each for each in root.iter(f"{XS}complexType")}

    def check(element, kind):
        type_ = types.get(element.get("type"), element)
        attributes = {each.get("name"): each for each in inside(type_, "attribute")}
        for attribute in kind.attributes.values():
            found = attributes[attribute.name]
            if attribute.ignored:
                continue
            doc = found.findtext(f".//{XS}documentation", "")
            assert attribute.doc in doc
            words = [each.get("value") for each in found.iter(f"{XS}enumeration")]
            assert words == [w for one, more in attribute.choices.items() for w in (one, *more)]
            assert (found.get("use") == "required") == (not attribute.optional)
            if attribute.default not in (None, ""):
                assert found.get("default") == spelled(attribute.default)
        elements = {each.get("name"): each for each in inside(type_, "element")}
        for each in kind.interfaces.values():
            assert (
                elements[each.kind].findtext(f"{XS}annotation/{XS}documentation", "") == each.doc
            )
            check(elements[each.kind], each)

    package = root.find(f"{XS}element")
    assert package.get("name") == "package"
    tags = {each.get("name"): each for each in inside(package, "element")}
    for component in model.dictionary.components.values():
        check(tags[component.tag], component)


def inside(type_, tag):
    """Yield what a type itself has, without what is further inside."""
    for child in type_:
        if child.tag == f"{XS}{tag}":
            yield child
        elif child.tag != f"{XS}element":
            yield from inside(child, tag)
