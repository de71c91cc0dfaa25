"""Random specs, and the ways they change."""

import copy
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


def random_spec(random, callbacks_only=False):
    """Return a spec of one to three nodes; one of them may have the name of the package."""
    names = random.sample(NODES, k=random.randint(1, 3))
    return {
        "description": "A package",
        "nodes": [
            {"name": name, "frequency": random.choice((1, 10, 50)), "items": items}
            for name in names
            for items in [random_items(random, callbacks_only)]
        ],
    }


def random_items(random, callbacks_only):
    kinds = sorted(CALLBACKS if callbacks_only else TYPES)
    names = random.sample(NAMES, k=random.randint(3, 8))
    return [
        {"kind": random.choice(kinds), "name": name, "type": random.randint(0, 1), "text": ""}
        for name in names
    ]


def change(random, spec, callbacks_only=False, ways=None):
    """Return a changed spec; the names of before are said where something was renamed."""
    spec = copy.deepcopy(spec)
    ways = ways or "add remove reorder replace retype describe rename swap frequency node".split()
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
        items[items.index(one)] = one | {"name": random.choice(free), "was": None}
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
    how = random.choice(("add", "remove", "rename"))
    if how == "remove" and len(nodes) > 1:
        nodes.remove(random.choice(nodes))
    elif how == "add" and free:
        items = random_items(random, callbacks_only)
        nodes.append({"name": random.choice(free), "frequency": 10, "items": items})
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
        was = f' was="{node["was"]}"' if node.get("was") else ""
        language = ("python", "cpp")[len(node.get("was") or node["name"]) % 2] if is_mixed else ""
        was += f' language="{language}"' if language else ""
        lines.append(f'  <node name="{node["name"]}" frequency="{node["frequency"]}"{was}>')
        for item in node["items"]:
            kind = item["kind"]
            types = CALLBACKS[kind][1] if kind in CALLBACKS else OTHERS[kind]
            text = f'    <{kind} name="{item["name"]}" description={quoteattr(item["text"])}'
            text += f' type="{types[item["type"]]}"' if types[0] else ""
            text += ' value="1"' if "arameter" in kind else ""
            text += f' was="{item["was"]}"' if item.get("was") else ""
            lines.append(text + "/>")
        lines.append("  </node>")
    return "\n".join([*lines, "</package>", ""])
