"""A model of a few lines in the place of Copier, for updates that take no seconds."""

from hooks.merge.render import Render
from hooks.merge.tree import File

ANSWERS = "answers.yml"
SPEC = "arm.ros_package"
KEPT = {SPEC}
LOGIC = '''    def serve_{0}(self, request):
        """Serve {0}."""
        return None

'''


def answers(*callbacks, nodes=(), **others):
    spec = {"name": "arm", "nodes": [*nodes], "callbacks": [*callbacks]}
    return {"_src_path": "model", "_commit": "1.0.0", **others, "spec": spec}


class Model:
    """What stands in for Copier: a model with a callback, a line and a file for each name.

    Each node has a file, too.
    """

    answers_file, url, commit = ANSWERS, "model", "1.0.0"

    def recorded(self, answers):
        names = answers["spec"]["callbacks"]
        texts = {
            "arm.py": "class Arm:\n" + "".join(map(LOGIC.format, names)),
            "README.md": "# Arm\n\nWhat it has:\n\n" + "".join(f"- {name}\n" for name in names),
            SPEC: "".join(f"{name}\n" for name in names),
            "rate.txt": f"rate: {answers.get('rate', 1)}\n",
            **{f"config/{name}.yaml": f"{name}: 1\n" for name in names},
            **{f"{node['name']}.py": "x = 1\n" for node in answers["spec"]["nodes"]},
        }
        made = {path: File(text.encode()) for path, text in texts.items()}
        return Render(made | {"logo.png": File(b"\x89PNG\0")}, KEPT.__contains__)

    fresh = recorded
