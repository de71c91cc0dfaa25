"""What the tests know of each model: where its logic is, and how to fill it in."""

from conftest import EXAMPLES, ROOT, commit, git

MODELS = ["python_model", "cpp_model"]
LOGIC = {"python_model": "all_kinds/worker_impl.py", "cpp_model": "src/worker_impl.cpp"}
VOLUME = '    <subscriber name="volume" type="std_msgs::Float64" description="How loud"/>\n'


def fill_in(package, model):
    """Write the logic of tests/logic into a package of examples/all_kinds; return its text."""
    git(package, "apply", str(ROOT / f"tests/logic/{model}.patch"))
    commit(package, "Fill in the logic")
    return (package / LOGIC[model]).read_text()


def add_volume(package):
    """Add a subscriber to the spec of a package."""
    file = package / "all_kinds.ros_package"
    text = file.read_text()
    file.write_text(text.replace("    <directPublisher", f"{VOLUME}    <directPublisher", 1))
    commit(package, "Add a topic")


def use_volume(package, model):
    """Use the new topic in the logic, where the logic could not be written before it."""
    patch = ROOT / f"tests/logic/{model}_volume.patch"
    if patch.exists():
        git(package, "apply", str(patch))


def all_kinds():
    """Return the spec with every interface kind."""
    return (EXAMPLES / "all_kinds.ros_package").read_text()
