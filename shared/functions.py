"""NoDL, by which tools of ROS 2 describe nodes: what a spec says, in version 2 of it, and back.

https://nodl.readthedocs.io has the format. What it has no word for stands below its key `codegen`
as `ros_package`: the attributes of the node and, in the document of the first one, of the package;
and lists of what is inside, by tag. An interface that NoDL does say is in such a list where there
is more to say of it, or where it is of a kind that NoDL makes no difference for (decision 118).
"""

from __future__ import annotations

import json
import re
import runpy
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, TypeAlias

import yaml

Tree: TypeAlias = tuple[Any, Any, Any]
"""A tag, attributes, and what is inside: trees, or a text."""
Values: TypeAlias = dict[Any, Any]

_QOS = runpy.run_path(str(Path(__file__).parents[1] / "extensions/qos.py"))
_qos, _offered = _QOS["qos"], _QOS["offered"]

_VERSION = 2
_TOOL = "ros_package"
_KINDS = {
    "parameters": ("parameter", "dynParameter"),
    "publishers": ("directPublisher", "publisher"),
    "subscriptions": ("directSubscriber", "subscriber", "input"),
    "service_servers": ("serviceServer",),
    "service_clients": ("serviceClient",),
    "action_servers": ("actionServer",),
    "action_clients": ("actionClient",),
}
"""The interface kinds of each list of NoDL; those of a document of others are the first ones."""
_LIST_OF = {kind: each for each, kinds in _KINDS.items() for kind in kinds}
_OWN = ("package", "node")
_TEXTS = ("depend", "node")
"""The tags of `ros_package` whose lists are of texts."""
_KEYS = ("nodl_version", "description", "codegen", "include", *_KINDS)
_TOPICS = ("publishers", "subscriptions")
_SERVICES = ("service_servers", "service_clients")
_SAID = ("name", "type", "description")
_POLICIES = ("history", "depth", "reliability", "durability")
_REST_OF_QOS = ("deadline_ns", "lifespan_ns", "liveliness", "liveliness_lease_duration_ns")
_OFFERS = {"publishers": _REST_OF_QOS, "subscriptions": ("deadline_ns",)}
"""What is read of the rest; a node does not ask for the deadline that it watches."""
_REST_OF_PARAMETER = ("read_only", "additional_constraints")
_WITHOUT_END = 2**63 - 1  # ns
_NOTHING = (None, "", 0, False, "AUTOMATIC", "SYSTEM_DEFAULT", "BEST_AVAILABLE", _WITHOUT_END)
"""What the rest of NoDL says where it asks for nothing that a node does not do anyway."""
_STATIC = {"reliability": "reliable", "durability": "transient_local", "history": "keep_last"}
_TF = "tf2_msgs/msg/TFMessage"
_IMPLIED: dict[str, list[tuple[str, str, str, Values]]] = {
    "node": [
        ("parameters", "autostart", "bool", {"value": True}),
        ("parameters", "stop_timeout", "double", {"value": 2.0}),
        ("publishers", "~/transition_event", "lifecycle_msgs/msg/TransitionEvent", {}),
        ("service_servers", "~/change_state", "lifecycle_msgs/srv/ChangeState", {}),
        ("service_servers", "~/get_state", "lifecycle_msgs/srv/GetState", {}),
        *(
            ("service_servers", f"~/get_{what}", f"lifecycle_msgs/srv/GetAvailable{type_}", {})
            for what, type_ in (
                ("available_states", "States"),
                ("available_transitions", "Transitions"),
                ("transition_graph", "Transitions"),
            )
        ),
    ],
    "frequency": [("parameters", "frequency", "double", {})],
    "diagnostics": [("publishers", "/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", {})],
    "broadcaster": [
        ("publishers", "/tf", _TF, {"depth": 100}),
        ("publishers", "/tf_static", _TF, _STATIC | {"depth": 1}),
    ],
    "listener": [
        ("subscriptions", "/tf", _TF, {"depth": 100}),
        ("subscriptions", "/tf_static", _TF, _STATIC | {"depth": 100}),
    ],
}
"""What every node of a package has, and what an attribute or a kind brings along."""
_OF_ROS = r"start_type_description_service|use_sim_time|qos_overrides\..*"
"""The parameters of every node of ROS."""
_BOUNDS = {"gt_eq": "min", "lt_eq": "max"}


