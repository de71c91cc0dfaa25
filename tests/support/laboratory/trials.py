"""One update after the other, judged and counted.

A trial runs the merge on renders, which are made once for many trials; `update` runs all of
`copier update` on a package in git.
"""

import re
import shutil
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass, field

import copier
import yaml

from hooks.changes import marked
from hooks.dictionary import load
from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.renaming import Renaming, plan
from hooks.merge.render import Renderer
from hooks.merge.tree import File, encode, read_folder
from support.laboratory import specs
from support.laboratory.edits import edit
from support.laboratory.judge import CONFLICT, judge
from support.repository import commit, copy_collection

ANSWERS = ".copier-answers.yml"
MODELS = ("python_model", "cpp_model")
DISTROS = ("noetic", "kilted")


@dataclass
class Counts:
    """What a number of trials gave."""

    updates: int = 0
    lines: int = 0
    edited_files: int = 0
    both_changed: int = 0
    """Files that the developer and the new version have changed."""
    conflicts: Counter = field(default_factory=Counter)
    """By file, conflicts in packages that stay with their ROS."""
    moved: Counter = field(default_factory=Counter)
    """The same in packages that move to the other ROS, where generated code is another."""
    wrong: list = field(default_factory=list)

    def row(self):
        return (
            f"{self.updates} updates, {self.lines} lines, {self.edited_files} edited files,"
            f" {self.both_changed} of them changed by both sides: {len(self.wrong)} wrong,"
            f" {sum(self.conflicts.values())} conflicts {dict(self.conflicts)},"
            f" {sum(self.moved.values())} in moves to the other ROS {dict(self.moved)}"
        )


@dataclass
class Pair:
    """An old and a new render, and what the spec says was renamed between them."""

    spec: dict
    new_spec: dict
    old: dict
    new: dict
    renaming: Renaming
    is_kept: object
    moves: bool
    """Whether the package moves to the other ROS."""


class Laboratory:
    """The collection in two versions, the second of which moves, adds and rewrites text."""

    def __init__(self, folder):
        self.folder = folder
        self.collection = copy_collection(folder / "collection")
        second_version(self.collection)
        self.number = 0

    def package(self, spec, model, distro):
        """Make a package in git."""
        folder = self._copy(spec, model, distro, "1.0.0")
        commit(folder, "Render")
        return folder

    def _copy(self, spec, model, distro, version):
        self.number += 1
        folder = self.folder / f"package_{self.number}" / "lab"
        file = self.folder / "spec.xml"
        file.write_text(specs.xml(spec))
        data = {"model": model, "ros_distro": distro, "spec_file": str(file)}
        options = {"defaults": True, "unsafe": True, "quiet": True}
        copier.run_copy(str(self.collection), folder, data=data, vcs_ref=version, **options)
        return folder

    def pair(self, spec, new_spec, model, distros, version, old_version="1.0.0"):
        """Render both sides of an update."""
        old_folder = self._copy(spec, model, distros[0], old_version)
        new_folder = self._copy(new_spec, model, distros[1], version)
        answers, new_answers = (
            yaml.safe_load((folder / ANSWERS).read_text()) for folder in (old_folder, new_folder)
        )
        old, new = _texts(old_folder), _texts(new_folder)
        dictionary = load(self.collection / model / "dictionary.yaml", self.collection)
        context, marks = marked(answers["spec"], new_answers["spec"], dictionary)
        renaming = Renaming()
        if any(mark.before != mark.after for mark in marks):
            renderer = Renderer(self.collection, "", "", "lab", ANSWERS)
            marked_render = renderer.recorded(answers | {"spec": context})
            renaming = plan(_tree(old), marked_render.tree, marks, old)
        for folder in (old_folder, new_folder):
            shutil.rmtree(folder.parent)
        kept = {path for path in {*old, *new} if path.endswith((".ros_package", "CHANGELOG.md"))}
        return Pair(spec, new_spec, old, new, renaming, kept.__contains__, len({*distros}) > 1)


def trial(random, pair, counts, mutate=None, **options):
    """Edit, merge, prove and judge once; `mutate` spoils the result. Return the complaints."""
    edited = edit(random, pair.old, ahead(random, pair), **options)
    spec_file = "lab.ros_package"
    edited.texts[spec_file] = specs.xml(pair.new_spec)
    mine, old, new = _tree(edited.texts), _tree(pair.old), _tree(pair.new)
    result = merge_package(mine, old, new, pair.renaming, pair.is_kept)
    if mutate:
        mutate(random, result.tree, edited, pair)
    texts = {path: file.text for path, file in result.tree.items()}
    said = {*result.left, *_said(result.removed)}
    complaints = judge(
        edited, pair.old, pair.new, texts, said, moves(pair, edited.texts), renamed(pair)
    )
    complaints += unjustified(pair, result, edited)
    proof = prove(mine, old, result, result.tree, pair.renaming)
    complaints += [f"proof: {path}: {line}" for path, line in proof.lost]
    count(counts, pair, edited, texts, complaints)
    return complaints


