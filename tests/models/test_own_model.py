"""A model that is nothing like ours: a second component tag, other words, functions of its own."""

import re
import shutil

import copier
import pytest
from copier.errors import UserMessageError

from support.repository import ROOT, commit, git

MODEL = {
    "dictionary.yaml": """
package_attributes: [title]
node_attributes: [name]
node_interface:
  topic: [name]
controller_attributes:
  - label: {format: identifier, unique: true}
  - rate: {format: int, minimum: 1, default: 100}
controller_interface:
  joint:
    doc: a joint to move
    attributes:
      - label: {format: identifier, unique: true}
      - limit: {format: double, default: 1.0}
skeleton: [joint]
""",
    "functions.py": '''"""What the templates of this model need."""


def degrees(radians):
    """Return an angle in degrees, rounded."""
    return round(radians * 57.29577951)
''',
    "copier.yml": "---\n!include hooks/copier.yml\n---\n_subdirectory: template\n",
    "template/{{ spec.title }}.ros_package.jinja": "{{ spec_text(spec_file) }}",
    "template/{{ _copier_conf.answers_file }}.jinja": "{{ _copier_answers | to_nice_yaml }}",
    "template/[controller.label].txt.jinja": """
{% for joint in controller.joints %}
{{ joint.label }} {{ joint.limit | degrees }} at {{ controller.rate }}
{% endfor %}
""",
    "template/nodes.txt.jinja": "{% for node in spec.nodes %}\n{{ node.name }}\n{% endfor %}\n",
}
SPEC = """<package title="arm">
  <controller label="left" rate="50">
    <joint label="elbow" limit="1.5708"/>
  </controller>
  <node name="eye"/>
  <controller label="right"/>
</package>
"""


NAMING = '<?xml-model href="ros_package.xsd"?>\n'


@pytest.fixture
def model(tmp_path):
    """Make a repository of the model, with hooks and extensions inside, and return its folder."""
    folder = tmp_path / "model"
    for name, text in MODEL.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    for name in ("hooks", "extensions"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    commit(folder, tag="1.0.0")
    return folder


@pytest.fixture
def make(model, tmp_path):
    """Render a package of the model from a spec, or from its starter spec, and commit it."""

    def run(spec=None, name="arm"):
        data = {"ros_distro": "kilted"}
        if spec is not None:
            (tmp_path / "spec.xml").write_text(spec)
            data["spec_file"] = str(tmp_path / "spec.xml")
        options = {"defaults": True, "unsafe": True, "quiet": True}
        copier.run_copy(str(model), tmp_path / name, data=data, **options)
        commit(tmp_path / name)
        return tmp_path / name

    return run


def test_second_component_tag(make, update):
    package = make(SPEC)
    assert (package / "left.txt").read_text() == "\nelbow 90 at 50\n"
    assert (package / "right.txt").read_text() == "\n"
    assert (package / "nodes.txt").read_text() == "eye\n"
    more = SPEC.replace('label="right"/>', 'label="right"><joint label="wrist"/></controller>')
    (package / "arm.ros_package").write_text(more)
    commit(package)
    update(package)
    assert (package / "right.txt").read_text() == "\nwrist 57 at 100\n"


@pytest.mark.parametrize(
    ("file", "right", "wrong", "said"),
    [
        ("dictionary.yaml", "skeleton: [joint]", "skeleton: [joit]", "dictionary.yaml:"),
        ("functions.py", "return round(", "return 1 / 0 + (", "functions.py:"),
    ],
)
def test_fault_of_a_model_names_no_clone(model, make, file, right, wrong, said):
    """Copier clones the model into a folder that is gone when the message is read."""
    (model / file).write_text((model / file).read_text().replace(right, wrong))
    commit(model, "Slip", tag="1.1.0")
    with pytest.raises(UserMessageError) as error:
        make(SPEC if file == "functions.py" else None)
    assert said in str(error.value)
    assert "clone" not in str(error.value)


def test_renamed_component_of_another_tag(make, update):
    package = make(SPEC)
    (package / "left.txt").write_text("mine\n\nelbow 90 at 50\n")
    (package / "arm.ros_package").write_text(
        SPEC.replace('label="left"', 'label="port" was="left"')
    )
    commit(package)
    update(package)
    assert (package / "port.txt").read_text() == "mine\n\nelbow 90 at 50\n"
    assert not (package / "left.txt").exists()


def test_starter_spec_of_another_dictionary(make):
    package = make(name="my_arm")
    (spec,) = package.glob("*.ros_package")
    assert '<joint label="label"/>' in spec.read_text()


def test_schema_comes_to_older_packages(model, make, update):
    """And a newer dictionary makes a newer one; the spec is the developer's and stays."""
    package = make(NAMING + SPEC)
    schema = package / "ros_package.xsd"
    assert not schema.exists()
    (model / "template/ros_package.xsd.jinja").write_text("{{ spec_schema() }}")
    commit(model, tag="2.0.0")
    update(package)
    assert 'element name="joint"' in schema.read_text()
    commit(package)
    dictionary = model / "dictionary.yaml"
    dictionary.write_text(dictionary.read_text().replace("a joint to move", "a joint that moves"))
    commit(model, tag="3.0.0")
    update(package)
    assert "a joint that moves" in schema.read_text()
    spec = package / "arm.ros_package"
    assert spec.read_text() == NAMING + SPEC
    commit(package)
    for text in (SPEC, NAMING + SPEC):  # which is all that this update brings
        spec.write_text(text)
        commit(package)
        update(package)
        assert schema.exists() == (NAMING in text)


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        (SPEC.replace("<joint", "<topic"), "it belongs inside <node>"),
        (SPEC.replace('rate="50"', 'rate="0"'), "rate: 0 must be at least 1"),
        (SPEC.replace('label="right"', 'label="left"'), '"left" is already taken'),
        ('<package title="arm"/>', "has no <node> or <controller>"),
    ],
)
def test_faults_in_another_tag(make, spec, message):
    with pytest.raises(copier.errors.UserMessageError, match=message):
        make(spec)