def nodl(package: Tree, name: str) -> str:
    """Return the NoDL document of a node of a package, as YAML."""
    document: Values = {"nodl_version": _VERSION, **{each: [] for each in _KINDS}}
    nodes = [each for each in package[2] if each[0] == "node"]
    _, given, inside = next(each for each in nodes if each[1]["name"] == name)
    own: dict[str, Values] = {"package": {}, "node": {**given}}
    del own["node"]["name"]
    if nodes[0][1]["name"] == name:
        names = [each[1]["name"] for each in nodes]
        own["package"] = {**package[1], **({"node": names} if names != sorted(names) else {})}
        for each in package[2]:
            if each[0] != "node":
                _put(own["package"], each[0], _entry(each))
    for each in inside:
        _say(document, own["node"], each)
    brought = ["node", *(word for word in given if given[word]), *(each[0] for each in inside)]
    for word in dict.fromkeys(brought):
        for list_, entity, type_, more in _IMPLIED.get(word, ()):
            value = {"value": given[word]} if word in given else {}
            item = {"name": entity, "type": type_, **value, **more}
            _put(document, list_, _Line(_said(list_, item)))
    document["parameters"] = {each["name"]: _nameless(each) for each in document["parameters"]}
    document["codegen"] = {_TOOL: {tag: values for tag, values in own.items() if values}}
    said = {key: value for key, value in document.items() if value}
    return str(yaml.dump(said, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=10**6))


def _nameless(item: Values) -> Values:
    return type(item)((key, value) for key, value in item.items() if key != "name")


class _Line(dict[str, Any]):
    """A mapping that stands on one line."""


