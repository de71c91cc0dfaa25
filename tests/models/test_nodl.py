"""NoDL: the documents of a package are valid and say all of its spec; those of others are read."""

import itertools
from pathlib import Path
from random import Random

import pytest
import yaml

from hooks import trees
from hooks.faults import SpecError
from hooks.located import load_located
from support.fuzz import Author
from support.model_checks import Model
from support.packages import DATA, HOSTILE
from support.repository import EXAMPLES, ROOT, commit, git

NODL = DATA / "nodl"
MODELS = {name: Model(ROOT / name) for name in ("python_model", "cpp_model", "mixed_model")}
PACKAGE = {"name": "arm", "author": "A", "author_email": "a@b.org", "license": "MIT"}
SOURCES = {"folder": "arm", "user": "Ada", "email": "ada@example.org", "year": "2026"}


def corpus(name):
    """Yield specs that the model accepts: the examples, all values of all attributes, others."""
    model = MODELS[name]
    files = [*EXAMPLES.glob("*.ros_package"), HOSTILE]
    yield from (file.read_text() for file in files)
    yield from (model.spec(made) for made in (model.small(), model.everything(), model.hostile()))
    yield model.several("kilted")
    for number in range(200):
        yield Author(number).spec(model.hook.dictionary).decode()


def without(value, key):
    """Return a value in which no mapping has a key."""
    if isinstance(value, list):
        return [without(each, key) for each in value]
    if isinstance(value, dict):
        return {name: without(each, key) for name, each in value.items() if name != key}
    return value


def written_out(context):
    """Return a context without groups, whose nodes keep what they have of these.

    What has its names from a list comes before others of its kind, as NoDL has no names of it.
    """
    kinds = [kind for kind in context["kinds"] if kind != "use"]
    nodes = [{**without(node, "group"), "uses": []} for node in context["nodes"]]
    for node, kind in itertools.product(nodes, ("directPublishers", "directSubscribers")):
        node[kind] = sorted(node[kind], key=lambda each: not each["for_each"])
    return {**context, "groups": [], "kinds": kinds, "nodes": nodes}


def documents(model, context):
    """Return the NoDL document of each node, by the name of its file."""
    tree, nodl = model.hook.tree(context), model.hook.functions["nodl"]
    return {f"{node['name']}.nodl.yaml": nodl(tree, node["name"]) for node in context["nodes"]}


def read(model, given):
    """Return the context of what a file or a folder says in NoDL, and the notes."""
    root, notes = model.hook.read_yaml(given, SOURCES)
    xml = trees.xml(root).encode()
    context = model.hook.context(xml, str(given), "kilted", root)
    assert model.hook.context(xml, "x", "kilted") == context
    return context, notes


@pytest.mark.parametrize("name", MODELS)
def test_round_trip(name, tmp_path):
    """From a spec to NoDL and back, nothing is lost; a spec whose NoDL is read has it again."""
    model, count = MODELS[name], 0
    for spec in corpus(name):
        context = model.context(spec, "kilted")
        if not context:
            continue
        folder = tmp_path / str(count)
        folder.mkdir()
        for file, text in documents(model, context).items():
            (folder / file).write_text(text)
        found, left_out = read(model, folder)
        # The packages that a spec depends on are named as this ROS calls them, so without a note.
        # A document does not say what a name was before.
        # Nor which interfaces a node has from a group: each says all of its own.
        expected = written_out(without(context, "was")) | {"schema": True}
        assert {**found, "notes": context["notes"]} == expected
        assert left_out == []
        count += 1
    assert count > 30


@pytest.mark.parametrize("name", MODELS)
def test_documents_are_valid(name):
    """They are what the schema of NoDL says, with each policy of each topic."""
    is_valid = validator()
    for spec in corpus(name):
        model = MODELS[name]
        context = model.context(spec, "kilted")
        for text in documents(model, context).values() if context else ():
            document = yaml.safe_load(text)
            is_valid(document)
            for topic in document.get("publishers", []) + document.get("subscriptions", []):
                assert {"history", "reliability", "durability"} <= set(topic["qos"])


