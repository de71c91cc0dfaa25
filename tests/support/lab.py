"""The merge laboratory: random packages, edits and changes, merged by `copier update`.

`trial` is one update. It checks the guarantee of an update, and counts, file by file, the merges
that had to be free of conflicts and were.
"""

import difflib
import re
import shutil
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from xml.sax.saxutils import quoteattr

import copier
from hypothesis import strategies as st

from support.repository import commit, copy_collection, git

MODELS = ("python_model", "cpp_model")
DISTROS = ("noetic", "kilted")
NAMES = ("cop", "load", "pose", "/states", "speed_x", "goal")
TYPES = {
    "publisher": ("std_msgs::String", "geometry_msgs::Point"),
    "subscriber": ("std_msgs::String", "sensor_msgs::Imu"),
    "directPublisher": ("std_msgs::Empty", "nav_msgs::Path"),
    "directSubscriber": ("std_msgs::Empty", "std_msgs::Bool"),
    "serviceServer": ("std_srvs::Trigger", "std_srvs::SetBool"),
    "serviceClient": ("std_srvs::Trigger", "std_srvs::Empty"),
    "actionServer": ("test_msgs::Fibonacci", "other_msgs::Move"),
    "actionClient": ("test_msgs::Fibonacci", "other_msgs::Move"),
    "parameter": ("int", "string"),
    "dynParameter": ("int", "string"),
    "listener": ("", ""),
    "broadcaster": ("", ""),
}


@dataclass
class Counts:
    """What a number of trials gave."""

    updates: int = 0
    merges: int = 0
    lines: int = 0
    lost: int = 0
    said: int = 0
    independent: int = 0
    conflicts: int = 0
    unneeded: Counter = field(default_factory=Counter)


@st.composite
def interfaces(draw):
    kind = draw(st.sampled_from(sorted(TYPES)))
    name = draw(st.sampled_from(NAMES))
    if "arameter" in kind or kind in ("listener", "broadcaster"):
        name = re.sub(r"\W", "", name)
    which = draw(st.integers(0, 1))
    return {"kind": kind, "name": name, "type": which, "description": draw(DESCRIPTIONS)}


DESCRIPTIONS = st.sampled_from(("", "what it is for", 'it\'s <odd> & "quoted"', "Länge, m"))


@st.composite
def nodes(draw):
    name = draw(st.sampled_from(("alpha", "beta", "gamma_ray")))
    found = draw(st.lists(interfaces(), max_size=6))
    return {"name": name, "frequency": draw(st.sampled_from((1, 10, 50))), "interfaces": found}


def _unique(items, key):
    return list({key(item): item for item in items}.values())


def _clash(item):
    """Return what two interfaces of a node cannot both have."""
    return {"dynParameter": "parameter"}.get(item["kind"], item["kind"]), item["name"].strip("/")


def xml(spec):
    """Write a spec; of two interfaces that would clash, the later one counts."""
    lines = [
        f'<package name="lab" author="A" author_email="a@example.org" license="MIT"'
        f" description={quoteattr(spec['description'])}>"
    ]
    for node in _unique(spec["nodes"], lambda node: node["name"]):
        lines.append(f'  <node name="{node["name"]}" frequency="{node["frequency"]}">')
        for item in _unique(node["interfaces"], _clash):
            kind, type_ = item["kind"], TYPES[item["kind"]][item["type"]]
            text = (
                f'    <{kind} name="{item["name"]}" description={quoteattr(item["description"])}'
            )
            text += f' type="{type_}"' if type_ else ""
            text += ' value="1"' if "arameter" in kind else ""
            lines.append(text + "/>")
        lines.append("  </node>")
    return "\n".join([*lines, "</package>", ""])


@st.composite
def specs(draw):
    return {"description": "A package", "nodes": draw(st.lists(nodes(), min_size=1, max_size=3))}


@st.composite
def changed(draw, spec):
    """Add, remove, reorder, retype or describe anew some of a spec."""
    spec = {**spec, "nodes": [{**n, "interfaces": list(n["interfaces"])} for n in spec["nodes"]]}
    for _ in range(draw(st.integers(0, 3))):
        what = draw(st.sampled_from("add remove reorder retype describe node frequency".split()))
        node = draw(st.sampled_from(spec["nodes"]))
        items = node["interfaces"]
        if what == "add":
            items.insert(draw(st.integers(0, len(items))), draw(interfaces()))
        elif what == "node":
            if len(spec["nodes"]) > 1 and draw(st.booleans()):
                spec["nodes"].remove(node)
            else:
                spec["nodes"].append(draw(nodes()))
        elif what == "frequency":
            node["frequency"] = draw(st.sampled_from((1, 10, 50)))
        elif items:
            index = draw(st.integers(0, len(items) - 1))
            if what == "remove":
                del items[index]
            elif what == "reorder":
                items.insert(0, items.pop(index))
            elif what == "retype":
                items[index] = {**items[index], "type": 1 - items[index]["type"]}
            else:
                items[index] = {**items[index], "description": draw(DESCRIPTIONS)}
    return spec