class _Dumper(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
    """Writes lists of values on one line, and no aliases; in C where PyYAML has it."""

    def ignore_aliases(self, data: Any) -> bool:
        return True

    def list_node(self, data: list[Any]) -> Any:
        is_flat = not any(isinstance(each, dict) for each in data)
        return self.represent_sequence("tag:yaml.org,2002:seq", data, flow_style=is_flat)

    def line_node(self, data: _Line) -> Any:
        return self.represent_mapping("tag:yaml.org,2002:map", data.items(), flow_style=True)


_Dumper.add_representer(list, _Dumper.list_node)
_Dumper.add_representer(_Line, _Dumper.line_node)


def _put(owner: Values, tag: str, entry: Any) -> None:
    owner.setdefault(tag, []).append(entry)


def _entry(element: Tree) -> Any:
    """Return what stands in a list of `ros_package` for an element."""
    _, given, inside = element
    if isinstance(inside, str):
        return _Line({**given, "#text": inside}) if given else inside
    entry = _Line(given)
    for each in inside:
        _put(entry, each[0], _entry(each))
    return entry


def _say(document: Values, own: Values, element: Tree) -> None:
    """Say an interface in NoDL; and beside, what reading that again would not give."""
    kind, entry = element[0], _entry(element)
    if kind not in _LIST_OF or "for_each" in entry:  # of several topics, NoDL knows no names
        inside = [each for each in element[2] if each[0] in _LIST_OF]
        for each in inside:  # such as the inputs of a synchronizer
            entry.pop(each[0], None)
        for each in inside:
            _say(document, entry, each)
        _put(own, kind, entry)
        return
    list_ = _LIST_OF[kind]
    said = _said(list_, entry)
    _put(document, list_, said)
    read = {} if _is_implied(list_, said, True) else _read(list_, said, [])
    rest = {name: value for name, value in entry.items() if read.get(name) != value}
    if _is_qos(rest):
        rest |= {name: value for name, value in entry.items() if _is_qos({name})}
    if rest:
        _put(own, kind, _Line({"name": entry["name"], **rest}))
    elif kind != _KINDS[list_][0]:
        _put(own, kind, entry["name"])


def _said(list_: str, given: Values) -> Values:
    """Return what NoDL says of an interface."""
    if list_ == "parameters":
        return _parameter(given)
    said = {name: given[name] for name in _SAID if name in given}
    is_told = list_ in _TOPICS or (list_ in _SERVICES and _is_qos(given))
    more = _offers(given) if list_ == "publishers" else {}
    return {**said, "qos": _Line(_words(given) | more)} if is_told else said


def _is_implied(list_: str, item: Values, is_own: bool) -> bool:
    """Tell whether a node of a package has what NoDL says, without being told.

    A document of others may say `/tf`, and be of a node that has no other way to it.
    """
    name, type_ = str(item.get("name")), item.get("type")
    if list_ == "parameters":
        names = [entry[1] for part in _IMPLIED.values() for entry in part if entry[0] == list_]
        return name in names or bool(re.fullmatch(_OF_ROS, name))
    for word, entries in _IMPLIED.items():
        for each, known, known_type, _ in entries:
            alike = name == known or (known[0] == "~" and name.endswith(known[1:]))
            if (each, known_type) == (list_, type_) and alike and (is_own or word == "node"):
                return True
    return False


def _is_qos(names: Iterable[str]) -> bool:
    return not {"qos", *_POLICIES}.isdisjoint(names)


def _words(given: Values) -> Values:
    """Return the policies of a topic in NoDL's words; no depth where the middleware chooses it."""
    policies = {name: _qos(given)[name] for name in _POLICIES}
    words = {name: word if name == "depth" else word.upper() for name, word in policies.items()}
    return {name: word for name, word in words.items() if word}


def _offers(given: Values) -> Values:
    """Return what a publisher offers besides in NoDL's words."""
    words = _offered(given)
    times = {name: value for name, value in words.items() if name != "liveliness"}
    said = {f"{name}_ns": round(value * 1e9) for name, value in times.items()}
    return said | {"liveliness": words["liveliness"].upper()} if times != words else said


def _parameter(given: Values) -> Values:
    said = {"name": given["name"], "type": given["type"].replace("[]", "_array")}
    if "value" in given:
        said["default_value"] = given["value"]
    if "description" in given:
        said["description"] = given["description"]
    rules = {rule: given[word] for rule, word in _BOUNDS.items() if word in given}
    if len(rules) == len(_BOUNDS):
        rules = {"bounds": list(rules.values())}
    if "choices" in given:
        rules["one_of"] = [given["choices"]]
    return {**said, "validation": rules} if rules else said


def spec_from_yaml(files: list[str], load: Callable[[str], Any]) -> tuple[Tree, list[str]]:
    """Return the package that documents of NoDL describe, each a node by the name of its file.

    And a note for each thing that is left out, for no spec can say it.

    Raises:
        ValueError: a document is none of this version of NoDL, or contradicts another.

    """
    notes: list[str] = []
    package: Values = {}
    order: list[str] = []
    others: list[Tree] = []
    nodes: list[Tree] = []
    for file in files:
        documents = list(_documents(file, load, set()))
        first = documents[0]
        at = next(iter(first))
        own = _mapping(at, _mapping(at, first.get("codegen", {})).get(_TOOL, {}), _OWN)
        given, inside = _divided(at, own.get("package", {}))
        order = inside.pop("node", order)
        for key, value in given.items():
            if package.setdefault(key, value) != value:
                what = f'{key}: "{value}" here, "{package[key]}" in another file'
                raise _fault(key, what, "nodl-contradiction")
        others += [_element(tag, each) for tag, entries in inside.items() for each in entries]
        if len(files) == 1 and first.get("description"):
            package.setdefault("description", first["description"])
        else:
            _leave_out(first, ["description"], notes)
        given, kinds = _divided(at, own.get("node", {}))
        for each in _listed("parameters", documents):
            if each["name"] == "frequency":
                given.setdefault("frequency", each.get("default_value"))
        name = Path(file).name.partition(".")[0]
        interfaces = list(_interfaces(documents, kinds, bool(own), notes))
        nodes.append((at.here("node"), {"name": name, **given}, interfaces))
    nodes.sort(key=lambda each: order.index(each[1]["name"]) if each[1]["name"] in order else -1)
    return (nodes[0][0].here("package"), package, [*others, *nodes]), notes


def _documents(file: str, load: Callable[[str], Any], seen: set[str]) -> Iterator[Values]:
    """Yield a document and those that it includes."""
    seen.add(file)
    loaded = load(file) or None
    if isinstance(loaded, dict) and "nodl_version" not in loaded:
        what = f"it has no nodl_version; a spec is XML, or NoDL of version {_VERSION}"
        raise _fault(f"{file}:1", what, "nodl-version")
    document = _mapping(f"{file}:1", loaded, _KEYS)
    version = document["nodl_version"]
    if version != _VERSION:
        what = f"nodl_version: {version} is not read; allowed: {_VERSION}"
        raise _fault(document, what, "nodl-version")
    yield document
    for each in _items(document, document.get("include", [])):
        ref = _mapping(document, each, ["ref"])["ref"]
        other = str(Path(file).parent / str(ref).removeprefix("local://"))
        if not str(ref).startswith("local://"):
            what = f'include: "{ref}" is not read; allowed: local://FILE'
            raise _fault(ref, what, "nodl-include")
        if other in seen:
            what = f'include: "{ref}" is included twice; drop one'
            raise _fault(ref, what, "nodl-include")
        yield from _documents(other, load, seen)


def _interfaces(
    documents: list[Values], kinds: Values, is_own: bool, notes: list[str]
) -> Iterator[Tree]:
    """Yield the interfaces of a node; `kinds` has what NoDL does not say of them, by tag."""
    more: dict[tuple[str, str], list[Tree]] = {}
    inner: list[Values] = []
    """The attributes of what stands within another interface, which has been yielded."""

    def is_whole(each: Tree) -> bool:
        """Tell whether all of an interface is here; else wait for the rest."""
        is_there = each[0] not in _LIST_OF or "type" in each[1]
        if not is_there:
            more.setdefault((_LIST_OF[each[0]], str(each[1].get("name"))), []).append(each)
        return is_there

    for kind, entries in kinds.items():
        for entry in entries:
            each = _element(kind, entry)
            if is_whole(each):
                yield each
                parts = each[2] if isinstance(each[2], list) else []
                inner += [part[1] for part in parts if not is_whole(part)]
    for list_ in _KINDS:
        for item in _listed(list_, documents):
            read = {} if _is_implied(list_, item, is_own) else _read(list_, item, notes)
            if not read:
                continue
            kinds_of = more.get((list_, str(read.get("name")))) or [(_KINDS[list_][0], {}, [])]
            kind, own, inside = kinds_of.pop(0)
            rest = dict(own)
            if _is_qos(rest):  # it says how the policies come about, where they still do
                if _are_words(rest, item.get("qos", {})):
                    read = _without_qos(read)
                else:
                    rest = _without_qos(rest)
            if any(own is each for each in inner):
                own.clear()
                own.update({**read, **rest})
            else:
                yield next(iter(item)).here(kind), {**read, **rest}, inside
    for (list_, name), left in more.items():
        for kind, _, _ in left:
            what = f'{kind}: no "{name}" is in {list_}; drop it'
            raise _fault(kind, what, "nodl-contradiction")


def _without_qos(given: Values) -> Values:
    return {name: value for name, value in given.items() if not _is_qos([name])}


def _are_words(given: Values, qos: Values) -> bool:
    try:
        return _words(given) == {name: qos[name] for name in _POLICIES if name in qos}
    except (AttributeError, KeyError, TypeError):  # a word that is none: left to the check
        return True


def _listed(list_: str, documents: list[Values]) -> Iterator[Values]:
    """Yield what the documents have in a list, or, of parameters, in a mapping by name."""
    for document in documents:
        if list_ == "parameters":
            for name, each in _mapping(document, document.get(list_, {})).items():
                yield {name.here("name"): name, **_mapping(name, each)}
        else:
            for each in _items(document, document.get(list_, [])):
                yield _mapping(document, each or None)


def _read(list_: str, item: Values, notes: list[str]) -> Values:
    """Return the attributes of an interface that NoDL describes; none for what no spec can say."""
    if list_ == "parameters":
        return _read_parameter(item, notes)
    _mapping(item, item, (*_SAID, "qos") if not list_.startswith("action") else _SAID)
    read = {name: item[name] for name in _SAID if item.get(name, "") != ""}
    qos = _mapping(item, item.get("qos", {}), (*_POLICIES, *_REST_OF_QOS))
    known = _OFFERS.get(list_, ())
    _leave_out(qos, set(_REST_OF_QOS) - set(known), notes)
    for key in set(known) & set(qos):
        value = qos[key]
        if not isinstance(value, list | dict) and value in _NOTHING:
            continue
        if isinstance(value, int | float):
            value = value / 1e9
        read[key.removesuffix("_ns")] = value.lower() if isinstance(value, str) else value
    default = _qos({})
    for name in _POLICIES:
        word = str(qos[name]).lower() if name in qos and name != "depth" else qos.get(name)
        has_meaning = name != "depth" or read.get("history") != "keep_all"
        if word in (None, default[name]) or not has_meaning:
            continue
        if name == "durability" and list_ in _SERVICES:  # they keep nothing (decision 131)
            _leave_out(qos, [name], notes)
        else:
            read[name] = word
    return read


def _read_parameter(item: Values, notes: list[str]) -> Values:
    known = ("name", "type", "default_value", "description", "validation", *_REST_OF_PARAMETER)
    _mapping(item, item, known)
    type_ = re.sub(r"_fixed_\d+$", "", str(item.get("type")))
    if type_ in ("none", "byte_array"):
        _leave_out(item, ["type"], notes)
        return {}
    read = {name: item[name] for name in _SAID if item.get(name, "") != ""}
    read["type"] = type_.replace("_array", "[]")
    read["value"] = item.get("default_value")
    _leave_out(item, ["type"] if type_ != item.get("type") else [], notes)
    _leave_out(item, _REST_OF_PARAMETER, notes)
    for rule, value in _mapping(item, item.get("validation", {})).items():
        name = rule.removesuffix("<>")
        values = value if isinstance(value, list) else [value]
        if name == "bounds" and len(values) == len(_BOUNDS):
            read |= dict(zip(_BOUNDS.values(), values, strict=True))
        elif name in _BOUNDS and len(values) == 1:
            read[_BOUNDS[name]] = values[0]
        elif name == "one_of" and len(values) == 1:
            read["choices"] = values[0]
        else:
            _note(rule, rule, value, notes)
    return {name: value for name, value in read.items() if value is not None}


def _element(tag: Any, entry: Any) -> Tree:
    """Return what an entry of `ros_package` is for: a text is a name, or what is inside."""
    if not isinstance(entry, dict):
        at = getattr(entry, "here", tag.here)(tag)
        return (at, {"name": entry}, []) if tag in _LIST_OF else (at, {}, str(entry))
    at = next(iter(entry), tag).here(tag)
    given, inside = _divided(at, entry)
    text = given.pop("#text", None)
    if text is not None:
        return at, given, str(text)
    return at, given, [_element(key, each) for key, entries in inside.items() for each in entries]


def _divided(at: Any, owner: Any) -> tuple[Values, dict[Any, list[Any]]]:
    """Return attributes, and the lists of what is inside, by tag: a list of values is neither."""
    items = _mapping(at, owner).items()
    inside = {
        key: value
        for key, value in items
        if isinstance(value, list)
        and (key in _TEXTS or key in _LIST_OF or any(isinstance(each, dict) for each in value))
    }
    return {key: value for key, value in items if key not in inside}, inside


def _leave_out(item: Values, names: Iterable[str], notes: list[str]) -> None:
    for name, value in item.items():
        if name in names and value not in _NOTHING:
            _note(name, name, value, notes)


def _note(at: Any, name: str, value: Any, notes: list[str]) -> None:
    said = json.dumps(value, default=str)[:60]
    what = f"{name}: {said} is left out, for no spec can say it [left-out]"
    notes.append(f"{getattr(at, 'place', '')}: {what}")


def _mapping(at: Any, value: Any, known: Iterable[str] = ()) -> Values:
    if not isinstance(value, dict):
        raise _fault(at, "must be a mapping", "wrong-shape")
    names = list(known)
    for key in value:
        if names and key not in names:
            what = f'unknown key "{key}"; allowed: {", ".join(names)}'
            raise _fault(key, what, "unknown-key")
    return value


def _items(at: Any, value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise _fault(at, "must be a list", "wrong-shape")
    return value


def _fault(at: Any, what: str, id_: str) -> ValueError:
    """Return a fault at a text of a document, or at the first of a mapping."""
    at = next(iter(at), "") if isinstance(at, dict) else at
    return ValueError(f"{getattr(at, 'place', at)}: {what}", id_)


def check_interface(kind: str, attributes: dict[str, Any], ros_distro: str) -> None:
    """Refuse a parameter that dynamic_reconfigure cannot have."""
    if ros_distro != "noetic" or kind != "dynParameter":
        return
    if attributes["type"].endswith("[]"):
        what = "dynamic_reconfigure has no lists; use <parameter>"
        raise ValueError(what, "not-in-dynamic-reconfigure")
    if "." in attributes["name"]:
        what = "dynamic_reconfigure has no nested names; use <parameter>"
        raise ValueError(what, "not-in-dynamic-reconfigure")
    for name in ("value", "min", "max"):
        value = attributes[name]
        if is_wide(value):
            what = f"{name}: {value} does not fit the 32 bits of dynamic_reconfigure"
            raise ValueError(what, "not-in-dynamic-reconfigure")


def is_wide(value: Any) -> bool:
    """Tell whether an integer, or one of a list, has more than the 32 bits that ROS 1 stores."""
    each = value if isinstance(value, list) else [value]
    return any(isinstance(one, int) and not -(2**31) <= one < 2**31 for one in each)


def dependencies_from_component(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that a node or a definition needs besides those of what is in it."""
    if kind == "action":
        return ["actionlib_msgs", "std_msgs"] if ros_distro == "noetic" else ["action_msgs"]
    return ["diagnostic_msgs"] if attributes.get("diagnostics") else []


def cfg_constants(parameter: dict[str, Any]) -> dict[str, Any]:
    """Return the choices of a parameter by names for constants; none for texts that break code.

    dynamic_reconfigure writes them into C++ as they are, into texts in quotes, too.
    """
    choices = parameter["choices"] or []
    are_plain = all(re.fullmatch(r"[\w .+-]+", str(choice), re.ASCII) for choice in choices)
    name = parameter["name"]
    names = {f"{name}__{re.sub(r'[^a-zA-Z0-9]', '_', str(choice))}": choice for choice in choices}
    return names if are_plain and len(names) == len(choices) else {}


def launched(node: dict[str, Any]) -> list[str]:
    """Return the names by which the launch file starts a node."""
    return [instance["name"] for instance in node["instances"]] or [node["name"]]


def inputs(node: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the inputs of the synchronizers of a node, each with its `synchronizer`."""
    return [
        {**item, "synchronizer": each["name"]}
        for each in node["synchronizers"]
        for item in each["inputs"]
    ]


def watched(node: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the topics of a node that are late when no message comes for their deadline."""
    return [each for each in node["subscribers"] + node["directSubscribers"] if each["deadline"]]


def exact_synchronizers(spec: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the synchronizers of a package that join messages whose stamps are equal."""
    return [each for node in spec["nodes"] for each in node["synchronizers"] if not each["slop"]]


def approximate_synchronizers(spec: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the synchronizers of a package whose messages may be some time apart."""
    return [each for node in spec["nodes"] for each in node["synchronizers"] if each["slop"]]


def groups_of(spec: dict[str, Any], node: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the groups that a node uses, in its order."""
    groups = {group["name"]: group for group in spec["groups"]}
    return [groups[use["group"]] for use in node["uses"]]


def users_of(spec: dict[str, Any], group: dict[str, Any]) -> list[str]:
    """Return the names of the nodes that use a group."""
    uses = ((node["name"], use["group"]) for node in spec["nodes"] for use in node["uses"])
    return [name for name, used in uses if used == group["name"]]


def base(group: dict[str, Any], of: str) -> str:
    """Return the type that nodes with a group have in common: its `Config`, `Data` or other.

    Nothing where the group has nothing that it would hold.
    """
    kinds = {"Config": ["parameters", "dynParameters"], "Data": ["publishers", "subscribers"]}
    is_there = of not in kinds or any(group[kind] for kind in kinds[of])
    return f"{group['class_name']}{of}" if is_there else ""


def in_brackets(names: list[str]) -> str:
    """Return the bases of a class in Python; nothing for none."""
    return f"({', '.join(names)})" if names else ""


def used_by(groups: list[dict[str, Any]], nodes: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return those of the groups that some of the nodes use."""
    names = {use["group"] for node in nodes for use in node["uses"]}
    return [group for group in groups if group["name"] in names]