def validator():
    jsonschema = pytest.importorskip("jsonschema")
    referencing = pytest.importorskip("referencing")
    files = {file.name: yaml.safe_load(file.read_text()) for file in NODL.glob("*.schema.yaml")}
    resources = [(n, referencing.Resource.from_contents(each)) for n, each in files.items()]
    registry = referencing.Registry().with_resources(resources)
    return jsonschema.Draft7Validator(files["nodl.schema.yaml"], registry=registry).validate


NODE = """nodl_version: 2
description: Drives the arm
publishers:
  - {name: speed, type: std_msgs/Float64, qos: {depth: 3, reliability: RELIABLE}}
parameters:
  gain:
    type: double
    default_value: 1
    validation: {gt_eq<>: [0], lt_eq: 2.5}
"""


@pytest.fixture
def node(tmp_path):
    """Write a document of a node, with something in it exchanged; return the file."""

    def write(right="", wrong="", name="driver.nodl.yaml"):
        assert right in NODE
        file = tmp_path / name
        file.write_text(NODE.replace(right, wrong, 1) if right else NODE)
        return file

    return write


def test_document_of_others(node):
    """Without words of ours: a node without a frequency, in a package as of a skeleton."""
    context, notes = read(MODELS["python_model"], node())
    assert notes == []
    assert context["name"] == "arm"
    assert context["description"] == "Drives the arm"
    (found,) = context["nodes"]
    assert (found["name"], found["frequency"]) == ("driver", None)
    (topic,) = found["directPublishers"]
    assert (topic["type"], topic["depth"], topic["reliability"]) == (
        "std_msgs/msg/Float64",
        3,
        None,
    )
    (parameter,) = found["parameters"]
    assert (parameter["value"], parameter["min"], parameter["max"]) == (1.0, 0.0, 2.5)


def test_what_every_node_has(node):
    """NoDL's `describe` tells of the lifecycle, too, which a package has without being told."""
    more = """parameters:
  autostart: {type: bool, default_value: true}
  frequency: {type: double, default_value: 20.0}
"""
    lifecycle = """service_servers:
  - {name: /driver/change_state, type: lifecycle_msgs/srv/ChangeState}
service_clients:
  - {name: /arm/change_state, type: lifecycle_msgs/srv/ChangeState}
publishers:
  - {name: /driver/transition_event, type: lifecycle_msgs/msg/TransitionEvent, qos: {}}
"""
    file = node("parameters:\n", more)
    file.write_text(file.read_text().replace("publishers:\n", lifecycle))
    (found,) = read(MODELS["python_model"], file)[0]["nodes"]
    assert found["frequency"] == 20.0
    assert [each["name"] for each in found["parameters"]] == ["gain"]
    assert [each["name"] for each in found["directPublishers"]] == ["speed"]
    assert [each["name"] for each in found["serviceClients"]] == ["/arm/change_state"]
    assert found["serviceServers"] == []


@pytest.mark.parametrize("name", ["python_model", "cpp_model"])
def test_inputs_of_a_synchronizer_are_subscriptions(name):
    """Others read which topics a node hears, whatever it does with their messages."""
    model = MODELS[name]
    context = model.context((EXAMPLES / "all_kinds.ros_package").read_text(), "kilted")
    said = 0
    for node in context["nodes"]:
        document = yaml.safe_load(documents(model, context)[f"{node['name']}.nodl.yaml"])
        inputs = [each for joined in node["synchronizers"] for each in joined["inputs"]]
        heard = {(each["name"], each["type"]) for each in document["subscriptions"]}
        assert {(each["name"], each["type"]) for each in inputs} <= heard
        said += len(inputs)
    assert said


@pytest.mark.parametrize("name", ["python_model", "cpp_model"])
def test_topics_of_a_list_have_no_names(name):
    """A parameter has them: a document with the spec's own would name topics that are none."""
    model = MODELS[name]
    context = model.context((EXAMPLES / "all_kinds.ros_package").read_text(), "kilted")
    document = yaml.safe_load(documents(model, context)["worker.nodl.yaml"])
    own = document["codegen"]["ros_package"]["node"]
    for list_, kind in {
        "publishers": "directPublisher",
        "subscriptions": "directSubscriber",
    }.items():
        (listed,) = [each for each in own[kind] if isinstance(each, dict) and "for_each" in each]
        assert listed["type"] == "std_msgs/msg/String"
        assert listed["name"] not in [each["name"] for each in document[list_]]


