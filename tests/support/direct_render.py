"""Render packages by Jinja alone: what Copier does to a template, without checks and questions.

Copier needs half a second for a package and this a few hundredths, with the templates and the
extensions of the collection in place. A test sees that both give the same files.
"""

import itertools
import re
import tempfile
from functools import cache
from pathlib import Path

import copier
import pathspec
import yaml

from support.repository import ROOT

ANSWERS = ".copier-answers.yml"


class Renderer:
    """A model of a collection, ready to render contexts."""

    def __init__(self, source, model):
        self.model = model
        self.folder = source / model / "template"
        self.env = environment(source, model)
        settings = [(source / path).read_text() for path in ("hooks/copier.yml", "copier.yml")]
        lasts = (yaml.safe_load(text.rpartition("\n---\n")[2]) for text in settings)
        self.excluded = [rule for last in lasts for rule in last["_exclude"]]
        found = sorted(path for path in self.folder.rglob("*") if path.is_file())
        self.paths = [str(path.relative_to(self.folder)) for path in found]
        self.made = {}

    def render(self, spec, distro, runtime="inside"):
        """Return the text of each file by its path, without Copier's own and the spec.

        Raises:
            AssertionError: a file is made twice.

        """
        key = f"{distro} {runtime} {spec}"
        if key not in self.made:
            if len(self.made) == 8:  # two developers, before and after, and what they become
                self.made.pop(next(iter(self.made)))
            self.made[key] = self._rendered(spec, distro, runtime)
        return dict(self.made[key])

    def _rendered(self, spec, distro, runtime):
        inside = runtime == "inside"
        package = spec["name"] if inside else runtime
        values = {
            "model": self.model,
            "ros_distro": distro,
            "ci": "none",
            "agents": "AGENTS.md",
            "runtime": runtime,
            "runtime_package": package,
            "runtime_headers": "" if inside and "nodes" in spec else f"{package}/",
            "test_support": "support" if inside and "nodes" in spec else f"{package}.testing",
            "runtime_version": "0.1.0",
            "ros1": "." if spec["ros"] == 1 else "",
            "ros2": "." if spec["ros"] == 2 else "",
            "spec_file": "",
            "spec": spec,
            "_copier_answers": {},
            "_copier_conf": {
                "answers_file": ANSWERS,
                "dst_path": "",
                "data": {"spec": spec},
                "exclude": [],
            },
        }
        rules = [self.string(rule).render(values) for rule in self.excluded]
        is_excluded = pathspec.GitIgnoreSpec.from_lines("\n".join(rules).splitlines())
        files = {}
        for source in self.paths:
            for name, more in self.names(source, values):
                skipped = name == ANSWERS or name.endswith(".ros_package")
                if not skipped and not is_excluded.match_file(name):
                    assert name not in files, f"{name} is made twice, once by {source}"
                    files[name] = self.text(source, {**values, **more})
        return files

    def names(self, source, values):
        """Yield each path that a template file gives, and the part and component it is for."""
        part = re.match(r"\[spec\.(\w+)\]/", source)
        if not part:
            yield from self.components(source, values["spec"], values)
            return
        find = self.env.filters["parts"]
        for spec in find(values["spec"], part[1], values["ros_distro"]):
            for name, more in self.components(source[part.end() :], spec, values):
                yield name, {**more, "part": spec}

    def components(self, source, spec, values):
        """Yield each path that a template file gives, and the component it is for."""
        item = re.search(r"\[(\w+)\.", source)
        components = self.env.filters["all_of"](spec, item[1]) if item else [None]
        for component in components:
            more = {item[1]: component} if item else {}
            form = re.sub(r"\[(\w+\.\w+)\]", r"{{ \1 }}", source)
            parts = [self.string(part).render({**values, **more}) for part in form.split("/")]
            if all(parts):
                yield str(Path(*parts)).removesuffix(".jinja"), more

    def text(self, source, values):
        if not source.endswith(".jinja"):
            return (self.folder / source).read_text()
        return self.env.get_template(f"{self.model}/template/{source}").render(values)

    @cache  # noqa: B019 (a renderer lives as long as the tests)
    def string(self, text):
        return self.env.from_string(text)


def environment(source, model):
    """Return the environment in which Copier renders a model, with its extensions and filters."""
    with tempfile.TemporaryDirectory() as folder:
        options = {"defaults": True, "unsafe": True, "quiet": True}
        data = {"model": model, "ros_distro": "kilted"}
        target = Path(folder) / "package"
        worker = copier.run_copy(str(source), target, data=data, exclude=["*"], **options)
        return worker.jinja_env


def variants():
    """Yield every model with a distribution of each ROS."""
    models = sorted(file.parent.name for file in ROOT.glob("*_model/functions.py"))
    return list(itertools.product(models, ("noetic", "kilted")))
