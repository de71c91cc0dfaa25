"""The layout of packages of before: the runtime beside the nodes, support beside the tests."""

import re

FLAT = (
    (r"(\{\{ runtime_package \}\})\.ros import", r"\1 import"),
    (r"(\{\{ runtime_package \}\})\.ros\.", r"\1."),
    (r"(\{\{ (?:spec\.name|runtime_package) \}\})/ros/", r"\1/"),
    (r"(runtime_package ~ ')/ros/", r"\1/"),
    (r"/\*\*/ros/", "/**/"),
    (r"(?m)^(from )\{\{ test_support \}\}\.", r"\1"),
    (r"\./support/", "./"),
    (r"'support', ('recorder\.py')", r"\1"),
    (r"\b(ros/)?timing\.hpp", r"\1loop.hpp"),
    (r"test/support/(fakes|\[node\.name\]_harness)\.hpp", r"test/\1.hpp"),
)
"""What says in templates where files are, now and before."""
RENAMED = {"goal_sender.py": "ros_action_client.py", "timing.hpp": "loop.hpp"}


def flatten(collection):
    """Take the templates of a collection back to the layout of before."""
    found = set()
    for file in [*collection.glob("*_model/template/**/*"), *collection.glob("shared/**/*")]:
        if file.is_file():
            text = file.read_text()
            for pattern, before in FLAT:
                text, count = re.subn(pattern, before, text)
                found |= {pattern} if count else set()
            file.write_text(text)
    assert len(found) == len(FLAT), f"other words now: {dict(FLAT).keys() - found}"
    for model in ("python_model", "cpp_model"):
        (collection / model / "moved_files.yaml").unlink()
        template = collection / model / "template"
        (template / "{{ spec.name }}/ros/__init__.py").unlink(missing_ok=True)
        folders = [*template.rglob("{{ spec.name }}/ros"), *template.rglob("test/support")]
        for folder in folders:
            for file in folder.iterdir():
                file.rename(folder.parent / file.name)
        for now, before in RENAMED.items():
            for file in [*template.rglob(f"{now}.jinja")]:
                file.rename(file.with_name(f"{before}.jinja"))
