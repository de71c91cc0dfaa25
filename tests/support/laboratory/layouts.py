"""The layout of packages of before: the runtime beside the nodes, support beside the tests."""

import re

FLAT = (
    (r"(\{\{ spec\.name \}\})\.ros import", r"\1 import"),
    (r"(\{\{ spec\.name \}\})\.ros\.", r"\1."),
    (r"(\{\{ spec\.name \}\})/ros/", r"\1/"),
    (r"(spec\.name ~ ')/ros/", r"\1/"),
    (r"(?m)^(from )support\.", r"\1"),
    (r"\./support/", "./"),
    (r"'support', ('recorder\.py')", r"\1"),
    (r"test/support/(fakes|\[node\.name\]_harness)\.hpp", r"test/\1.hpp"),
)
"""What says in templates where files are, now and before."""


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
        senders = [*template.rglob("goal_sender.py.jinja")]
        for file in senders:
            file.rename(file.with_name("ros_action_client.py.jinja"))