def test_words_that_nodl_does_not_have(tmp_path):
    """Whatever a dictionary comes to have: attributes with lists, kinds inside of others."""
    rule = ("rule", {"name": "least", "of": [1, 2]}, [("case", {"name": "x"}, [])])
    topic = (
        "directPublisher",
        {"name": "speed", "type": "std_msgs/msg/Float64", "of": [1]},
        [rule],
    )
    taken = ("directPublisher", {"name": "/tf", "type": "tf2_msgs/msg/TFMessage"}, [])
    node = ("node", {"name": "driver", "guards": [0.5]}, [topic, taken, rule])
    package = ("package", {"name": "arm"}, [("group", {"name": "g"}, [rule]), node])
    functions = MODELS["python_model"].hook.functions
    file = tmp_path / "driver.nodl.yaml"
    file.write_text(functions["nodl"](package, "driver"))
    read, notes = functions["spec_from_yaml"](
        [str(file)], lambda name: load_located(Path(name), name)
    )
    assert plain_tree(read) == plain_tree(package)
    assert notes == []


def plain_tree(tree):
    """Return a tree with what is inside in one order, which says nothing between kinds."""
    tag, given, inside = tree
    return str(tag), dict(given), sorted((plain_tree(each) for each in inside), key=str)


@pytest.mark.parametrize("name", ["driver.yaml", "driver", "driver.json"])
def test_told_by_content(node, name):
    assert MODELS["python_model"].hook.reads_yaml(node(name=name))
    assert not MODELS["python_model"].hook.reads_yaml(HOSTILE)


def test_words_of_ours_that_are_out_of_date(tmp_path):
    """NoDL's words count where a document has been changed and ours were left."""
    model = MODELS["python_model"]
    spec = model.spec(model.small())
    spec = spec.replace("<subscriber", '<subscriber qos="sensor_data"')
    ((name, text),) = documents(model, model.context(spec, "kilted")).items()
    (tmp_path / name).write_text(text.replace("depth: 5", "depth: 7"))
    (topic,) = read(model, tmp_path)[0]["nodes"][0]["subscribers"]
    assert (topic["qos"], topic["reliability"], topic["depth"]) == (None, "best_effort", 7)


