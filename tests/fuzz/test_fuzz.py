"""Specs without number: each is refused with a sentence or gives a sound package.

`make fuzz` tries FUZZ_INPUTS of them, other ones each time; `make test` a few, always the same.
FUZZ_SEED=<number> chooses which.
"""

import itertools
import os
import re
import subprocess
import sys
import time

import copier
import pytest
from copier.errors import UserMessageError
from hypothesis import HealthCheck, given, seed, settings

from hooks.faults import SpecError
from support.direct_render import variants
from support.fuzz import check, inputs, plain, specs, styles
from support.packages import model_of

INPUTS = int(os.environ.get("FUZZ_INPUTS", "150"))
COMPILED = int(os.environ.get("FUZZ_COMPILED", "2"))
SEED = os.environ.get("FUZZ_SEED", "")
LONGEST_MESSAGE = 20_000
OPTIONS = "-std=c++17 -fsyntax-only -Wall -Wextra"
KNOWN = {"actionlib", "dynamic_reconfigure", "geometry_msgs", "nav_msgs", "roscpp", "roslaunch"}
KNOWN |= {"actionlib_msgs", "diagnostic_msgs", "rosgraph_msgs", "std_msgs", "std_srvs"}
KNOWN |= {"tf", "tf2", "tf2_ros"}

MODELS = {name: model_of(name) for name in sorted({model for model, _ in variants()})}
DICTIONARY = MODELS["python_model"].dictionary
INTERFACES = ["interfaces_model"]
MIXED = ["mixed_model"]
NODES = [name for name in MODELS if name not in INTERFACES + MIXED]


def many(count):
    """Try a test with so many inputs; a failure is made small before it is shown."""
    chosen = settings(
        max_examples=count,
        deadline=None,
        database=None,
        derandomize=not SEED,
        suppress_health_check=list(HealthCheck),
    )
    return lambda test: chosen(seed(SEED)(test) if SEED.isdigit() else test)


@pytest.fixture(scope="module")
def progress():
    """Count the inputs, and say now and then how far it is."""
    counts, start = {"inputs": 0, "accepted": 0}, time.monotonic()

    def count(accepted):
        counts["inputs"] += 1
        counts["accepted"] += accepted
        if counts["inputs"] % 1000 == 0:
            passed = time.monotonic() - start
            print(f"{counts['inputs']} inputs, {counts['accepted']} accepted, {passed:.0f} s")

    yield count
    print(f"{counts['inputs']} inputs, {counts['accepted']} accepted")


def context(model, xml, distro):
    """Return the context of an input, or None where it is refused in good form."""
    try:
        return MODELS[model].context(xml, "spec.xml", distro)
    except SpecError as error:
        message = str(error)
        assert message
        assert len(message) < LONGEST_MESSAGE
        for line in message.split("\n"):
            assert line.startswith(("spec.xml:", "... and ", "the package")), line
            assert line.isprintable(), line
        return None


