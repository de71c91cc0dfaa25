"""Specs that try out all a dictionary allows, and packages rendered from them.

It serves the model in whose repository it stands, or each model of a collection.
"""

import copy
import importlib
import importlib.util
import os
import shutil
import subprocess
import tempfile
import warnings
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import product
from pathlib import Path
from unittest import mock

import copier
import yaml
from copier._main import Worker
from copier.errors import UserMessageError

from hooks.dictionary import PACKAGE
from hooks.faults import SpecError
from hooks.model import Model as Hook
from hooks.ros import DISTROS

ROOT = Path(__file__).parents[2]
SAMPLES = {
    "text": ("some text", "other text"),
    "raw": ("some text", "other text"),
    "identifier": ("some_word", "other_word"),
    "component_name": ("some_part", "other_part"),
    "grouped_name": ("some_word", "other.word"),
    "dotted_name": ("some_word", "other.word"),
    "package_name": ("some_package", "other_package"),
    "dependency": ("std_msgs", "std_srvs"),
    "relative_name": ("some_name", "other/name"),
    "ros_name": ("some_name", "other/name", "~/own_name"),
    "topic_name": ("/some/topic", "other_topic"),
    "message_type": ("std_msgs/msg/String", "std_msgs/msg/Bool"),
    "stamped_type": ("geometry_msgs/msg/PointStamped", "geometry_msgs/msg/TwistStamped"),
    "service_type": ("std_srvs/srv/Trigger", "std_srvs/srv/SetBool"),
    "action_type": ("test_msgs/action/Fibonacci", "test_msgs/action/NestedMessage"),
    "interface_name": ("SomeType", "OtherType"),
    "field_name": ("some_field", "other_field"),
    "constant_name": ("SOME_VALUE", "OTHER_VALUE"),
    "field_type": ("float64", "bool", "std_msgs/msg/String[]"),
    "number": ("2.5", "3.5"),
    "bool": ("true", "false"),
    "int": ("2", "3"),
    "double": ("2.5", "3.5"),
    "string": ("some string", "other string"),
    "wstring": ("some string", "other string"),
    "email": ("ada@example.org", "bob@example.org"),
    "license": ("MIT", "Apache-2.0"),
    "version": ("1.2.0", "0.1.3"),
    "url": ("https://example.org/some", "https://example.org/other"),
    "file_name": ("some-file", "other.file"),
}


SAMPLES |= {f"{sign}int{bits}": SAMPLES["int"] for sign in ("", "u") for bits in (8, 16, 32, 64)}
SAMPLES |= dict.fromkeys(("byte", "char"), SAMPLES["int"])
SAMPLES |= dict.fromkeys(("float32", "float64"), SAMPLES["double"])


HOSTILE = """ '\'\'\' \"\"\" <b> & \\ {{ 1 }} {% x %} */ # --> %s $x """.strip()


@dataclass(frozen=True)
class Owner:
    """What has attributes in a dictionary: the package, a component tag or an interface kind."""

    attributes: dict
    path: tuple = ()
    """The tags that it stands in, and its own."""

    @property
    def component(self):
        return self.path[0] if self.path else ""

    @property
    def kind(self):
        return self.path[-1] if len(self.path) > 1 else ""

    def __str__(self):
        return " ".join(self.path) or PACKAGE