@pytest.mark.parametrize(
    ("right", "wrong", "line", "message"),
    [
        ("nodl_version: 2", "nodl_version: 1", 1, "nodl_version: 1 is not read; allowed: 2"),
        ("nodl_version: 2", "other: 2", 1, "it has no nodl_version; a spec is XML, or NoDL"),
        ("nodl_version: 2", "nodl_version: 2\nother: 2", 2, 'unknown key "other"; allowed: nodl'),
        ("publishers", "publisher", 3, 'unknown key "publisher"; allowed: nodl_version'),
        ("name: speed", "name: 2fast", 4, '<directPublisher name="2fast">: name: "2fast" is not'),
        ("name: speed, ", "", 4, 'attribute "name" is missing'),
        ("std_msgs/Float64", "Float64", 4, 'type: "Float64" is not a type; it lacks its package'),
        ("RELIABLE", "FAST", 4, 'reliability: unknown "fast"; allowed: reliable'),
        ("depth: 3", "depth: none", 4, "depth: "),
        ("depth: 3", "keep: 3", 4, 'unknown key "keep"; allowed: history, depth'),
        ("type: double", "type: float128", 6, 'type: unknown "float128"; allowed: bool'),
        ("default_value: 1", "default_value: &x [*x]", 0, "an alias stands for what it is in"),
        ("default_value: 1", "default_value: 5", 6, "value: 5.0 must be at most 2.5"),
        ("default_value: 1", "default_value: [1, 2]", 6, 'value: "[1, 2]" is not a number'),
        ("validation: {", "validation: [", 0, "not YAML: "),
        ("publishers:\n  - {", "publishers: {a: {", 0, "not YAML: "),
        ("publishers:\n  - {name", "publishers:\n  {name", 1, "must be a list"),
        ("  gain:\n", "  gain: 2\n  g:\n", 6, "must be a mapping"),
        ("publishers:\n", "publishers:\n  - speed\n", 1, "must be a mapping"),
        (
            "publishers",
            "include: [{ref: 'nodl://a/b'}]\npublishers",
            3,
            '"nodl://a/b" is not read',
        ),
        ("publishers", "include: [{ref: 'local://b'}]\npublishers", 0, "b: no such file"),
        (
            "parameters",
            "codegen: {ros_package: {nodes: {}}}\nparameters",
            5,
            'unknown key "nodes"',
        ),
        (
            "parameters",
            "codegen: {ros_package: {node: {publisher: [{name: sped}]}}}\nparameters",
            5,
            'publisher: no "sped" is in publishers; drop it',
        ),
        (
            "parameters",
            "codegen: {ros_package: {node: {publisher: [{name: speed}]}}}\nparameters",
            4,
            'its <node> at line 1 must have the attribute "frequency"',
        ),
        (
            "parameters",
            "codegen: {ros_package: {node: {listener: [{name: tf, kind: x}]}}}\nparameters",
            5,
            '<listener name="tf">: unknown attribute "kind"',
        ),
    ],
)
def test_faults(node, right, wrong, line, message):
    """Each is named with its place, by the reader or by the checks of every spec."""
    file = node(right, wrong)
    with pytest.raises(SpecError) as error:
        read(MODELS["python_model"], file)
    place = f"{file}:{line}: " if line else str(file.parent)
    assert str(error.value).startswith(place), error.value
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("right", "wrong", "notes"),
    [
        (
            "parameters",
            "subscriptions:\n  - {name: a, type: std_msgs/String, qos: {lifespan_ns: 5,"
            " deadline_ns: 0, liveliness: MANUAL_BY_TOPIC}}\nparameters",
            ["6: lifespan_ns: 5", '6: liveliness: "MANUAL_BY_TOPIC"'],
        ),
        ("lt_eq: 2.5", "lt: 2.5", ["9: lt: 2.5"]),
        ("type: double", "type: byte_array", ['7: type: "byte_array"']),
        ("type: double", "type: double\n    read_only: true", ["8: read_only: true"]),
        (
            "parameters",
            "service_servers:\n  - {name: a, type: std_srvs/srv/Empty, qos: {durability:"
            " TRANSIENT_LOCAL}}\nparameters",
            ['6: durability: "TRANSIENT_LOCAL"'],
        ),
    ],
)
def test_left_out(node, right, wrong, notes):
    """What no spec can say is named with its place; the rest is read."""
    file = node(right, wrong)
    found = read(MODELS["python_model"], file)[1]
    assert found == [
        f"{file}:{note} is left out, for no spec can say it [left-out]" for note in notes
    ]


@pytest.mark.parametrize(
    ("given", "offered"),
    [
        ("deadline_ns: 0, lifespan_ns: 9223372036854775807, liveliness: AUTOMATIC", (None,) * 4),
        ("deadline_ns: 500000000", (0.5, None, None, None)),
        (
            "liveliness: MANUAL_BY_TOPIC, lifespan_ns: 2000000000, liveliness_lease_duration_ns:"
            " 1000000",
            (None, 2.0, "manual_by_topic", 0.001),
        ),
    ],
)
def test_what_publishers_offer(node, given, offered):
    """It is read, and said again."""
    model = MODELS["python_model"]
    context, notes = read(model, node("depth: 3", f"depth: 3, {given}"))
    (topic,) = context["nodes"][0]["directPublishers"]
    names = ("deadline", "lifespan", "liveliness", "liveliness_lease_duration")
    assert tuple(topic[name] for name in names) == offered
    assert notes == []
    (text,) = documents(model, context).values()
    said = yaml.safe_load(text)["publishers"][0]["qos"]
    was = yaml.safe_load(f"{{{given}}}")
    wanted = {name: was[name] for name in was if any(offered)}
    assert {name: said[name] for name in said if name in was} == wanted