class Laboratory:
    """The collection in two versions, the second of which moves, adds and rewrites code."""

    def __init__(self, folder):
        self.folder = folder
        self.collection = copy_collection(folder / "collection")
        for file in self.collection.glob("*_model/template/**/*"):
            if file.is_file() and file.suffix == ".jinja":
                text = file.read_text()
                text = text.replace("fixed frequency", "frequency that does not change")
                file.write_text(text)
        macros = self.collection / "shared/macros.jinja"
        macros.write_text(
            macros.read_text().replace(
                "{% endif %}\n{% endmacro",
                "{% endif %}\n{{ comment }} Made by a model.\n{% endmacro",
            )
        )
        readme = self.collection / "shared/README.md.jinja"
        text = readme.read_text()
        start, end = text.index("## Life-cycle"), text.index("## Change")
        text = text[:start] + text[end:].replace("## Licence", text[start:end] + "## Licence")
        readme.write_text(text.replace("Rounded: topics.", "Round: topics."))
        (self.collection / "shared/extra.md").write_text("extra\n")
        (self.collection / "python_model/template/EXTRA.md").write_text("An added file.\n")
        commit(self.collection, "Second version", tag="2.0.0")
        self.counts = Counts()
        self.number = 0

    def render(self, spec, version, model, distro, name):
        """Render a spec afresh."""
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        file = self.folder / "spec.xml"
        file.write_text(xml(spec))
        data = {"model": model, "ros_distro": distro, "spec_file": str(file)}
        copier.run_copy(
            str(self.collection),
            folder,
            data=data,
            vcs_ref=version,
            defaults=True,
            unsafe=True,
            quiet=True,
        )
        return folder

    def trial(self, spec, new_spec, version, model, distro, random):
        """Edit a package at random, update it, and check what the update made of it."""
        old = texts(self.render(spec, "1.0.0", model, distro, "package"))
        package = self.folder / "package"
        commit(package, "Render")
        edits = self.edit(package, old, random)
        commit(package, "Edit")
        (package / "lab.ros_package").write_text(xml(new_spec))
        commit(package, "Change the spec")
        mine = texts(package)
        new = texts(self.render(new_spec, version, model, distro, "fresh"))
        copier.run_update(
            package, vcs_ref=version, defaults=True, unsafe=True, quiet=True, overwrite=True
        )
        result = texts(package)
        self.check(package, edits, old, mine, new, result)

    def edit(self, package, old, random):
        """Edit some files; return the marks of the lines written, file by file."""
        edits = {}
        for path in random.sample(sorted(old), k=random.randint(1, len(old))):
            if path.endswith((".ros_package", ".copier-answers.yml")):
                continue
            lines = old[path].splitlines(keepends=True)
            marks = []
            for _ in range(random.randint(1, 3)):
                self.number += 1
                mark = f"mine_{self.number}"
                at = random.randint(0, len(lines))
                how = random.choice(("insert", "insert", "insert", "replace", "delete", "append"))
                if how == "append":
                    lines.append(f"# {mark}")  # and no newline at the end
                elif how == "insert" or at == len(lines):
                    if lines and not lines[-1].endswith("\n"):
                        lines[-1] += "\n"
                    lines.insert(at, f"    {mark} = 1\n")
                elif how == "replace":
                    lines[at] = f"    {mark} = 2\n"
                else:
                    del lines[at]
                    continue
                marks.append(mark)
            text = "".join(lines)
            if random.random() < 0.05:
                text = text.replace("\n", "\r\n")
            elif random.random() < 0.05:
                text = re.sub(r"^    ", "  ", text, flags=re.MULTILINE)
            (package / path).write_bytes(text.encode())
            edits[path] = [mark for mark in marks if mark in text]
        if random.random() < 0.5:
            self.number += 1
            mark = f"mine_{self.number}"
            name = random.choice(("notes.txt", "EXTRA.md", "lab/helper.py", "src/more.txt"))
            (package / name).parent.mkdir(exist_ok=True)
            (package / name).write_text(f"{mark}\n")
            edits[name] = [mark]
        return edits

    def check(self, package, edits, old, mine, new, result):
        """Check that no line was lost in silence, and count the conflicts."""
        counts = self.counts
        counts.updates += 1
        everything = "\n".join(result.values())
        for path, marks in edits.items():
            counts.merges += 1
            counts.lines += len(marks)
            for mark in marks:
                if mark in everything:
                    continue
                if path not in result:  # the update said: removed, see it again with git show
                    assert mark in git(package, "show", f"HEAD:./{path}")
                    counts.said += 1
                else:
                    counts.lost += 1
            assert not counts.lost, f"{path} lost a line"
            if path in old and path in new:
                free = "<<<<<<< before updating" not in result.get(path, "")
                counts.conflicts += not free
                if independent(old[path], mine[path], new[path]):
                    counts.independent += 1
                    if not free:
                        counts.unneeded[path] += 1
        for path, text in new.items():
            unedited = path not in edits and not path.endswith(".copier-answers.yml")
            if unedited and not path.endswith(".ros_package"):
                assert result[path] == text, f"{path} was not edited, and is not like new"


def texts(folder):
    """Return the text of every file of a package by its path."""
    files = (path for path in Path(folder).rglob("*") if path.is_file())
    return {
        str(path.relative_to(folder)): path.read_bytes().decode()
        for path in files
        if ".git" not in path.relative_to(folder).parts
    }


def independent(old, mine, new):
    """Say whether two changes of a text leave an unchanged line between them, everywhere."""
    base = old.splitlines(keepends=True)

    def touched(text):
        matcher = difflib.SequenceMatcher(
            None, base, text.splitlines(keepends=True), autojunk=False
        )
        return [(a, b) for tag, a, b, _, _ in matcher.get_opcodes() if tag != "equal"]

    return all(
        end < other_start or other_end < start
        for start, end in touched(mine)
        for other_start, other_end in touched(new)
    ) and mine.endswith("\n") == old.endswith("\n")
