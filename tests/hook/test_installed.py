"""A type that its package lacks, where the package is installed, gets a note."""

import pytest

from hooks.installed import missing_types
from support.packages import model_of

SPEC = """<package name="robot" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="driver" frequency="10">{}</node>
</package>"""
MESSAGES = """<package name="robot_msgs" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <service name="Move"><request>{}</request></service>
</package>"""
VARIABLES = {
    "noetic": [("CMAKE_PREFIX_PATH", "share"), ("ROS_PACKAGE_PATH", "")],
    "kilted": [("AMENT_PREFIX_PATH", "share")],
}
ANY = [(distro, *variable) for distro, found in VARIABLES.items() for variable in found]


@pytest.fixture
def installed(tmp_path):
    for name in ("msg/Twist.msg", "msg/Pose.msg", "srv/Plan.srv", "msg/MoveAction.msg"):
        file = tmp_path / "prefix/share/arm_msgs" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    return tmp_path / "prefix"


def notes(environment, distro, *interfaces, spec=SPEC, model="python_model"):
    model = model_of(model)
    context = model.context(spec.format("".join(interfaces)).encode(), "spec", distro)
    return missing_types(context, model.dictionary, environment)


def found(kind, type_):
    return f'<{kind} name="x" type="{type_}"/>'


@pytest.mark.parametrize(("distro", "variable", "folder"), ANY)
def test_type_that_a_package_lacks(installed, distro, variable, folder):
    place = installed if folder else installed / "share"
    environment = {variable: f"/nothing/here:{place}"}
    (note,) = notes(environment, distro, found("publisher", "arm_msgs::Twst"))
    assert note == f"arm_msgs in {installed}/share has no msg/Twst; is Twist meant? [unknown-type]"
    assert notes(environment, distro, found("publisher", "arm_msgs::Twist")) == []
    assert notes({}, distro, found("publisher", "arm_msgs::Twst")) == []
    assert notes(environment, distro, found("publisher", "other_msgs::Twst")) == []


def test_service_action_and_field(installed):
    environment = {"ROS_PACKAGE_PATH": f"{installed}/share"}
    lacking = [
        found("serviceClient", "arm_msgs::Pan"),
        '<actionClient name="y" type="arm_msgs::Mve"/>',
        '<actionClient name="z" type="arm_msgs::Move"/>',
    ]
    assert notes(environment, "noetic", *lacking) == [
        f"arm_msgs in {installed}/share has no action/Mve; is Move meant? [unknown-type]",
        f"arm_msgs in {installed}/share has no srv/Pan; is Plan meant? [unknown-type]",
    ]
    fields = found("field", "arm_msgs::Pse[]"), '<field name="y" type="float64"/>'
    assert notes(environment, "noetic", *fields, spec=MESSAGES, model="interfaces_model") == [
        f"arm_msgs in {installed}/share has no msg/Pse; is Pose meant? [unknown-type]"
    ]


def test_overlay_adds_types(installed, tmp_path):
    """A type is there if any of the workspaces has it."""
    over = tmp_path / "over/share/arm_msgs/msg/Twst.msg"
    over.parent.mkdir(parents=True)
    over.touch()
    environment = {"AMENT_PREFIX_PATH": f"{tmp_path / 'over'}:{installed}"}
    assert notes(environment, "kilted", found("publisher", "arm_msgs::Twst")) == []


def test_the_note_is_shown_and_not_recorded(collection, copier_command, installed, tmp_path):
    spec = tmp_path / "robot.ros_package"
    spec.write_text(SPEC.format(found("publisher", "arm_msgs::Twst")))
    data = ("-d", "model=python_model", "-d", f"spec_file={spec}", "-d", "ros_distro=kilted")
    copy = ("copy", "--trust", "--defaults", *data, collection, "out")
    result = copier_command(*copy, cwd=tmp_path, AMENT_PREFIX_PATH=str(installed))
    assert "has no msg/Twst; is Twist meant? [unknown-type]\n" in result.stderr
    assert "is Twist meant" not in (tmp_path / "out/.copier-answers.yml").read_text()


@pytest.mark.parametrize("distro", VARIABLES)
@pytest.mark.parametrize(
    ("type_", "says"),
    [
        (
            "geometry_msgs::Twst",
            "geometry_msgs has no msg/Twst in any ROS known here; is Twist meant?",
        ),
        ("std_msg::String", "no package std_msg comes with ROS; is std_msgs meant?"),
        ("geometry_msg::Twist", "no package geometry_msg comes with ROS; is geometry_msgs meant?"),
        ("geometry_msgs::Twist", None),
        ("geometry_msgs::SomethingOfNextYear", None),
        ("arm_msgs::Twst", None),
    ],
)
def test_slip_where_nothing_is_installed(distro, type_, says):
    assert notes({}, distro, found("publisher", type_)) == (
        [f"{says} [unknown-type]"] if says else []
    )


def test_slip_in_an_installed_package_is_told_once(tmp_path):
    (tmp_path / "share/geometry_msgs/msg").mkdir(parents=True)
    (tmp_path / "share/geometry_msgs/msg/Twist.msg").touch()
    interface = found("publisher", "geometry_msgs::Twst")
    (note,) = notes({"AMENT_PREFIX_PATH": str(tmp_path)}, "kilted", interface)
    assert note.startswith(f"geometry_msgs in {tmp_path}")


@pytest.mark.parametrize("distro", VARIABLES)
@pytest.mark.parametrize(
    ("kind", "type_", "meant"),
    [
        ("publisher", "std_msgs::Double", "Float64"),
        ("publisher", "std_msgs::Int", "Int32"),
        ("publisher", "std_msgs::Float", "Float32"),
        ("publisher", "std_msgs::Boolean", "Bool"),
        ("serviceServer", "std_srvs::TriggerRequest", "Trigger"),
        ("serviceServer", "arm_msgs::PlanResponse", "Plan"),
        ("actionServer", "arm_msgs::MoveAction", "Move"),
        ("actionClient", "arm_msgs::MoveActionGoal", "Move"),
    ],
)
def test_what_code_calls_a_type(distro, kind, type_, meant):
    (note,) = notes({}, distro, found(kind, type_))
    assert f"is {meant} meant?" in note