@pytest.mark.parametrize("name", ["basic_node", "composed_node", "json_node", "alt_pkg_node"])
def test_examples_of_nodl(name):
    (file,) = NODL.glob(f"written/{name}.nodl.*")
    (node,) = read(MODELS["python_model"], file)[0]["nodes"]
    inside = [
        (key, each["name"])
        for key in ("directPublishers", "directSubscribers")
        for each in node[key]
    ]
    basic = [("directPublishers", "/chatter")]
    composed = [*basic, ("directSubscribers", "/composed_input")]
    assert inside == {"basic_node": basic, "composed_node": composed}.get(name, [])


def test_package_of_documents(collection, copier_command, tmp_path):
    """A folder of documents becomes a package, whose spec is XML as that of any other."""
    for file in NODL.glob("described/*"):
        (tmp_path / "described").mkdir(exist_ok=True)
        (tmp_path / "described" / file.name).write_text(file.read_text())
    copy = ("copy", "--trust", "--defaults", "-d", "model=python_model", "-d", "ros_distro=kilted")
    options = (*copy, "-d", "spec_file=described", collection)
    result = copier_command(*options, "robot", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    what = "s2_node.nodl.yaml:20: read_only: true"
    note = f"Note: described/{what} is left out, for no spec can say it [left-out]\n"
    assert note in result.stdout + result.stderr
    package = tmp_path / "robot"
    assert 'author="Test Er"' in (package / "robot.ros_package").read_text()
    nodes = yaml.safe_load((package / ".copier-answers.yml").read_text())["spec"]["nodes"]
    assert [node["name"] for node in nodes] == ["s1_node", "s2_node", "s3_node_a"]
    topics = [(each["name"], each["durability"]) for each in nodes[1]["directPublishers"]]
    assert topics == [("/s2/be_pub", None), ("/s2/tl_pub", "transient_local")]
    assert nodes[1]["directSubscribers"][0]["deadline"] == 2.0
    commit(package)
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    assert git(package, "status", "--short") == ""
    given = ("-d", "spec_file=../described")
    result = copier_command("update", "--trust", "--defaults", *given, cwd=package)
    assert result.returncode == 1
    assert "robot.ros_package is the spec of this package; change that file, and" in result.stderr
    (tmp_path / "described/odd-name.nodl.yaml").write_text("nodl_version: 2\n")
    result = copier_command(*options, "other", cwd=tmp_path)
    assert result.returncode == 1
    assert 'described/odd-name.nodl.yaml:1: <node name="odd-name">: name: ' in result.stderr
    assert not (tmp_path / "other").exists()


ODD = [
    None,
    0,
    -1,
    1.5,
    True,
    "",
    "x",
    "~",
    [],
    ["x"],
    [[1]],
    {},
    {"x": 1},
    {"name": "x"},
    "\u202e",
]


def changed(value, random):
    """Return a document with one thing in it exchanged for something odd."""
    if not isinstance(value, dict | list) or not value or random.random() < 0.1:
        return random.choice(ODD)
    keys = list(value) if isinstance(value, dict) else range(len(value))
    key = random.choice(keys)
    other = value.copy()
    if isinstance(value, dict) and random.random() < 0.1:
        other[random.choice(["x", "name", "type", "qos", "node"])] = other.pop(key)
    else:
        other[key] = changed(value[key], random)
    return other


def test_odd_documents(tmp_path):
    """Whatever stands in a document: it is read, or refused with a place in it."""
    model = MODELS["python_model"]
    spec = model.spec(model.small()).replace("<subscriber", '<subscriber qos="sensor_data"')
    texts = [*documents(model, model.context(spec, "kilted")).values(), NODE]
    texts += [file.read_text() for file in NODL.glob("described/*")]
    file = tmp_path / "driver.nodl.yaml"
    for number in range(600):
        random = Random(number)
        document = changed(yaml.safe_load(random.choice(texts)), random)
        file.write_text(yaml.safe_dump(document, sort_keys=False))
        try:
            read(model, file)
        except SpecError as error:
            assert all(line.startswith(f"{file}:") for line in str(error).split("\n")), error
