"""Random specs, and the ways they change."""

import copy
from random import Random
from xml.sax.saxutils import quoteattr

CALLBACKS = {
    "directSubscriber": ("receive_", ("std_msgs::Empty", "std_msgs::Bool")),
    "serviceServer": ("serve_", ("std_srvs::Trigger", "std_srvs::SetBool")),
    "actionServer": ("execute_", ("test_msgs::Fibonacci", "other_msgs::Move")),
}
OTHERS = {
    "publisher": ("std_msgs::String", "geometry_msgs::Point"),
    "subscriber": ("std_msgs::String", "sensor_msgs::Imu"),
    "directPublisher": ("std_msgs::Empty", "nav_msgs::Path"),
    "serviceClient": ("std_srvs::Trigger", "std_srvs::Empty"),
    "actionClient": ("test_msgs::Fibonacci", "other_msgs::Move"),
    "parameter": ("int", "double"),
    "dynParameter": ("int", "double"),
    "listener": ("", ""),
    "broadcaster": ("", ""),
}
TYPES = OTHERS | {kind: types for kind, (_, types) in CALLBACKS.items()}
NAMES = """load store estop home reset range map pose arm_state grip plan scan cloud track speed
    goal level mode tool power""".split()
NODES = "lab reach watch drive grasp map_server".split()
GROUPS = "common base output rest spare".split()
PARTS = {
    "message": ("",),
    "service": ("request", "response"),
    "action": ("goal", "result", "feedback"),
}
FIELDS = ("float64", "string[]", "geometry_msgs::Point", "int8[3]")


def random_spec(random, callbacks_only=False):
    """Return a spec of one to three nodes; one of them may have the name of the package."""
    names = random.sample(NODES, k=random.randint(1, 3))
    return {
        "description": "A package",
        "nodes": [
            {"name": name, "frequency": random.choice((1, 10, 50)), "items": items, "group": group}
            for name, group in zip(names, GROUPS, strict=False)
            for items in [random_items(random, callbacks_only)]
        ],
    }


def random_items(random, callbacks_only):
    kinds = sorted(CALLBACKS if callbacks_only else TYPES)
    names = random.sample(NAMES, k=random.randint(3, 8))
    own = Random(str(names))  # so that what is drawn from `random` stays what it was
    share = own.choice((0, 0, 0.5))
    return [
        {
            "kind": random.choice(kinds),
            "name": name,
            "type": random.randint(0, 1),
            "text": "",
            "is_shared": own.random() < share,  # it stands in the group of the node
        }
        for name in names
    ]


def random_interfaces(random):
    """Return a spec of messages, services and actions."""
    spec = {"description": "Messages", "nodes": [], "types": []}
    for _ in range(random.randint(1, 4)):
        _add_type(random, spec)
    return spec


def _add_type(random, spec):
    kind = random.choice(sorted(PARTS))
    free = [name for name in NAMES if name not in {n for t in spec["types"] for n in names_of(t)}]
    parts = {
        part: [_field(random, name) for name in random.sample(NAMES, k=random.randint(0, 4))]
        for part in PARTS[kind]
    }
    spec["types"].append({"kind": kind, "name": random.choice(free), "parts": parts})


def _field(random, name):
    return {"name": name, "type": random.choice(FIELDS), "text": random.choice(("", "Size, m"))}


def change_interfaces(random, spec):
    """Return a changed spec of messages, services and actions."""
    spec = copy.deepcopy(spec)
    for how in random.sample("type field remove reorder rename describe retype".split(), k=3):
        one = random.choice(spec["types"])
        fields = random.choice([*one["parts"].values()])
        taken = {name for field in fields for name in names_of(field)}
        free = [name for name in NAMES if name not in taken]
        if how == "type":
            _add_type(random, spec)
        elif how == "field":
            fields.insert(random.randint(0, len(fields)), _field(random, random.choice(free)))
        elif not fields or (how == "rename" and not free):
            continue
        elif how == "remove":
            fields.pop()
        elif how == "reorder":
            random.shuffle(fields)
        elif how == "rename":
            fields[0]["was"], fields[0]["name"] = fields[0]["name"], random.choice(free)
        elif how == "describe":
            fields[0]["text"] = "What it is for"
        else:
            fields[0]["type"] = random.choice(FIELDS)
    return spec


def change(random, spec, callbacks_only=False, ways=None):
    """Return a changed spec; the names of before are said where something was renamed."""
    if "types" in spec:
        return change_interfaces(random, spec)
    spec = copy.deepcopy(spec)
    ways = (
        ways
        or "add remove reorder replace retype describe rename swap share frequency node".split()
    )
    for _ in range(random.randint(1, 3)):
        _change(random, spec, random.choice(ways), callbacks_only)
    return spec


