"""starter_model: from nothing to a team's own model, its packages, and the updates of both."""

import re
import shutil
import subprocess
import sys

import pytest
import yaml

from support import ros
from support.packages import QUIET, answers
from support.repository import bare_repository, commit, git

SERVER = """  server:
    doc: a service the node offers
    attributes:
      - name: {doc: name of the service, format: ros_name, unique: true, example: example}
      - type: {doc: service type, format: service_type, example: "std_srvs::Trigger"}
"""
SHOUT = '''

def shout(text):
    """Return a text in capitals."""
    return text.upper()
'''
README = """{% for server in node.servers %}
SERVICE {{ server.name | shout }} {{ server.type }}
{% endfor %}
"""


def change(file, old, new):
    text = file.read_text()
    assert old in text, f"{old} is not in {file}"
    file.write_text(text.replace(old, new, 1))


@pytest.fixture
def team(github, copier_command, tmp_path):
    """A team's repository, fresh from the published starter, and Copier's way to all of them."""
    *_, environment = github

    def run(*arguments, cwd=tmp_path):
        result = copier_command(*arguments, cwd=cwd, **environment)
        assert result.returncode == 0, result.stderr
        return result.stderr

    run("copy", "--defaults", "gh:org/starter_model", "my_model")
    commit(tmp_path / "my_model", "Start the model", tag="0.1.0")
    return tmp_path / "my_model", run


