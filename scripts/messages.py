"""Make docs/messages.md anew: what each message means, and what to do.

    python scripts/messages.py            # writes the page

The texts are those of the code that raises them, found by their ids; cause, cure and an example
are in docs/messages.yaml (decision 144).
"""

from __future__ import annotations

import ast
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from hooks.faults import SpecError  # noqa: E402
from hooks.package import Package  # noqa: E402
from hooks.run import Run  # noqa: E402
from hooks.specs import Specs, template_notes  # noqa: E402

PAGE = ROOT / "docs/messages.md"
CODE = [
    *("hooks/**/*.py", "extensions/*.py", "*_model/functions.py", "shared/**/functions.py"),
    "scripts/*.py",
]
ID = "[a-z]+(?:-[a-z0-9]+)+"
TELLING = {
    *("SpecError", "spec_error", "AdoptError", "PublishError", "UnrenderedError", "ValueError"),
    *("with_id", "fault", "_fault", "refuse", "_match", "_matching", "__init__"),
}
"""What is called with a text and, last, its id."""
HEAD = """# Messages

For those who got one. Each fault that is reported, and each note, ends with an id in brackets,
by which it is found here. `…` stands for names, values and places. A team's own model may have
messages of its own.

Made by `scripts/messages.py` from the code and `docs/messages.yaml`."""
ABOUT = 'author="Ada" author_email="ada@example.org" description="An arm" license="MIT"'
PACKAGE = f'<package name="arm" {ABOUT}>\n{{}}\n</package>\n'
NODE = '  <node name="driver" frequency="10">\n{}\n  </node>'

Entry = dict[str, Any]


def sections() -> list[dict[str, Any]]:
    """Return the sections of the page: each a title, and messages by id."""
    found = yaml.safe_load((ROOT / "docs/messages.yaml").read_text(encoding="utf-8"))
    return list(found)


def entries() -> dict[str, Entry]:
    """Return what the page says of each id."""
    return {id_: entry for section in sections() for id_, entry in section["messages"].items()}


def texts() -> dict[str, list[str]]:
    """Return the texts that the code has for each id."""
    found: dict[str, list[str]] = {}
    for file in (file for pattern in CODE for file in sorted(ROOT.glob(pattern))):
        for id_, text in _told(ast.parse(file.read_text(encoding="utf-8"))):
            if text not in found.setdefault(id_, []) and re.search("[a-z]{3}", text):
                found[id_].append(text)
    return found


def _told(module: ast.Module) -> Iterator[tuple[str, str]]:
    """Yield each id in a module with its text."""
    functions = [node for node in ast.walk(module) if isinstance(node, ast.FunctionDef)]
    for function in [module, *functions]:
        known: dict[str, str] = {}
        for node in _inside(function):
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                known[node.targets[0].id] = _shown(node.value, known)
            elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
                known[node.target.id] = known.get(node.target.id, "") + _shown(node.value, known)
            text, id_ = (_shown(each, known) for each in _pair(node))
            if not re.fullmatch(ID, id_):  # or it ends the text itself
                whole = _shown(node, known) if isinstance(node, ast.JoinedStr) else ""
                ended = re.fullmatch(rf"(.*) \[({ID})\]", whole)
                text, id_ = ended.groups() if ended else ("", "")
            if id_:
                text = re.sub("…+", "…", text.partition("\n")[0])
                yield id_, re.sub(r"^((…|\d+): ?)+", "", text)


def _inside(function: ast.AST) -> Iterator[ast.AST]:
    """Yield what is in a function, in its order, but not in functions within it."""
    for node in ast.iter_child_nodes(function):
        if not isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield from _inside(node)
            yield node


def _pair(node: ast.AST) -> list[ast.expr]:
    """Return what is the text and the id of a message, if a part of the code tells one."""
    items: list[ast.expr] = []
    if isinstance(node, ast.Call):
        name = ast.unparse(node.func).rpartition(".")[2]
        items = node.args if name in TELLING else []
    elif isinstance(node, ast.Tuple):
        items = node.elts
    return items[-2:] if len(items) > 1 else [ast.Constant(""), ast.Constant("")]


def _shown(node: ast.AST, known: dict[str, str]) -> str:
    """Return a text as the code has it, with dots for what only a run can say."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(_shown(part, known) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return _shown(node.value, known)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return _shown(node.left, known) + _shown(node.right, known)
    if isinstance(node, ast.Name):
        return known.get(node.id, "…")
    is_quoted = isinstance(node, ast.Call) and ast.unparse(node.func) == "quoted"
    return '"…"' if is_quoted else "…"


def example(entry: Entry, folder: Path) -> str:
    """Return what the example of an entry prints, tried in an empty folder."""
    package, model = folder / "arm", folder / "model"
    inside = entry.get("package") or (NODE.format(entry["node"]) if "node" in entry else "")
    spec = entry.get("spec") or (PACKAGE.format(inside) if inside else "")
    files = {package / "arm.ros_package": spec} if spec else {}
    files |= {model / name: text for name, text in entry.get("of_model", {}).items()}
    files |= {package / name: text for name, text in entry.get("files", {}).items()}
    for folder_ in (package, *(file.parent for file in files)):
        folder_.mkdir(parents=True, exist_ok=True)
    for file, text in files.items():
        file.write_text(text, encoding=entry.get("encoding", "utf-8"))
    template = model if model.exists() else ROOT
    run = Run(
        template,
        Package(package, ".copier-answers.yml"),
        entry.get("given", {}),
        {"_src_path": entry.get("source", "")},
        entry.get("model", "python_model"),
        entry.get("ros", "kilted"),
        *(False, False, True, True, False),
    )
    hook = Specs(template, lambda _: None, lambda *_: None)
    before = Path.cwd()
    os.chdir(package)
    try:
        hook.check_answers(run)
        context = hook.context(run, run.given.get("spec_file", ""))
        said = "\n".join([*hook.notes(run, context), *template_notes(run.source)])
    except SpecError as error:
        said = str(error)
    finally:
        os.chdir(before)
    return said.replace(f"{folder}/", "")


def page() -> str:
    """Return the page."""
    known, blocks = texts(), [HEAD]
    for section in sections():
        blocks.append(f"## {section['title']}")
        for id_, entry in section["messages"].items():
            blocks.append(f"### {id_}")
            if known[id_]:
                blocks.append("\n".join(f"- `{text}`" for text in known[id_]))
            blocks += [entry["cause"], f"**Cure:** {entry['cure']}"]
            if "test" not in entry:
                with tempfile.TemporaryDirectory() as folder:
                    blocks.append(f"```text\n{example(entry, Path(folder).resolve())}\n```")
    return "\n\n".join(blocks) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