def test_own_choices_of_a_distribution(model, make):
    """They count for an option, too; a default that is none of them is the designer's slip."""
    settings = model / "copier.yml"
    text = settings.read_text()
    for tag, default, message in (
        (
            "2.0.0",
            "jazzy",
            'ros_distro: unknown "kilted"; allowed: humble, jazzy [unknown-choice]',
        ),
        (
            "3.0.0",
            "jazy",
            'copier.yml:5: ros_distro: default: unknown choice "jazy"; did you mean "ja',
        ),
    ):
        question = f"ros_distro:\n  choices: [humble, jazzy]\n  default: {default}\n"
        settings.write_text(text + question)
        commit(model, tag=tag)
        with pytest.raises(copier.errors.UserMessageError) as error:
            make(SPEC)
        assert str(error.value).startswith(message)


def test_fault_in_a_function(model, make):
    file = model / "functions.py"
    file.write_text(file.read_text().replace("round(radians", "round(missing"))
    commit(model, tag="2.0.0")
    with pytest.raises(copier.errors.UserMessageError) as error:
        make(SPEC)
    assert "functions.py:6: degrees(1.5708): NameError: name 'missing'" in str(error.value)
    assert str(error.value).endswith(f" (in {JOINTS}:3) [function-fails]")


JOINTS = "template/[controller.label].txt.jinja"


