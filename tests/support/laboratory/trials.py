"""One update after the other, judged and counted.

A trial runs the merge on renders, which are made once for many trials; `update` runs all of
`copier update` on a package in git.
"""

import os
import re
import shutil
import time
from collections import Counter
from dataclasses import dataclass, field

import copier

from hooks.changes import marked
from hooks.merge.moves import moved_files
from hooks.merge.renaming import Renaming, plan
from hooks.merge.tree import File, encode, read_folder, remove, write
from hooks.merge.versions import Versions
from hooks.model import Model
from support.command import run_copier
from support.direct_render import Renderer as DirectRenderer
from support.laboratory import layouts, specs
from support.laboratory.edits import HABITS, edit
from support.laboratory.judge import CONFLICT, judge
from support.repository import commit, copy_collection, git

ANSWERS = ".copier-answers.yml"
MODELS = ("python_model", "cpp_model")
ALL_MODELS = (*MODELS, "mixed_model", "interfaces_model")
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
    doubtful: int = 0
    """Updates in which a proof has made a conflict of what the merge gave."""

    def row(self):
        return (
            f"{self.updates} updates, {self.lines} lines, {self.edited_files} edited files,"
            f" {self.both_changed} of them changed by both sides: {len(self.wrong)} wrong,"
            f" {sum(self.conflicts.values())} conflicts {dict(self.conflicts)},"
            f" {self.doubtful} merges in doubt,"
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
    to_ros: int | None
    """The ROS that the package moves to, if it does."""
    layout: dict = field(default_factory=dict)
    """New paths of files that the new version of the model calls otherwise, by the old ones."""


class Laboratory:
    """The collection in versions: 2.0.0 moves, adds and rewrites text and files of 1.0.0.

    0.9.0 is 1.0.0 in another layout, as older packages have it.

    Packages of chains are made by Copier, from the repository. Trials need renders alone, which
    Jinja makes of the two versions in a hundredth of the time.
    """

    def __init__(self, folder):
        self.folder = folder
        self.collection = copy_collection(folder / "collection")
        self.versions = {name: self._version(name) for name in ("0.9.0", "1.0.0")}
        layouts.flatten(self.versions["0.9.0"])
        second_version(self.collection)
        self.versions["2.0.0"] = self._version("2.0.0")
        self.models = {name: Model(self.collection / name, self.collection) for name in ALL_MODELS}
        self.renderers = {
            (version, model): DirectRenderer(source, model)
            for version, source in self.versions.items()
            for model in (ALL_MODELS if version != "0.9.0" else MODELS)
        }
        self.number = 0

    def _version(self, name):
        ignore = shutil.ignore_patterns(".git", "tests", "examples", "docs", "benchmarks")
        return shutil.copytree(self.collection, self.folder / name, ignore=ignore, symlinks=True)

    def package(self, spec, model, distro):
        """Make a package in git."""
        self.number += 1
        folder = self.folder / f"package_{self.number}" / "lab"
        file = self.folder / "spec.xml"
        file.write_text(specs.xml(spec))
        data = {"model": model, "ros_distro": distro, "spec_file": str(file)}
        options = {"defaults": True, "unsafe": True, "quiet": True}
        copier.run_copy(str(self.collection), folder, data=data, vcs_ref="1.0.0", **options)
        commit(folder, "Render")
        return folder

    def pair(self, spec, new_spec, model, distros, version, old_version="1.0.0", own=()):
        """Render both sides of an update; `own` are paths of the developer's own files.

        A spec is one of `specs`, or XML.
        """
        known = self.models[model]
        given = (spec, new_spec)
        xmls = [one if isinstance(one, str) else specs.xml(one, model) for one in given]
        contexts = [
            known.context(xml.encode(), "lab.ros_package", distro)
            for xml, distro in zip(xmls, distros, strict=True)
        ]
        renderers = [self.renderers[name, model] for name in (old_version, version)]
        old, new = (
            renderer.render(context, distro) | {"lab.ros_package": xml}
            for renderer, context, distro, xml in zip(
                renderers, contexts, distros, xmls, strict=True
            )
        )
        context, marks = marked(*contexts, known.dictionary)
        renaming = Renaming()
        if any(mark.before != mark.after for mark in marks):
            marked_render = tree_of(renderers[0].render(context, distros[0]))
            renaming = plan(
                tree_of(old), marked_render, marks, [*old, *own], known.dictionary.holders
            )
        layout = {}
        if version != old_version:
            source = self.versions[version]
            layout = moved_files(contexts[1], Model(source / model, source))
        renaming.follow(layout, old, new)
        renaming.move(tree_of(old), tree_of(new))
        to_ros = contexts[1]["ros"] if contexts[0]["ros"] != contexts[1]["ros"] else None
        kept = {path for path in {*old, *new} if path.endswith((".ros_package", "CHANGELOG.md"))}
        return Pair(spec, new_spec, old, new, renaming, kept.__contains__, to_ros, layout)


def trial(random, pair, counts, mutate=None, check=None, **options):
    """Edit, merge, prove and judge once. Return the complaints.

    Args:
        mutate: spoils the result.
        check: gives complaints of the package before and after.
        options: those of `edit`.

    """
    edited = edit(random, pair.old, ahead(random, pair), **options)
    edited.texts["lab.ros_package"] = pair.new["lab.ros_package"]
    mine, old, new = edited.tree(), tree_of(pair.old), tree_of(pair.new)
    made = Versions(mine, old, new, pair.renaming, pair.is_kept, pair.to_ros)
    result = made.merge({})
    doubts, left = proved(made, result)
    if doubts:
        counts.doubtful += 1
        result, _ = made.merged()
    if mutate:
        mutate(random, result.tree, edited, pair)
    if doubts or mutate:
        doubts, left = proved(made, result)
    texts = {path: file.text or "" for path, file in result.tree.items()}
    said = {*result.left, *_said(result.removed)}
    said |= {mark for *_, line in left for mark in re.findall(r"\bmine_\d+\b", line)}
    missing = {path for path, parts in result.missing.items() if "" in parts}
    missing |= {*_said(result.missing)}
    places, names = moves(pair, edited), renamed(pair, edited)
    complaints = judge(edited, pair.old, pair.new, result.tree, said, missing, places, names)
    complaints += unjustified(pair, result, names)
    complaints += [f"proof: {path}: {line}" for path, line in doubts]
    if check and not result.conflicts:
        complaints += check(mine, result.tree, edited, pair, names)
    count(counts, pair, edited, texts, complaints)
    return complaints


def proved(made, result):
    """Return what the proofs doubt, and the lines that are said to be left behind."""
    proof = made.proof(result, result.tree)
    return [*proof.lost, *made.wrong(result, result.tree, proof)], proof.left


def chain(random, laboratory, model, distro, length, counts, check=None):
    """Edit and update one package, again and again, with all of `copier update`."""
    spec, version, edited = specs.random_spec(random), "1.0.0", None
    package = laboratory.package(spec, model, distro)
    for number in range(length):
        ways = None if number == 1 else set(HABITS) - {"format"}
        edited = edit(random, _texts(package), edited=edited, ways=ways)
        new_spec = specs.change(random, specs.settled(spec))
        new_distro = random.choice(DISTROS) if random.random() < 0.3 else distro
        new_version = "2.0.0" if number else version
        distros = (distro, new_distro)
        pair = laboratory.pair(spec, new_spec, model, distros, new_version, version)
        edited.texts["lab.ros_package"] = specs.xml(new_spec)
        _put(package, edited.tree())
        commit(package, f"Edit {number}")
        said = _update(package, new_version, new_distro, hostile(random, laboratory.folder))
        tree = read_folder(package)
        tree.pop(ANSWERS)
        texts = _texts(package)
        parts = re.findall(r"^removed   (.+?)(?: from (\S+))?  ", said, re.MULTILINE)
        behind = marks_left(said, edited)
        gone = behind | {
            f"{path}: {part.rpartition('::')[2]}" if path else part for part, path in parts
        }
        parts = re.findall(r"^missing   (\S+?)(?:: (.+))?$", said, re.MULTILINE)
        missing = {f"{path}: {part.rpartition('::')[2]}" if part else path for path, part in parts}
        places, names = moves(pair, edited), renamed(pair, edited)
        complaints = judge(edited, pair.old, pair.new, tree, gone, missing, places, names)
        if not re.search(r"^\d+ of \d+ of your lines are in their place", said, re.MULTILINE):
            complaints.append(f"the summary does not say it: {said}")
        in_conflict = re.findall(r"^CONFLICT  (.+)$", said, re.MULTILINE)
        if check and not in_conflict:
            complaints += check(edited.tree(), tree, edited, pair, names)
        count(counts, pair, edited, texts, complaints)
        for path in in_conflict:
            texts[path] = settled(texts[path]) if path in texts else ""
            if path not in edited.links:
                (package / path).write_text(texts[path], errors="surrogateescape")
        commit(package, f"Update {number}")
        edited.follow(texts, places, names)
        spec, distro, version = new_spec, new_distro, new_version


def marks_left(said, edited):
    """Return the marks of the lines that the summary says were left behind."""
    found = set()
    for path, first, last in re.findall(r"^left +(.+?):(\d+)(?:-(\d+))?: ", said, re.MULTILINE):
        lines = edited.texts[path].split("\n")[int(first) - 1 : int(last or first)]
        found |= set(re.findall(r"\bmine_\d+\b", "\n".join(lines)))
    return found


def settled(text):
    """Choose the new side of each conflict."""
    mine = rf"(?ms)^{CONFLICT}$.*?^=======$\n"
    return re.sub(r"(?m)^>>>>>>> after updating$\n", "", re.sub(mine, "", text))


def _put(package, tree):
    """Make a package what a developer has made of it a minute ago.

    Git reads a file again that is as young as its index, and then through a filter of today.
    """
    edited = time.time() - 60
    for path in set(read_folder(package)) - set(tree) - {ANSWERS}:
        remove(package, path)
    for path, file in tree.items():
        write(package / path, file)
        os.utime(package / path, (edited, edited), follow_symlinks=False)


HOSTILE = {
    "apply.whitespace": "error",
    "core.whitespace": "trailing-space,tab-in-indent",
    "core.autocrlf": "true",
    "core.safecrlf": "warn",
    "core.quotePath": "true",
    "core.fsmonitor": "false",
    "diff.noprefix": "true",
    "diff.mnemonicPrefix": "true",
    "diff.renames": "copies",
    "diff.external": "false",
    "merge.conflictStyle": "zdiff3",
    "merge.renames": "false",
    "commit.gpgSign": "true",
    "gpg.program": "false",
    "status.showUntrackedFiles": "no",
    "status.relativePaths": "false",
    "color.ui": "always",
    "core.attributesFile": "{folder}/attributes",
    "filter.shout.clean": "tr a-z A-Z",
    "filter.shout.smudge": "tr A-Z a-z",
    "core.hooksPath": "{folder}/hooks",
}
"""Settings of git that have changed what an update does, here or elsewhere."""


def hostile(random, folder):
    """Write a configuration of git with some of these settings; return its path."""
    hooks = folder / "hooks"
    if not hooks.exists():
        hooks.mkdir()
        for name in ("pre-commit", "commit-msg", "post-index-change"):
            (hooks / name).write_text("#!/bin/sh\nexit 1\n")
            (hooks / name).chmod(0o755)
        (folder / "attributes").write_text("*.md filter=shout\n*.yaml text eol=crlf\n")
    file = folder / "hostile.gitconfig"
    file.write_text("[user]\nname = Test Er\nemail = test@example.org\n")
    for name in random.sample(sorted(HOSTILE), k=5):
        git(folder, "config", "--file", str(file), name, HOSTILE[name].format(folder=folder))
    return file


def _update(package, version, distro, configuration):
    """Update a package as a user does who has this configuration of git; return what was said."""
    command = ["update", "--trust", "--defaults", "--vcs-ref", version]
    command += ["-d", f"ros_distro={distro}"]
    result = run_copier(command, package, {"GIT_CONFIG_GLOBAL": str(configuration)})
    assert result.returncode == 0, configuration.read_text() + result.stderr
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


def unjustified(pair, result, names):
    """Return what was removed although the new version has it.

    In another ROS, files in `ros` may have another function of one name; of overloads, one may go.
    """
    taken = {after for before, after in pair.renaming.paths.items() if after != before}
    complaints = [f"{p}: left, and is new" for p in result.left if p in {*pair.new} - taken]
    for path, parts in result.removed.items():
        if pair.to_ros and "/ros/" in path:
            continue
        target = pair.renaming.path(result.origins.get(path, path))
        taken = names.get(path, {}).values()
        for part in parts:
            name = part.rpartition("::")[2]
            call = re.compile(rf"(?<![.>])\b{re.escape(name)}\(")
            before, after = (
                len(call.findall(texts.get(at, "")))
                for texts, at in ((pair.old, result.origins.get(path, path)), (pair.new, target))
            )
            if name not in taken and 0 < after >= before:
                complaints.append(f"{path}: {part} removed, and is new")
    return complaints


NODE_FILES = "(impl|interface|ros|main|node|harness|params)"


def moves(pair, edited):
    """Return where files of before must be: what carries the name of a renamed node.

    So are the files that the second version calls otherwise.
    """
    found = {}
    for path in {*edited.texts, *edited.moved.values(), *pair.old}:
        if path.startswith(("lab.ros_package", "launch/")):
            continue  # these are named like the package, as a node may be, too
        target = path
        for node in newly_named(pair):
            was = node.get("was")
            if was in {n["name"] for n in pair.spec["nodes"]}:
                form = rf"(^|/|test_){was}(?=(_{NODE_FILES})?(\.\w+)*$)"
                renamed_ = re.sub(form, rf"\g<1>{node['name']}", path)
                target = renamed_ if renamed_ != path else target
        if pair.layout.get(target) in pair.new:
            target = pair.layout[target]
        if target != path:
            found[path] = target
    return found


def renamed(pair, edited):
    """Return the functions that have another name, by the path of before."""
    nodes = {node["was"]: node["name"] for node in newly_named(pair) if node.get("was")}
    found = dict.fromkeys(("CMakeLists.txt", "launch/lab.launch", "launch/lab.launch.xml"), nodes)
    for node in newly_named(pair):
        names = {was: name for name, was in specs.callbacks(node).items() if was != name}
        before = node.get("was") or node["name"]
        constructors = {_class(before): _class(node["name"])}
        found[f"lab/{before}_impl.py"] = names
        found[f"lab/{before}_ros.py"] = {
            f"_receive_{item['was']}": f"_receive_{item['name']}"
            for item in node["items"]
            if item.get("was")
        }
        found[f"src/{before}_impl.cpp"] = names | constructors
    return found | {path: found[o] for path, o in edited.moved.items() if o in found}


def newly_named(pair):
    """Return the nodes of the new spec; a name before that the old spec has, too, is no news."""
    old = {node["name"]: node for node in pair.spec["nodes"]}
    found = []
    for node in _newly_named(pair.spec["nodes"], pair.new_spec["nodes"]):
        before = old.get(node.get("was") or node["name"], {"items": []})
        found.append(node | {"items": _newly_named(before["items"], node["items"])})
    return found


def _newly_named(old, new):
    known = {(item["name"], item.get("was")) for item in old}
    return [
        item | {"was": None} if (item["name"], item.get("was")) in known else item for item in new
    ]


def _class(node):
    return "".join(word.capitalize() for word in node.split("_")) + "Impl"


def _is_due(path, text):
    """Say whether all conflicts in YAML are of keys to which both sides give another value."""
    form = r"(?ms)^<<<<<<< before updating\n(.*?)^=======\n(.*?)^>>>>>>> after updating\n"
    sides = ((re.findall(r"\w+(?=:)", side) for side in hunk) for hunk in re.findall(form, text))
    return path.endswith(".yaml") and all(mine == new for mine, new in sides)


def count(counts, pair, edited, texts, complaints):
    counts.updates += 1
    counts.lines += len(edited.lines)
    counts.wrong += complaints
    for path, text in edited.texts.items():
        origin = edited.moved.get(path, path)
        if origin in pair.old and text != pair.old[origin]:
            counts.edited_files += 1
            target = pair.renaming.path(path)
            generated = pair.renaming.path(origin)
            counts.both_changed += pair.new.get(generated) != pair.old[origin]
            if CONFLICT in texts.get(target, "") and not _is_due(target, texts[target]):
                where = counts.moved if pair.to_ros else counts.conflicts
                where[re.sub(r"\w+(?=_(impl|ros|interface|node))", "node", path)] += 1


def _texts(folder):
    """Return the texts of a package, without the line ends of Windows."""
    tree = read_folder(folder)
    tree.pop(ANSWERS)
    return {
        path: file.text.replace("\r\n", "\n")
        for path, file in tree.items()
        if file.text is not None
    }


def tree_of(texts):
    return {path: File(encode(text)) for path, text in texts.items()}


REWRITTEN = {
    "Prepare the logic; return": "Get the logic ready; return",
    "Compute the outputs of one cycle": "Compute the outputs of a cycle",
    "The input and output messages": "All messages, input and output,",
    "Start operating; return": "Begin to work; return",
    "\n## Lifecycle": "\n## Support\n\nAsk the authors.\n\n## Lifecycle",
    "/config/{{ node.name }}.yaml": "/config/{{ node.name }}_params.yaml",
    "{{ runtime_package }}.ros.worker import": "{{ runtime_package }}.ros.jobs import",
    "{{ runtime_headers }}ros/inbox.hpp": "{{ runtime_headers }}ros/mailbox.hpp",
    "\n  'inbox':": "\n  'mailbox':",
    '/worker.py.jinja"': '/jobs.py.jinja"',
    '/inbox.hpp.jinja"': '/mailbox.hpp.jinja"',
}
MOVED_FILES = """"config/{node}_params.yaml": "config/{node}.yaml"
"{package}/ros/jobs.py": "{package}/ros/worker.py"
"src/ros/mailbox.hpp": "src/ros/inbox.hpp"
"""


def second_version(collection):
    """Move, add and rewrite text and files of the templates, and tag that 2.0.0."""
    found = set()
    for file in [*collection.glob("*_model/template/**/*"), *collection.glob("shared/**/*")]:
        if file.is_file() and file.suffix == ".jinja":
            text = file.read_text()
            for before, after in REWRITTEN.items():
                found |= {before} if before in text else set()
                text = text.replace(before, after)
            file.write_text(text)
    assert found == set(REWRITTEN), f"other words now: {set(REWRITTEN) - found}"
    for before, after in (
        ("worker.py.jinja", "jobs.py.jinja"),
        ("inbox.hpp.jinja", "mailbox.hpp.jinja"),
        ("[[]node.name].yaml.jinja", "[node.name]_params.yaml.jinja"),
    ):
        files = list(collection.glob(f"*_model/template/**/{before}"))
        assert files
        for file in files:
            file.rename(file.with_name(after))
    for model in ALL_MODELS:
        (collection / model / "template/EXTRA.md.jinja").write_text("An added file.\n")
    for model in MODELS:  # and so for a model that includes these
        moved = collection / model / "moved_files.yaml"
        moved.write_text(moved.read_text() + MOVED_FILES)
    commit(collection, "Second version", tag="2.0.0")
