"""Random specs with names of 3 to 60 letters: their packages pass their own linters, and mypy.

`make fuzz` lints FUZZ_LINTED packages, other ones each time; `make test` a few, always the same.
"""

import itertools
import os
import random
import shutil

from hooks.faults import SpecError
from support import ros
from support.direct_render import variants
from support.fuzz import LongNames
from support.linters import cpp_faults, leave_news, python_faults, ruff_faults, type_faults, write
from support.packages import DISTROS, model_of

LINTED = int(os.environ.get("FUZZ_LINTED", "8"))
SEED = os.environ.get("FUZZ_SEED", "")
BATCH = 100
MODELS = {name: model_of(name) for name in sorted({model for model, _ in variants()})}


def samples(renderers, folder, count, distros=DISTROS, models=MODELS, change=str):
    """Write packages into a folder, a batch at a time; yield their contexts by their folders."""
    seed = int(SEED) if SEED.isdigit() else random.getrandbits(32) if SEED else 0
    print(f"FUZZ_SEED={seed}")
    author = LongNames(seed)
    turn = itertools.cycle(itertools.product(distros, models))
    for start in range(0, count, BATCH):
        contexts = {}
        while len(contexts) < min(BATCH, count - start):
            distro, model = next(turn)
            xml = change(author.spec(MODELS[model].dictionary).decode())
            try:
                context = MODELS[model].context(xml.encode(), "spec.xml", distro)
            except SpecError:
                continue
            if context["name"] not in {other["name"] for other in contexts.values()}:
                name = f"{start + len(contexts)}_{model}_{distro}"
                contexts[name] = context
                write(folder / name, {"spec.xml": xml, **renderers[model].render(context, distro)})
        yield contexts
        shutil.rmtree(folder)
        print(f"{start + len(contexts)} packages")


def test_packages_have_the_layout_of_ruff(renderers, tmp_path):
    for _ in samples(renderers, tmp_path / "packages", LINTED):
        faults = ruff_faults(tmp_path / "packages")
        assert not faults, faults


def test_packages_pass_their_linters(renderers, tmp_path, ros2):
    longest = {}
    for _ in samples(renderers, tmp_path / "packages", LINTED):
        leave_news(tmp_path / "packages", longest)
        faults = python_faults(ros2, tmp_path / "packages")
        faults += cpp_faults(ros2, tmp_path / "packages")
        assert not faults, faults


def test_types_of_packages_in_ros2(renderers, tmp_path, ros2):
    distros = [distro for distro in DISTROS if distro not in ("noetic", "humble")]
    check_types(ros2, renderers, tmp_path, distros, lambda spec: ros.fitting(ros2, spec))


def test_types_of_packages_in_ros1(renderers, tmp_path, ros1):
    check_types(ros1, renderers, tmp_path, ["noetic"])


def check_types(ros_, renderers, tmp_path, distros, change=str):
    models = ["python_model", "mixed_model"]
    folder = tmp_path / "packages"
    for contexts in samples(renderers, folder, LINTED // 2, distros, models, change):
        faults = type_faults(ros_, folder, contexts)
        assert not faults, faults