@pytest.mark.parametrize(
    ("name", "right", "wrong", "message"),
    [
        (
            JOINTS,
            "joint.label",
            "joint.lable",
            f"{JOINTS}:3: 'dict object' has no attribute 'lable'",
        ),
        (JOINTS, "joint in contr", "joint in contrl", f"{JOINTS}:2: 'contrloller' is undefined"),
        (JOINTS, "| degrees", "| degree", f"{JOINTS}:3: No filter named 'degree'"),
        (JOINTS, "| degrees", "is small", f"{JOINTS}:3: No test named 'small'"),
        (JOINTS, "{% endfor", "{% endfr", f"{JOINTS}:4: Encountered unknown tag 'endfr'"),
        (JOINTS, "{% endfor %}", "", f"{JOINTS}:3: Unexpected end of template"),
        (
            JOINTS,
            "joint.limit | degrees",
            "1 / 0",
            f"{JOINTS}:3: ZeroDivisionError: division by zero",
        ),
        (JOINTS, "{% for", "{% include 'x' %}{% for", f'{JOINTS}:2: no such template "x"'),
        (
            JOINTS,
            "{% for",
            "{% from 'part' import a %}{{ a() }}{% for",
            f"{JOINTS}:2: the template 'part' ",
        ),
        (
            JOINTS,
            "{% for",
            "{% from 'part' import b %}{{ b() }}{% for",
            "part:1: 'c' is undefined",
        ),
        (JOINTS, "{% for", "{% include 'wrong' %}{% for", "wrong:1: unexpected '}'"),
        (
            "copier.yml",
            "late\n",
            "late\n_exclude: ['{{ spec.x }}']\n",
            "copier.yml:5: 'dict object' ha",
        ),
        (
            "copier.yml",
            "late\n",
            "late\nx: {default: '{{ 1/0 }}'}\n",
            "copier.yml:5: ZeroDivisionEr",
        ),
        (
            "dictionary.yaml",
            "skeleton: [joint]",
            "skeleton: [join]",
            "dictionary.yaml:15: skeleton: ",
        ),
    ],
)
def test_mistake_in_a_template(model, make, name, right, wrong, message):
    """Each is one line with the file and the line, and nothing is written."""
    (model / "part").write_text("{% macro b() %}{{ c }}{% endmacro %}")
    (model / "wrong").write_text("{{ } }}")
    text = (model / name).read_text()
    assert right in text
    (model / name).write_text(text.replace(right, wrong, 1))
    commit(model, tag="2.0.0")
    with pytest.raises(copier.errors.UserMessageError) as error:
        make(SPEC)
    found = str(error.value)
    assert re.sub(r"^/\S*/(?=dictionary)", "", found).startswith(message), found
    assert "\n" not in found


@pytest.mark.parametrize(
    ("name", "message"),
    [
        (
            "[controller.lable].txt",
            'controller has no attribute "lable"; allowed: class_name, label',
        ),
        (
            "[controler.label].txt",
            'unknown tag "controler"; allowed: node, topic, controller, joint',
        ),
        ("{{ spec.titel }}.txt", "'dict object' has no attribute 'titel'"),
        ("{{ spec.title | loud }}.txt", "No filter named 'loud'"),
        ("{{ spec.title.txt", "unexpected end of template"),
        ("{{ spec.title - 1 }}.txt", "TypeError: unsupported operand"),
        ("[spec.arm]", "No filter named 'parts'"),
    ],
)
def test_mistake_in_the_name_of_a_template(model, make, name, message):
    (model / "template" / name).mkdir()
    (model / "template" / name / "x.txt").write_text("")
    commit(model, tag="2.0.0")
    with pytest.raises(copier.errors.UserMessageError) as error:
        make(SPEC)
    assert str(error.value).startswith(f"template/{name}: {message}")


def test_mistake_in_a_newer_model(model, make, update):
    """An update says it alike, and leaves the package as it was."""
    package = make(SPEC)
    file = model / JOINTS
    file.write_text(file.read_text().replace("joint.label", "joint.lable"))
    commit(model, tag="2.0.0")
    with pytest.raises(copier.errors.UserMessageError) as error:
        update(package)
    said = "'dict object' has no attribute 'lable' [template-fails]"
    assert str(error.value) == f"{JOINTS}:3: {said}"
    assert git(package, "status", "--short") == ""


@pytest.mark.parametrize("text", [None, "", "written: by hand\n"])
def test_newer_model_that_does_not_record_the_answers(model, make, update, text):
    """The package could not be updated any more."""
    package = make(SPEC)
    (file,) = (model / "template").glob("*answers_file*")
    file.write_text(text or "")
    if text is None:
        file.unlink()
    commit(model, tag="2.0.0")
    with pytest.raises(copier.errors.UserMessageError, match=r"answers.*\[no-answers\]"):
        update(package)
    assert git(package, "status", "--short") == ""


def test_fault_of_the_hook_keeps_its_traceback(model, make):
    """It is no mistake of the author's, and a line would hide where it is."""
    file = model / "hooks/complete.py"
    file.write_text(file.read_text().replace("    _check_kinds(spec)\n", "    {}['fault']\n", 1))
    commit(model, tag="2.0.0")
    with pytest.raises(KeyError, match="fault"):
        make(SPEC)