def run_tests(model, *options):
    """Run the tests of a model's repository and return what they print."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options]
    return subprocess.run(command, cwd=model, capture_output=True, text=True).stdout


def check(model):
    result = run_tests(model)
    assert re.search(r"^\d+ passed(, 1 skipped)? in", result, re.MULTILINE), result


def publish(model, tmp_path, tag):
    commit(model, tag, tag=tag)
    bare = bare_repository(tmp_path / "github/team/my_model.git")
    git(model, "push", "-q", bare, "main", tag)


def test_new_model_is_sound(team):
    model, _ = team
    names = git(model, "ls-files").splitlines()
    assert {"hooks/copier.yml", "extensions/spec.py", "shared/macros.jinja"} <= set(names)
    assert not any((model / name).is_symlink() for name in names)
    check(model)
    assert git(model, "status", "--short") == ""


def test_faults_of_a_model_are_found(team):
    model, _ = team
    change(
        model / "dictionary.yaml", "- period:", "- colour: {choices: [red, blue]}\n      - period:"
    )
    result = run_tests(model, "-k", "used and timer")
    assert "dictionary.yaml: node timer: no template makes use of colour" in result
    change(model / "template/README.md.jinja", "`{{ timer.name }}`", "`{{ timer.nam }}`")
    change(model / "template/package.xml.jinja", "</export>", "</exported>")
    result = run_tests(model, "-k", "all_of_the_dictionary and jazzy")
    line = (model / "template/README.md.jinja").read_text().split("timer.nam }")[0].count("\n") + 1
    assert f"template/README.md.jinja:{line}: 'dict object' has no attribute 'nam'" in result
    change(model / "template/README.md.jinja", "timer.nam }", "timer.name }")
    assert "package.xml: mismatched tag" in run_tests(model, "-k", "alone and publisher")
    change(model / "template/package.xml.jinja", "</exported>", "</export>")
    timers = "spec.nodes | sum(attribute='timers', start=[]) | length"
    leaving = f"{{% if {timers} == 1 %}}notes.txt{{% endif %}}"
    (model / "template" / leaving).write_text("Notes\n")
    assert "notes.txt" in run_tests(model, "-k", "keep_edits")


NODE = "template/{{ spec.name }}/[node.name].py.jinja"


def renamed(name, new):
    return lambda model: (model / name).rename(model / new)


def changed(name, old, new):
    return lambda model: change(model / name, old, new)


def added(name, text):
    return lambda model: (model / name).write_text(text)


MISTAKES = {
    "attribute in a file name": (
        renamed(NODE, NODE.replace("node.name", "node.nme")),
        "two_components",
        '{{ spec.name }}/[node.nme].py.jinja: node has no attribute "nme"; allowed: class_name',
    ),
    "tag in a file name": (
        renamed(NODE, NODE.replace("node.name", "nod.name")),
        "two_components",
        '{{ spec.name }}/[nod.name].py.jinja: unknown tag "nod"; allowed: node, publisher,',
    ),
    "the spec in a file name": (
        renamed(NODE, NODE.replace("node.name", "spec.name")),
        "two_components",
        '{{ spec.name }}/[spec.name].py.jinja: unknown tag "spec"; allowed: node, publisher,',
    ),
    "tag that is an answer": (
        changed("copier.yml", "ros_distro:\n", "node: {type: str, default: a}\n\nros_distro:\n"),
        "two_components",
        'test_[node.name].py.jinja: "node" is an answer, too; give the tag another name',
    ),
    "no schema": (
        added("template/{{ spec.name }}.ros_package.jinja", "<package/>\n"),
        "names_the_schema",
        ".ros_package names no schema: <?xml-model href=...?>",
    ),
    "one name for two components": (
        renamed(NODE, NODE.replace("node.name", "node.tag")),
        "two_components",
        "some_package/node.py is made 2 times, by {{ spec.name }}/[node.tag].py",
    ),
    "two templates for a file": (
        added("template/{{ spec.name }}/{{ spec.nodes[0].name }}.py", ""),
        "two_components",
        "{{ spec.name }}/[node.name].py.jinja and {{ spec.name }}/{{ spec.nodes[0].name }}.py",
    ),
    "a file and its template": (
        added("template/README.md", ""),
        "two_components",
        "README.md: of no use to any package",
    ),
    "no questions": (
        changed("copier.yml", "!include hooks/copier.yml", ""),
        "every_model_asks",
        "copier.yml: no `!include hooks/copier.yml`",
    ),
    "kind in the skeleton": (
        changed("dictionary.yaml", "skeleton: [publisher", "skeleton: [publishr"),
        "two_components",
        'dictionary.yaml:21: skeleton: unknown interface kind "publishr"; did you mean',
    ),
    "kind twice": (
        changed("dictionary.yaml", "  timer:", "  publisher: [name]\n  timer:"),
        "two_components",
        'dictionary.yaml:26: "publisher" is there twice, first at line 24; keep one',
    ),
    "text in XML": (
        changed(
            "template/package.xml.jinja", "  <export>", "  <!-- -->{{ spec.author }}\n  <export>"
        ),
        "escaped and jazzy",
        "package.xml: not well-formed",
    ),
    "text in Python": (
        changed(NODE, "The callbacks are yours.", "Of\n    '{{ spec.description }}'"),
        "escaped and jazzy",
        "some_package/example_node.py: ",
    ),
    "fault of the model": (
        changed("functions.py", 'return ["rclpy"]', 'return "rclpy"'),
        "all_of_the_dictionary and jazzy",
        "functions.py:4: dependencies_from_template for the package: must return a list",
    ),
}


def test_mistakes_of_a_model_are_found(team, tmp_path):
    """By the tests that the starter brings, each with the file, and the line where it has one."""
    source, _ = team
    for label, (mistake, test, message) in MISTAKES.items():
        model = shutil.copytree(source, tmp_path / label)
        mistake(model)
        assert message in run_tests(model, "-k", test), label


def test_pattern_of_an_attribute_is_no_fault(team):
    """Where its example is the only value that is known to match."""
    model, _ = team
    required = "- code: {pattern: 'x[0-9]+', example: x1}\n      - period:"
    change(model / "dictionary.yaml", "- period:", required)
    assert "1 passed" in run_tests(model, "-k", "used and timer")


def test_attributes_that_refer_to_elements(team):
    """The tests of the model give them the name of an element that is there."""
    model, _ = team
    refers = "- after: {refers_to: publisher, example: example}\n      - period:"
    change(model / "dictionary.yaml", "- period:", refers)
    added = "- last: {refers_to: node, default: example_node}\n\nnode_attributes:"
    change(model / "dictionary.yaml", "\nnode_attributes:", f"  {added}")
    change(model / "template/README.md.jinja", "`{{ timer.name }}`", "`{{ timer.after }}`")
    result = run_tests(model, "-k", "timer or all_of or two_components or escaped or edits")
    assert re.search(r"^\d+ passed, \d+ deselected in", result, re.MULTILINE), result


def test_life_of_a_model(team, github, tmp_path):
    """Make it, add a tag and a function, publish it, use it, publish v2, update both."""
    model, run = team
    dictionary = model / "dictionary.yaml"
    dictionary.write_text(dictionary.read_text() + SERVER)
    functions = model / "functions.py"
    functions.write_text(functions.read_text() + SHOUT)
    readme = model / "template/README.md.jinja"
    change(readme, "{% if node.timers %}", README + "{% if node.timers %}")
    check(model)
    publish(model, tmp_path, "0.2.0")

    run("copy", *QUIET, "gh:team/my_model", "mypkg")
    package = tmp_path / "mypkg"
    change(
        package / "mypkg/example_node.py",
        '"""Do the work."""',
        'self.get_logger().info("working")',
    )
    commit(package)
    change(
        package / "mypkg.ros_package",
        "  </node>",
        '    <server name="reset" type="std_srvs::Trigger"/>\n  </node>',
    )
    commit(package)
    run("update", *QUIET, cwd=package)
    assert "SERVICE RESET std_srvs/srv/Trigger" in (package / "README.md").read_text()
    commit(package)

    change(readme, "SERVICE {{", "Serves {{")
    publish(model, tmp_path, "0.3.0")
    run("update", *QUIET, cwd=package)
    assert answers(package)["_commit"] == "0.3.0"
    assert "Serves RESET" in (package / "README.md").read_text()
    assert 'info("working")' in (package / "mypkg/example_node.py").read_text()

    collection, publish_starter, _ = github
    change(collection / "hooks/ros.yaml", "distro: lyrical", "distro: rolling")
    change(collection / "tests/models/test_models.py", "EDIT = ", "# Newer\nEDIT = ")
    example = collection / "starter_model/template/template"
    (example / "new.txt").write_text("new\n")
    change(example / "README.md.jinja", "## Change", "## Other")
    change(collection / "starter_model/template/functions.py", "def modules", "def other")
    commit(collection, "Second version", tag="1.1.0")
    publish_starter()
    before = {name: git(model, "rev-parse", f"HEAD:{name}") for name in ("template", "README.md")}
    run("update", "--defaults", cwd=model)
    commit(model)
    assert "default_distro: rolling" in (model / "hooks/ros.yaml").read_text()
    assert "# Newer" in (model / "tests/test_models.py").read_text()
    assert before == {name: git(model, "rev-parse", f"HEAD:{name}") for name in before}
    assert "shout" in functions.read_text()
    assert "def modules" in functions.read_text()
    assert yaml.safe_load((model / ".copier-answers.yml").read_text())["_commit"] == "1.1.0"
    check(model)


@pytest.mark.ros2
def test_package_of_a_new_model_in_ros(team, ros2, tmp_path):
    """It builds, passes its tests, and its nodes start."""
    model, run = team
    (tmp_path / "robot.xml").write_text(
        """<package name="robot" author="A" author_email="a@example.org" description="d"
                    license="MIT">
             <node name="driver">
               <publisher name="speed" type="std_msgs::Float64"/>
               <subscriber name="goal" type="std_msgs::Bool"/>
               <timer name="drive" period="0.1"/>
             </node>
           </package>"""
    )
    data = ("-d", "spec_file=robot.xml", "-d", f"ros_distro={ros2.distro}")
    run("copy", *QUIET, *data, str(model), "workspace/src/robot")
    workspace = tmp_path / "workspace"
    logic = workspace / "src/robot/robot/driver.py"
    change(logic, '"""Do the work."""', "print('driving', flush=True)")
    ros2.build(workspace)
    ros2.run("colcon test --event-handlers console_cohesion+", workspace, workspace)
    result = ros2.run("colcon test-result --all --verbose", workspace, workspace).stdout
    assert "1 test, 0 errors, 0 failures, 0 skipped" in result, result
    with ros2.running("install/robot/lib/robot/driver", workspace, workspace) as log:
        ros.wait_for("driving", log)