class Model:
    """A model of this repository, with what is needed to try it out."""

    def __init__(self, folder):
        self.folder = folder
        self.name = folder.name

    def __repr__(self):
        return self.name

    @cached_property
    def hook(self):
        return Hook(self.folder, ROOT)

    @cached_property
    def distros(self):
        """The ROS distributions that the model's questions allow."""
        for part in yaml.compose_all((self.folder / "copier.yml").read_text()):
            for key, value in part.value if isinstance(part, yaml.MappingNode) else ():
                if key.value == "ros_distro":
                    return [choice.value for choice in dict_of(value)["choices"].value]
        return list(DISTROS)

    @cached_property
    def owners(self):
        dictionary = self.hook.dictionary
        found = [Owner(dictionary.package)]
        for component in dictionary.components.values():
            found.append(Owner(component.attributes, (component.tag,)))
            # What others take may hold the kinds of these, and no others.
            inside = not component.is_shared
            found += self.inside(component, (component.tag,)) if inside else []
        return found

    def inside(self, owner, path):
        """Yield what stands inside of a component or an interface kind, at any depth."""
        for interface in owner.interfaces.values():
            yield Owner(interface.attributes, (*path, interface.kind))
            yield from self.inside(interface, (*path, interface.kind))

    def context(self, spec, distro=None):
        """Return the context of a spec, or None if the dictionary does not allow the spec.

        Raises:
            SpecError: not the spec is wrong, but the model.

        """
        try:
            return self.hook.context(spec.encode(), "spec", distro or self.distros[-1])
        except SpecError as error:
            if not str(error).startswith("spec:"):
                raise
            return None

    def fitting(self, *elements):
        """Return those of the first and the last distribution that take a spec of elements.

        What a package needs, both take; what else it may have, one of them at least.
        """
        ends = dict.fromkeys((self.distros[0], self.distros[-1]))
        found = [distro for distro in ends if self.context(self.spec(elements), distro)]
        needed = {component.tag for component in self.hook.dictionary.needed}
        is_needed = any(owner.component in needed for owner, _ in elements)
        assert found if not is_needed else found == [*ends], self.spec(elements)
        return found

    def base(self, owner, given=()):
        """Return the attributes an element must have, and those `given`, each with a value."""
        values = {}
        required = self.required(owner)
        for name, attribute in owner.attributes.items():
            if name in given:
                values[name] = given[name]
            elif name in required or not (attribute.optional or attribute.ignored):
                values[name] = candidates(attribute, values)[0]
        return values

    def required(self, owner):
        """Return the attributes of an owner that an interface kind inside of it requires."""
        kinds = self.hook.dictionary.components
        for tag in owner.path:
            kinds = kinds[tag].interfaces
        found = (kind.requires[:1] for kind in kinds.values())
        return {name for names in found for name in names} if owner.path else set()

    def variants(self, owner):
        """Yield each attribute with the values of two elements that differ in it alone."""
        for name, attribute in owner.attributes.items():
            if attribute.ignored:
                continue
            needed = {other: words[0] for other, words in attribute.when.items() if words}
            base = self.base(owner, needed)
            latest = self.fitting((owner, base))[-1]
            before = self.context(self.spec([(owner, base)]), latest)
            for text in candidates(attribute, base):
                values = self.base(owner, {**needed, name: text})
                if self.context(self.spec([(owner, values)]), latest) not in (None, before):
                    yield name, base, values

    def spec(self, elements):
        """Return a spec with elements: of an owner, with values. It gets what else it needs."""
        package = next((values for owner, values in elements if not owner.component), None)
        root = ET.Element(PACKAGE, package or self.base(self.owners[0]))
        parents = {(): root}
        own = [item for item in elements if item[0].path]
        needed = [(owner, self.base(owner)) for owner in self.owners if owner.path]
        holders = {owner.path[:size] for owner, _ in own for size in range(1, len(owner.path))}
        made = {component.tag for component in self.hook.dictionary.needed}
        has_one = any(owner.component in made for owner, _ in own)
        holders |= {owner.path[:1] for owner, _ in own}
        holders |= set() if has_one else {(tag,) for tag in made}
        holders |= self._takers({path[0] for path in holders})
        holders |= self._referred(
            [*elements, *(item for item in needed if item[0].path in holders)]
        )
        placed = []
        for item in sorted(own + needed, key=lambda item: len(item[0].path)):
            path = item[0].path
            if path in holders and path not in parents:
                parents[path] = ET.SubElement(parents[path[:-1]], path[-1], item[1])
                placed.append(item)
        for owner, values in own:
            if owner.kind and not any(item[1] is values for item in placed):
                ET.SubElement(parents[owner.path[:-1]], owner.kind, values)
        self._add_more(root)
        self._refer(root)
        ET.indent(root)
        return ET.tostring(root, encoding="unicode") + "\n"

    def _add_more(self, root):
        """Give each element as many of a kind as it must have."""
        for owner in self.owners:
            kind = self.kind(owner)
            for element in root.findall("/".join(owner.path[:-1])) if kind and kind.least else ():
                for number in range(len(element.findall(owner.kind)), kind.least):
                    values = self.base(owner)
                    values[kind.naming] += str(number)
                    ET.SubElement(element, owner.kind, values)

    def kind(self, owner):
        """Return the interface kind that an owner of attributes is, if it is one."""
        kinds, found = self.hook.dictionary.components, None
        for tag in owner.path:
            found = kinds[tag]
            kinds = found.interfaces
        return found if owner.kind else None

    def _takers(self, tags):
        """Return the paths of what takes elements of some tags, so that these make something."""
        return {
            path
            for component in self.hook.dictionary.components.values()
            for kind in component.interfaces.values()
            if kind.taken in tags
            for path in [(component.tag,), (component.tag, kind.kind)]
        }

    def _referred(self, elements):
        """Return the paths of what elements refer to, with all that this needs."""
        found, left = set(), list(elements)
        while left:
            owner, values = left.pop()
            refers = [a for name, a in owner.attributes.items() if a.refers_to and name in values]
            for tag in (attribute.refers_to for attribute in refers):
                named = [each for each in self.owners if each.path[-1:] == (tag,)]
                home = max(
                    named, key=lambda each: len(os.path.commonprefix([each.path, owner.path]))
                )
                paths = {home.path[:size] for size in range(1, len(home.path) + 1)} - found
                left += [(each, self.base(each)) for each in self.owners if each.path in paths]
                found |= paths
        return found

    def _refer(self, root):
        """Let each value that refers to an element be the name of one that is there."""
        around = {child: parent for parent in root.iter() for child in parent}
        claims = {}
        for owner in self.owners:
            refers = [(name, a) for name, a in owner.attributes.items() if a.refers_to]
            found = root.findall("/".join(owner.path)) if owner.path else [root]
            for element, (name, attribute) in product(found, refers):
                home, tag = around.get(element, root), f".//{attribute.refers_to}"
                while home.find(tag) is None and home is not root:
                    home = around[home]
                if name in element.attrib and home.find(tag) is not None:
                    named = self._named(home.findall(tag), attribute, around, claims)
                    element.set(name, next(iter(named.attrib.values()), ""))

    def _named(self, known, attribute, around, claims):
        """Return an element that an attribute may name: one that none needs otherwise, or more."""
        asked = {other: words[0] for other, words in attribute.whose.items()}
        for each in known:
            if not asked or claims.get(each, asked) == asked:
                if asked:
                    claims[each] = asked
                    each.attrib |= asked
                return each
        owner = next(each for each in self.owners if each.path[-1:] == (attribute.refers_to,))
        values = self.base(owner)
        first = next(iter(values))
        values[first] += f"_{len(known)}"
        made = ET.SubElement(around[known[0]], owner.kind, values | asked)
        claims[made] = asked
        return made

    def faulty(self, owner):
        """Yield specs with a fault that a schema can know: what is unknown, missing, no choice."""
        base = self.base(owner)
        yield self.spec([(owner, base | {"no_such": "x"})])
        for name, attribute in owner.attributes.items():
            if not (attribute.optional or attribute.ignored):
                yield self.spec([(owner, {each: base[each] for each in base if each != name})])
            if attribute.choices and not attribute.ignored:
                yield self.spec([(owner, base | {name: "no such"})])
        for child in ("no_such", PACKAGE):
            root = ET.fromstring(self.spec([(owner, base)]))
            ET.SubElement(root.find("/".join(owner.path)) if owner.path else root, child)
            yield ET.tostring(root, encoding="unicode")

    def several(self, distro):
        """Return a spec with one more component of each tag, and one for each choice it has."""
        root = ET.fromstring(self.spec(self.small(distro)))
        for element in list(root):
            owner = self.hook.dictionary.components[element.tag]
            choices = [
                {name: word} for name, each in owner.attributes.items() for word in each.choices
            ]
            for number, chosen in enumerate([{}, *choices]):
                other = copy.deepcopy(element)
                other.attrib |= chosen
                root.append(other)
                if not self._renamed(root, other, owner, number, distro):
                    root.remove(other)
        return ET.tostring(root, encoding="unicode")

    def _renamed(self, root, element, owner, number, distro):
        """Give an element other names where it needs its own; tell whether the spec is right."""
        for child in element:
            kind = owner.interfaces[child.tag]
            self._renamed(None, child, kind, number, distro)
        for name, attribute in owner.attributes.items():
            if not attribute.unique or name not in element.attrib:
                continue
            element.set(name, f"{element.get(name)}{number + 2}")
        if root is not None:
            self._refer(root)
        spec = "" if root is None else ET.tostring(root, encoding="unicode")
        return spec and self.context(spec, distro)

    def hostile(self):
        """Return the elements of `small` with signs in the texts that mean something in files.

        The first attribute of each is what it is called, and no text for readers.
        """
        found = []
        for owner, base in [(self.owners[0], self.base(self.owners[0])), *self.small()]:
            texts = {
                name: HOSTILE
                for name, attribute in [*owner.attributes.items()][1:]
                if attribute.format in ("text", "raw") and not attribute.ignored
                if not (attribute.choices or attribute.pattern or attribute.unique)
                if not attribute.refers_to
            }
            found.append((owner, base | texts))
        return found

    def small(self, distro=None):
        """Return the elements of a spec with one interface of each kind."""
        return self._accepted([(o, self.base(o)) for o in self.owners if o.component], (), distro)

    @cache  # noqa: B019 (a model lives as long as the tests, of which several ask for this)
    def everything(self, distro=None):
        """Return the elements of `small` and one more for each value an attribute may have.

        With a distribution, without the values that it does not allow.
        """
        if distro:
            found = self._accepted(self.everything(), (), distro)
            made = {owner.component for owner, _ in found}
            others = [each for each in self.small(distro) if each[0].component not in made]
            return self._accepted(others, found, distro)
        more = [(o, values) for o in self.owners if o.kind for *_, values in self.variants(o)]
        return self._accepted(more, self.small())

    def _accepted(self, elements, start=(), distro=None):
        """Return the elements that fit together, after those of `start`."""
        found = list(start)

        def accept(items):
            """Take all of the items, or what can be taken of each half of them."""
            if self.context(self.spec([*found, *(named for named, _ in items)]), distro):
                found.extend(named for named, _ in items)
            elif len(items) > 1:
                accept(items[: len(items) // 2])
                accept(items[len(items) // 2 :])
            elif self.context(self.spec([*found, items[0][1]]), distro):
                found.append(items[0][1])

        items = []
        for number, (owner, values) in enumerate(elements):
            names = {
                name: f"{text}_{len(start)}_{number}"
                for name, text in values.items()
                if owner.attributes[name].unique and owner.kind
            }
            items.append(((owner, values | names), (owner, values)))
        accept(items)
        return found


def validators(schema):
    """Return the validators that are here, each to be called with a spec, for a schema's file."""
    found = []
    if importlib.util.find_spec("xmlschema"):
        found.append(importlib.import_module("xmlschema").XMLSchema(str(schema)).is_valid)
    if shutil.which("xmllint"):
        command = ["xmllint", "--noout", "--schema", str(schema), "-"]
        options = {"capture_output": True, "text": True}
        found.append(lambda spec: not subprocess.run(command, input=spec, **options).returncode)
    return found


def is_component(owner):
    return owner.component and not owner.kind


def dict_of(node):
    """Return a mapping of YAML nodes by their keys."""
    return {key.value: value for key, value in node.value}


def candidates(attribute, values):
    """Return texts that may be values of an attribute, where its element has `values`."""
    if attribute.choices:
        return list(attribute.choices)
    kind, is_list = attribute.format, False
    if kind == "literal":
        kind = values[attribute.of].removesuffix("[]")
        is_list = attribute.several or values[attribute.of].endswith("]")
    example = str(attribute.example)
    found = [example] if example and "$" not in example and attribute.format != "literal" else []
    found += SAMPLES[kind]
    for limit in (attribute.above, attribute.minimum, attribute.maximum):
        if isinstance(limit, int | float):
            found += [str(limit), str(limit + 1), str(limit - 1)]
    if not is_list:
        return found
    pairs = zip(found, [*found[1:], found[0]], strict=True)
    return [f"[{', '.join(dict.fromkeys(pair))}]" for pair in pairs]


@cache
def models():
    """Return the model of this repository, or those of a collection."""
    if (ROOT / "dictionary.yaml").exists():
        return [Model(ROOT)]
    return [Model(file.parent) for file in sorted(ROOT.glob("*_model/dictionary.yaml"))]


def template(target):
    """Copy the working tree of this repository, without its history, and return the folder."""

    def ignored(folder, names):
        own = {".git", ".venv", "build"} if Path(folder) == ROOT else set()
        return (own | {"__pycache__"}) & set(names)

    return Path(shutil.copytree(ROOT, target, ignore=ignored, symlinks=True))


def make(source, target, model, spec, distro):
    """Render a package from a spec, or from the skeleton of one, into a folder.

    Return for each file that it may have the templates that make it.

    Raises:
        AssertionError: a template failed, or a file is made twice; the text names the templates.

    """
    data = {"ros_distro": distro}
    if spec is not None:
        file = target.with_suffix(".xml")
        file.write_text(spec, encoding="utf-8")
        data["spec_file"] = str(file)
    data |= {} if model.folder == ROOT else {"model": model.name}
    options = {"defaults": True, "unsafe": True, "quiet": True}
    made = {}
    rendered = Worker._render_path

    def watch(worker, template):
        for path, more in rendered(worker, template):
            if (worker.template_copy_root / template).is_file():
                made.setdefault(str(path), []).append(str(template))
            yield path, more

    try:
        with warnings.catch_warnings(), mock.patch.object(Worker, "_render_path", watch):
            warnings.simplefilter("ignore")
            copier.run_copy(str(source), target, data=data, **options)
    except (UserMessageError, OSError) as error:
        twice = _twice(made)
        raise AssertionError(f"{twice or error}\n{distro}: {spec}") from error
    assert not _twice(made), f"{_twice(made)}\n{distro}: {spec}"
    return made


def _twice(made):
    """Say which file is made twice, by two templates or for two components."""
    for path, templates in made.items():
        if len(templates) > 1:
            by = " and ".join(sorted(set(templates)))
            return f"{path} is made {len(templates)} times, by {by}"
    return ""


def render(model, spec, distro, source=None):
    """Return the files of a package, by path, without the spec and Copier's answers."""
    with tempfile.TemporaryDirectory() as folder:
        source = source or template(Path(folder) / "template")
        package = Path(folder) / "package"
        make(source, package, model, spec, distro)
        return {
            str(path.relative_to(package)): path.read_text(encoding="utf-8")
            for path in sorted(package.rglob("*"))
            if path.is_file()
            and path.suffix != ".ros_package"
            and path.name != ".copier-answers.yml"
        }


def commit(folder, tag=None):
    """Commit all of a folder, in a repository of its own."""
    identity = ("-c", "user.name=Test Er", "-c", "user.email=test@example.org")
    for command in (("init", "-q"), ("add", "-A"), (*identity, "commit", "-qm", "A change")):
        subprocess.run(["git", *command], cwd=folder, check=True, capture_output=True)
    if tag:
        subprocess.run(["git", "tag", tag], cwd=folder, check=True)