def test_inputs_are_the_same_whatever_ran_before(tmp_path):
    (tmp_path / "loaded_before.py").write_text(f"NUMBERS = {[*range(10**6, 10**6 + 500)]}\n")
    program = (
        "from hypothesis import given, settings\n"
        "from support.fuzz import authors\n"
        "@settings(max_examples=1000, database=None, derandomize=True)\n"
        "@given(authors())\n"
        "def run(author): print(author.getrandbits(64))\n"
        "run()\n"
    )
    runs = [
        subprocess.run(
            [sys.executable, "-c", loaded + program],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for loaded in ["", "import loaded_before\n"]
    ]
    assert len(set(runs[0].split())) > 900
    assert runs[0] == runs[1]


@pytest.mark.parametrize(
    "models", [NODES, MIXED, INTERFACES], ids=["nodes", "mixed", "interfaces"]
)
def test_inputs_are_refused_or_give_sound_packages(renderers, progress, models):
    turn = itertools.cycle([variant for variant in variants() if variant[0] in models])

    @many(INPUTS)
    @given(inputs(MODELS[models[0]].dictionary))
    def run(xml):
        model, distro = next(turn)
        spec = context(model, xml, distro)
        progress(spec is not None)
        if spec is not None:
            renderer = renderers[model]
            files = renderer.render(spec, distro)
            check(files, renderer.render(plain(spec), distro), spec)

    run()


def test_quotes_in_a_default_are_text(renderers):
    package = 'name="arm" author="A" author_email="a@example.org" description="d" license="MIT"'
    field = """<field name="a" type="string" default='"b=c'/>"""
    xml = f'<package {package}><message name="Arm">{field}</message></package>'
    spec = context("interfaces_model", xml.encode(), "kilted")
    renderer = renderers["interfaces_model"]
    files, harmless = (renderer.render(each, "kilted") for each in (spec, plain(spec)))
    check(files, harmless, spec)


@pytest.mark.parametrize("model", MODELS)
def test_schema_accepts_what_the_hook_accepts(model, tmp_path):
    """Editors never complain of a spec that is right, for whichever ROS."""
    schema = tmp_path / "ros_package.xsd"
    schema.write_text(MODELS[model].schema(), encoding="utf-8")
    accepted = []

    @many(INPUTS)
    @given(styles(MODELS[model].dictionary))
    def run(xml):
        if context(model, xml, "kilted") or context(model, xml, "noetic"):
            accepted.append(xml)

    run()
    assert len(accepted) > INPUTS // 30
    for number, xml in enumerate(accepted):
        (tmp_path / f"{number}.xml").write_bytes(xml)
    found = subprocess.run(
        ["xmllint", "--noout", "--schema", schema, *tmp_path.glob("*.xml")],
        capture_output=True,
        text=True,
    )
    assert found.returncode == 0, re.sub(".* validates\n", "", found.stderr)[:3000]


@pytest.mark.parametrize(("model", "distro"), variants())
def test_copier_gives_the_same_files(uncloned, renderers, tmp_path, model, distro):
    numbers = itertools.count()

    @many(max(1, INPUTS // 1000))
    @given(inputs(MODELS[model].dictionary))
    def run(xml):
        folder = tmp_path / str(next(numbers))
        file = folder.with_suffix(".xml")
        file.write_bytes(xml)
        data = {"model": model, "ros_distro": distro, "spec_file": str(file)}
        try:
            copier.run_copy(
                str(uncloned), folder, data=data, defaults=True, unsafe=True, quiet=True
            )
        except UserMessageError:
            assert context(model, xml, distro) is None
            assert not folder.exists()
            return
        spec = context(model, xml, distro)
        expected = renderers[model].render(spec, distro)
        own = ("/.copier-answers.yml", ".ros_package")
        found = [path for path in folder.rglob("*") if path.is_file()]
        assert expected == {
            str(path.relative_to(folder)): path.read_text(encoding="utf-8")
            for path in found
            if not str(path).endswith(own)
        }

    run()


def test_cpp_compiles(renderers, tmp_path, ros1):
    """The interface and the logic of some packages, and their nodes that need no other header."""
    done = itertools.count(1)

    @many(COMPILED * 20)
    @given(specs(DICTIONARY))
    def run(xml):
        there = re.sub(rb'"(test|control)_msgs[^"]*"', b'"actionlib/TwoInts"', xml)
        spec = context("cpp_model", there, "noetic")
        if spec is None or not KNOWN.issuperset(spec["depends"]):
            return
        number = next(done)
        if number > COMPILED:
            return
        folder = tmp_path / str(number)  # a file that is missing may be in another package
        for name, text in renderers["cpp_model"].render(spec, "noetic").items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        for node in spec["nodes"]:
            parts = ("impl",) if node["dynParameters"] else ("impl", "ros")
            for part in parts:
                file = folder / f"src/{node['name']}_{part}.cpp"
                command = f"g++ {OPTIONS} -I{folder}/include -I{folder}/src {file}"
                found = subprocess.run(command.split(), capture_output=True, text=True)
                assert found.returncode == 0, found.stderr[:3000]
        if number % 10 == 0:
            print(f"{number} packages compiled")

    run()
    assert next(done) > COMPILED, "too few of the specs are accepted"