def chain(random, laboratory, model, distro, length, counts):
    """Edit and update one package, again and again, with all of `copier update`."""
    spec, version, edited = specs.random_spec(random), "1.0.0", None
    package = laboratory.package(spec, model, distro)
    for number in range(length):
        edited = edit(random, _texts(package), edited=edited, formatters=number == 1)
        new_spec = specs.change(random, specs.settled(spec))
        new_distro = random.choice(DISTROS) if random.random() < 0.3 else distro
        new_version = "2.0.0" if number else version
        distros = (distro, new_distro)
        pair = laboratory.pair(spec, new_spec, model, distros, new_version, version)
        edited.texts["lab.ros_package"] = specs.xml(new_spec)
        for path, text in edited.texts.items():
            (package / path).write_text(text)
        commit(package, f"Edit {number}")
        said = _update(package, new_version, new_distro)
        texts = _texts(package)
        parts = re.findall(r"^removed   (\S+)(?: from (\S+))?  ", said, re.MULTILINE)
        gone = {f"{path}: {part.rpartition('::')[2]}" if path else part for part, path in parts}
        places, names = moves(pair, edited.texts), renamed(pair)
        complaints = judge(edited, pair.old, pair.new, texts, gone, places, names)
        if not re.search(r"^\d+ of \d+ of your lines are in their place", said, re.MULTILINE):
            complaints.append(f"the summary does not say it: {said}")
        count(counts, pair, edited, texts, complaints)
        if any(CONFLICT in text for text in texts.values()):
            return
        commit(package, f"Update {number}")
        edited.follow(texts, places, names)
        spec, distro, version = new_spec, new_distro, new_version


def _update(package, version, distro):
    """Update a package as a user does, and return what was said."""
    command = [sys.executable, "-m", "copier", "update", "--trust", "--defaults"]
    command += ["--vcs-ref", version, "-d", f"ros_distro={distro}"]
    result = subprocess.run(command, cwd=package, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    return result.stderr


def ahead(random, pair):
    """Choose a callback that the new spec adds, to be written before it."""
    if random.random() > 0.3:
        return []
    old = {node["name"]: set(specs.callbacks(node)) for node in pair.spec["nodes"]}
    return [
        (node["name"], name)
        for node in pair.new_spec["nodes"]
        for name, was in specs.callbacks(node).items()
        if not node.get("was")
        and name == was
        and name.startswith("serve_")
        and name not in old.get(node["name"], {name})
    ][:1]


def _said(removed):
    for path, parts in removed.items():
        for part in parts:
            yield f"{path}: {part.rpartition('::')[2]}"


def unjustified(pair, result, edited):
    """Return what was removed although the new version has it."""
    complaints = [f"{path}: left, and is new" for path in result.left if path in pair.new]
    for path, parts in result.removed.items():
        target = pair.renaming.path(path)
        taken = renamed(pair).get(path, {}).values()
        for part in parts:
            name = part.rpartition("::")[2]
            if name not in taken and re.search(
                rf"\b{re.escape(name)}\(", pair.new.get(target, "")
            ):
                complaints.append(f"{path}: {part} removed, and is new")
    return complaints


def moves(pair, paths):
    """Return where files of before must be: what carries the name of a renamed node."""
    found = {}
    for node in pair.new_spec["nodes"]:
        was = node.get("was")
        for path in paths if was and was in {n["name"] for n in pair.spec["nodes"]} else ():
            form = rf"(^|/|test_){was}(?=(_impl|_interface|_ros|_node)?(\.\w+)?$)"
            target = re.sub(form, rf"\g<1>{node['name']}", path)
            if target != path and target != "lab.ros_package" and path != "lab.ros_package":
                found[path] = target
    return found


def renamed(pair):
    """Return the functions that have another name, by the path of before."""
    found = {}
    for node in pair.new_spec["nodes"]:
        names = {was: name for name, was in specs.callbacks(node).items() if was != name}
        before = node.get("was") or node["name"]
        constructors = {_class(before): _class(node["name"])}
        found[f"lab/{before}_impl.py"] = names
        found[f"src/{before}_impl.cpp"] = names | constructors
    return found


def _class(node):
    return "".join(word.capitalize() for word in node.split("_")) + "Impl"


def count(counts, pair, edited, texts, complaints):
    counts.updates += 1
    counts.lines += len(edited.lines)
    counts.wrong += complaints
    for path, text in edited.texts.items():
        if path in pair.old and text != pair.old[path]:
            counts.edited_files += 1
            target = pair.renaming.path(path)
            counts.both_changed += pair.new.get(target) != pair.old[path]
            if CONFLICT in texts.get(target, ""):
                where = counts.moved if pair.moves else counts.conflicts
                where[re.sub(r"\w+(?=_(impl|ros|interface|node))", "node", path)] += 1


def _texts(folder):
    texts = {
        path: file.text for path, file in read_folder(folder).items() if file.text is not None
    }
    texts.pop(ANSWERS)
    return texts


def _tree(texts):
    return {path: File(encode(text)) for path, text in texts.items()}


def second_version(collection):
    """Move, add and rewrite text of the templates, and tag that 2.0.0."""
    rewritten = {
        "Prepare the logic; return": "Get the logic ready; return",
        "Compute the outputs of one cycle": "Compute the outputs of a cycle",
        "The input and output messages": "All messages, input and output,",
        "Callbacks run in threads of their own": "Every callback runs in its own thread",
        "\n## Licence": "\n## Support\n\nAsk the authors.\n\n## Licence",
    }
    found = set()
    for file in [*collection.glob("*_model/template/**/*"), *collection.glob("shared/**/*")]:
        if file.is_file() and file.suffix == ".jinja":
            text = file.read_text()
            for before, after in rewritten.items():
                found |= {before} if before in text else set()
                text = text.replace(before, after)
            file.write_text(text)
    assert found == set(rewritten), "the templates say it in other words now"
    for model in MODELS:
        (collection / model / "template/EXTRA.md").write_text("An added file.\n")
    commit(collection, "Second version", tag="2.0.0")