def _change(random, spec, how, callbacks_only):
    node = random.choice(spec["nodes"])
    items = node["items"]
    free = [name for name in NAMES if name not in names(node)]
    one = random.choice(items) if items else None
    if how == "add" and free:
        new = random_items(random, callbacks_only)[0] | {"name": random.choice(free)}
        items.insert(random.randint(0, len(items)), new)
    elif how == "node":
        _change_nodes(random, spec, callbacks_only)
    elif how == "frequency":
        node["frequency"] = random.choice((1, 10, 50))
    elif not one:
        return
    elif how == "remove":
        items.remove(one)
    elif how == "reorder":
        random.shuffle(items)
    elif how == "replace" and free:
        name = random.choice(free)
        items[items.index(one)] = one | {"name": name, "was": None, "id": None}
    elif how == "share":
        one["is_shared"] = not one["is_shared"]
    elif how == "retype":
        one["type"] = 1 - one["type"]
    elif how == "describe":
        one["text"] = random.choice(("what it is for", 'it\'s <odd> & "quoted"', "Länge, m"))
    elif how == "rename" and free and not one.get("was"):
        one["was"], one["name"] = one["name"], random.choice(free)
    elif how == "swap":
        same = [item for item in items if item["kind"] == one["kind"] and not item.get("was")]
        if len(same) > 1 and one in same:
            other = random.choice([item for item in same if item is not one])
            one["was"], other["was"] = one["name"], other["name"]
            one["name"], other["name"] = other["name"], one["name"]


def _change_nodes(random, spec, callbacks_only):
    nodes = spec["nodes"]
    free = [name for name in NODES if name not in {n for node in nodes for n in names_of(node)}]
    groups = [name for name in GROUPS if name not in {node["group"] for node in nodes}]
    how = random.choice(("add", "remove", "rename"))
    if how == "remove" and len(nodes) > 1:
        nodes.remove(random.choice(nodes))
    elif how == "add" and free and groups:
        items = random_items(random, callbacks_only)
        name = random.choice(free)
        nodes.append({"name": name, "frequency": 10, "items": items, "group": groups[0]})
    elif how == "rename" and free:
        node = random.choice(nodes)
        if not node.get("was"):
            node["was"], node["name"] = node["name"], random.choice(free)


def settled(spec):
    """Return a spec whose renames are done."""
    spec = copy.deepcopy(spec)
    for node in spec["nodes"]:
        for item in (node, *node["items"]):
            item.pop("was", None)
    return spec


def names(node):
    """Return the names that the interfaces of a node have and had."""
    return {name for item in node["items"] for name in names_of(item)}


def names_of(item):
    return {item["name"], item.get("was") or item["name"]}


def callbacks(node):
    """Return the callbacks of a node, each with the name it had."""
    found = {}
    for item in node["items"]:
        if item["kind"] in CALLBACKS:
            prefix = CALLBACKS[item["kind"]][0]
            found[prefix + item["name"]] = prefix + (item.get("was") or item["name"])
    return found


def xml(spec, model=""):
    """Write a spec; nodes are in the one or the other language where a model has both."""
    is_mixed = model.startswith("mixed")
    lines = [
        '<package name="lab" author="A" author_email="a@example.org" license="MIT"'
        f" description={quoteattr(spec['description'])}>"
    ]
    for node in spec["nodes"]:
        if shared := [item for item in node["items"] if item.get("is_shared")]:
            lines += [f'  <group name="{node["group"]}">', *map(_item, shared), "  </group>"]
    for node in spec["nodes"]:
        was = f' was="{node["was"]}"' if node.get("was") else ""
        language = ("python", "cpp")[len(node.get("was") or node["name"]) % 2] if is_mixed else ""
        was += f' language="{language}"' if language else ""
        lines.append(f'  <node name="{node["name"]}" frequency="{node["frequency"]}"{was}>')
        is_shared = [item.get("is_shared") for item in node["items"]]
        lines += [f'    <use group="{node["group"]}"/>'] if any(is_shared) else []
        lines += [_item(item) for item in node["items"] if not item.get("is_shared")]
        lines.append("  </node>")
    for type_ in spec.get("types", ()):
        lines += _type(type_)
    return "\n".join([*lines, "</package>", ""])


def _item(item):
    kind = item["kind"]
    types = CALLBACKS[kind][1] if kind in CALLBACKS else OTHERS[kind]
    text = f'    <{kind} name="{item["name"]}" description={quoteattr(item["text"])}'
    text += f' type="{types[item["type"]]}"' if types[0] else ""
    text += ' value="1"' if "arameter" in kind else ""
    text += f' was="{item["was"]}"' if item.get("was") else ""
    return text + "/>"


def _type(type_):
    name = "".join(word.capitalize() for word in type_["name"].split("_"))
    yield f'  <{type_["kind"]} name="{name}">'
    for part, fields in type_["parts"].items():
        yield f"    <{part}>" if part else ""
        for field in fields:
            text = f'      <field name="{field["name"]}" type="{field["type"]}"'
            text += f" description={quoteattr(field['text'])}"
            yield text + (f' was="{field["was"]}"/>' if field.get("was") else "/>")
        yield f"    </{part}>" if part else ""
    yield f"  </{type_['kind']}>"
