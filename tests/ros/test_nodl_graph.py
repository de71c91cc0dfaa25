"""The documents of packages in NoDL, beside what ROS knows of their nodes when they run."""

import json

import pytest
import yaml

from support import ros
from support.repository import EXAMPLES
from support.ros import PEERS

SPECS = [EXAMPLES / f"{name}.ros_package" for name in ("contact_analysis", "serving")]
HIDDEN = ("rcl_interfaces/", "type_description_interfaces/")
TYPES = ["", "bool", "int", "double", "string", "byte_array", "bool_array", "int_array"]
TYPES += ["double_array", "string_array"]


def full(name, node):
    """Return a name as the graph has it."""
    if name.startswith("~/"):
        return f"/{node}{name[1:]}"
    return name if name.startswith("/") else f"/{name}"


def listed(document, node):
    """Return the topics that lists have by their defaults, of which NoDL has no names."""
    given = document.get("codegen", {}).get("ros_package", {}).get("node", {})
    kinds = [
        each for kind in ("directPublisher", "directSubscriber") for each in given.get(kind, [])
    ]
    lists = [each["for_each"] for each in kinds if "for_each" in each]
    return [
        full(name, node)
        for each in lists
        for name in document["parameters"][each]["default_value"]
    ]


def differences(document, found, node):
    """Say what a document and the graph tell differently, as `nodl conform` does."""
    for list_, entities in found.items():
        if list_ in ("parameters", "qos"):
            continue
        said = {full(each["name"], node): each["type"] for each in document.get(list_, [])}
        there = {name: type_ for name, type_ in entities.items() if not type_.startswith(HIDDEN)}
        there = {name: there[name] for name in there if name not in listed(document, node)}
        yield from sorted(f"{list_}: {each}" for each in said.items() ^ there.items())
    said = {name: each["type"] for name, each in document.get("parameters", {}).items()}
    hidden = ("use_sim_time", "start_type_description_service", "qos_overrides.")
    types = {name: TYPES[type_] for name, type_ in found["parameters"].items()}
    there = {name: type_ for name, type_ in types.items() if not name.startswith(hidden)}
    yield from sorted(f"parameters: {each}" for each in said.items() ^ there.items())
    for list_, topics in found["qos"].items():
        for each in document.get(list_, []):
            seen = topics.get(full(each["name"], node))
            wrong = {key for key, word in seen.items() if each["qos"].get(key) != word}
            yield from sorted(f"{list_}: {each['name']} {key}" for key in wrong)


@pytest.fixture(scope="module")
def workspace(ros2_spec, ros2_interfaces, put, model, tmp_path_factory):
    workspace, ros2 = tmp_path_factory.mktemp("graph"), ros.ros2()
    for spec in (ros2_spec[0], *SPECS):
        put(spec, model, ros2.distro, workspace)
    ros2.build(workspace, ros2_interfaces)
    return workspace


@pytest.mark.parametrize("package", ["all_kinds", *(spec.stem for spec in SPECS)])
def test_documents_say_what_nodes_are(ros2, workspace, package):
    """No more and no less; and a node that has changed is noticed."""
    documents = {
        file.name.partition(".")[0]: yaml.safe_load(file.read_text())
        for file in (workspace / "src" / package / "nodl").iterdir()
    }
    with ros.nodes(ros2, workspace, package, *documents):
        for node, document in documents.items():
            command = f"{ros2.python} {PEERS}/graph_ros2.py /{node}"
            found = json.loads(ros2.run(command, workspace, workspace).stdout.splitlines()[-1])
            assert list(differences(document, found, node)) == []
            del found["service_servers"][f"/{node}/change_state"]
            assert len(list(differences(document, found, node))) == 1
