"""The merge laboratory: a seeded part of what `make lab` runs, and a judge that is not blind."""

import itertools
import os
import time
from random import Random

import pytest
import yaml

from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.tree import File
from support import ros
from support.laboratory import branches, specs
from support.laboratory.edits import HABITS
from support.laboratory.mutants import MUTANTS, OF_HABITS
from support.laboratory.running import compiles, runs
from support.laboratory.trials import ALL_MODELS, DISTROS, MODELS, Counts, chain, trial

TRIALS = int(os.environ.get("LAB_TRIALS", "10"))
"""Updates for each model and each ROS."""
SEED = os.environ.get("LAB_SEED", "1").replace("random", str(time.time_ns()))
CHAIN = int(os.environ.get("LAB_CHAIN", "2"))
"""How many updates follow one another in a package, with all of Copier's."""
PAIRS = int(os.environ.get("LAB_PAIRS", "2"))
"""Pairs of branches for each model and each ROS."""
VERSIONS = (("1.0.0", "1.0.0"), ("1.0.0", "2.0.0"), ("0.9.0", "1.0.0"))
EACH = 2
"""How often one pair of renders is edited."""
AT_LENGTH = TRIALS >= 100
VARIANTS = [(model, distro) for model in MODELS for distro in DISTROS]


@pytest.fixture(scope="module")
def has_ros1():
    return ros.ros1() is not None


def run(laboratory, has_ros1, model, distro, trials, ways=None, moving=0.15):
    """Run the trials of a variant; say how far they are, and how long it will take.

    One in fifty of the packages is run, or compiled. Each pair of renders has a seed of its own,
    with which it is made again.
    """
    counts, start = Counts(), time.monotonic()
    only_logic = ways is not None
    check = checks(model, distro, has_ros1)
    while counts.updates < trials:
        seed = f"{SEED} {model} {distro} {counts.updates}"
        random = Random(seed)
        has_nodes = model != "interfaces_model"
        spec = (
            specs.random_spec(random, only_logic) if has_nodes else specs.random_interfaces(random)
        )
        new_spec = specs.change(random, spec, only_logic, ways)
        moves = not only_logic and random.random() < moving
        other = random.choice(DISTROS) if moves else distro
        old_version, version = random.choice(VERSIONS if model in MODELS else VERSIONS[:2])
        pair = laboratory.pair(spec, new_spec, model, (distro, other), version, old_version)
        for _ in range(EACH):
            turn = check if counts.updates % 50 == 0 else None
            for complaint in trial(random, pair, counts, check=turn, only_logic=only_logic):
                print(f"seed {seed}: {complaint}")
        if counts.updates % 100 == 0:
            left = (time.monotonic() - start) / counts.updates * (trials - counts.updates)
            print(f"{model} {distro}: {counts.updates} of {trials}, {left / 60:.0f} minutes left")
    print(f"{model} {distro}: {counts.row()}")
    return counts


def checks(model, distro, has_ros1):
    """Return what tells whether a package of this variant still runs, or compiles."""
    if model == "python_model":
        return runs
    is_built = model == "cpp_model" and distro == "noetic" and has_ros1
    return compiles if is_built else None


@pytest.mark.lab
@pytest.mark.parametrize(("model", "distro"), VARIANTS)
def test_no_callback_changes_place(laboratory, has_ros1, model, distro):
    """Reorder, remove, add, replace, retype, rename callbacks: bodies stay with their names."""
    ways = "add remove reorder replace retype rename swap".split()
    counts = run(laboratory, has_ros1, model, distro, max(TRIALS // 2, 10), ways)
    assert counts.lines > counts.updates
    assert counts.wrong == []
    assert sum(counts.conflicts.values()) == 0


@pytest.mark.lab
@pytest.mark.parametrize("distro", DISTROS)
@pytest.mark.parametrize("model", ALL_MODELS)
def test_no_line_is_lost(laboratory, has_ros1, model, distro):
    """Edit everything, change everything."""
    counts = run(laboratory, has_ros1, model, distro, TRIALS)
    assert counts.both_changed > counts.updates
    assert counts.wrong == []
    assert sum(counts.conflicts.values()) <= 0.01 * counts.edited_files


@pytest.mark.lab
@pytest.mark.parametrize(("model", "distro"), VARIANTS)
def test_updates_follow_one_another(laboratory, has_ros1, model, distro):
    """Run Copier itself: other specs, models, ROS and settings of git, one after the other."""
    random, counts = Random(f"{SEED} chain {model} {distro}"), Counts()
    check = checks(model, distro, has_ros1 and CHAIN > 2)
    chain(random, laboratory, model, distro, CHAIN, counts, check)
    print(f"{model} {distro}, chain: {counts.row()}")
    assert counts.updates
    assert counts.wrong == []


@pytest.mark.lab
@pytest.mark.parametrize("distro", DISTROS)
@pytest.mark.parametrize("model", ALL_MODELS)
def test_moves_lose_nothing_in_silence(laboratory, has_ros1, model, distro):
    """Edit everything, change everything, and move to the other ROS."""
    counts = run(laboratory, has_ros1, model, distro, TRIALS, moving=1)
    assert counts.lines > counts.updates
    assert counts.wrong == []


@pytest.mark.lab
@pytest.mark.parametrize("distro", DISTROS)
@pytest.mark.parametrize("model", ALL_MODELS)
def test_two_branches_become_one(laboratory, model, distro):
    """Two developers edit, change the spec and update; one of them may move to another ROS.

    Each pair has a seed of its own, with which it is made again.
    """
    counts = branches.Counts()
    for number in itertools.count():
        if counts.pairs == PAIRS:
            break
        random = Random(f"{SEED} branches {model} {distro} {number}")
        ways = set(HABITS) - {"format"} if random.random() < 0.5 else ()
        for said in branches.pair_of_branches(
            random, laboratory, model, distro, counts, ways=ways
        ):
            print(f"{model} {distro}, pair {number}: {said}")
    print(f"{model} {distro}, branches: {counts.row()}")
    assert counts.both_edited > counts.pairs
    assert counts.wrong == []
    assert len(counts.refused) <= max(1, 0.02 * PAIRS)
    assert sum(counts.conflicts.values()) <= 0.2 * counts.both_edited


@pytest.fixture(scope="module")
def joins(laboratory):
    """Yield joined branches, which the first who wants them makes."""
    random, made = Random(2), []

    def get():
        for number in range(12):
            if number == len(made):
                about = (laboratory, "python_model", "kilted", branches.Counts())
                made.append(branches.joined(random, *about, ways=()))
            if made[number]:
                yield made[number]

    return get


@pytest.mark.parametrize("mutant", branches.MUTANTS, ids=lambda mutant: mutant.__name__)
def test_the_judge_sees_a_wrong_join(joins, mutant):
    found = (branches.spoiled(mutant, *made) for made in joins())
    wrong = [*itertools.islice(filter(None, found), 3)]
    assert wrong
    for made in wrong:
        assert branches.judged(*made, branches.Counts())


EXCHANGES = {
    "swapped": {"load": "store", "store": "load"},
    "in a circle": {"load": "store", "store": "home", "home": "load"},
    "in a row": {"load": "store", "store": "home", "home": "estop"},
    "one left": {"load": None, "store": "load"},
    "two left": {"load": None, "home": "load", "store": None},
}


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("names", EXCHANGES.values(), ids=EXCHANGES)
def test_callbacks_that_exchange_names_keep_their_bodies(laboratory, model, names):
    random, counts = Random(5), Counts()
    spec = specs.random_spec(random, callbacks_only=True)
    node = spec["nodes"][0]
    node["items"] = [
        {"kind": "serviceServer", "name": name, "type": 0, "text": ""}
        for name in ("load", "store", "home")
    ]
    items = [
        item | {"name": names.get(item["name"], item["name"]), "was": item["name"]}
        for item in node["items"]
        if names.get(item["name"], "") is not None
    ]
    items = [item | {"was": None} if item["was"] == item["name"] else item for item in items]
    new_spec = {**spec, "nodes": [{**node, "items": items}, *spec["nodes"][1:]]}
    pair = laboratory.pair(spec, new_spec, model, ("kilted",) * 2, "2.0.0")
    for _ in range(3):
        assert trial(random, pair, counts, only_logic=True) == []
    assert sum(counts.conflicts.values()) == 0


@pytest.mark.parametrize("names", EXCHANGES.values(), ids=EXCHANGES)
def test_tuned_parameters_keep_their_values_under_new_names(laboratory, names):
    node = {"name": "reach", "frequency": 10}
    olds = ("load", "store", "home")
    news = {old: names.get(old, old) for old in olds}
    items = [{"kind": "parameter", "type": 1, "text": "", "name": old} for old in olds]
    new_items = [
        item
        | {
            "name": news[item["name"]],
            "was": item["name"] if news[item["name"]] != item["name"] else None,
        }
        for item in items
        if news[item["name"]]
    ]
    spec, new_spec = (
        {"description": "Arms", "nodes": [{**node, "items": listed}]}
        for listed in (items, new_items)
    )
    pair = laboratory.pair(spec, new_spec, "python_model", ("kilted",) * 2, "1.0.0")
    path = "config/reach.yaml"
    values = {old: number for number, old in enumerate(olds, 5)}
    mine = pair.old[path]
    for old, value in values.items():
        mine = mine.replace(f"{old}: 1.0", f"{old}: {value}  # mine")
    trees = [{path: File(text.encode())} for text in (mine, pair.old[path], pair.new[path])]
    result = merge_package(*trees, pair.renaming, pair.is_kept)
    assert not result.conflicts
    found = yaml.safe_load(result.tree[path].text)["/**"]["ros__parameters"]
    own = {new: values[old] for old, new in news.items() if new}
    assert found == own | {"frequency": 10.0, "stop_timeout": 2.0}
    assert prove(*trees[:2], result, result.tree, pair.renaming).lost == []


@pytest.fixture(scope="module")
def pairs(laboratory):
    """Updates in which every mutant finds something to spoil."""
    random = Random(7)
    found = []
    for model in MODELS:
        spec = specs.random_spec(random, callbacks_only=True)
        node = spec["nodes"][0]
        node["items"] = [
            {"kind": "serviceServer", "name": name, "type": 0, "text": ""}
            for name in ("load", "store", "home")
        ]
        replaced = {**node, "items": [*node["items"][1:], {**node["items"][0], "name": "estop"}]}
        renamed = [{**node["items"][0], "name": "stop", "was": "load"}, *node["items"][1:]]
        for items in (replaced["items"], renamed):
            nodes = [{**node, "items": items}, *spec["nodes"][1:]]
            new_spec = {**spec, "nodes": nodes}
            found.append(laboratory.pair(spec, new_spec, model, ("kilted",) * 2, "2.0.0"))
    return found


@pytest.mark.parametrize("mutant", [*MUTANTS, *OF_HABITS], ids=lambda mutant: mutant.__name__)
def test_the_judge_sees_a_wrong_merge(pairs, mutant):
    spoiled = []
    options = {"ways": (), "always": {OF_HABITS.get(mutant)}}

    def spoil(*arguments):
        spoiled.append(mutant(*arguments))

    for turn, pair in enumerate(pairs * 4):
        complaints = trial(Random(turn), pair, Counts(), spoil, **options)
        if spoiled[-1]:
            of_judge = [said for said in complaints if not said.startswith("proof: ")]
            assert of_judge, f"{mutant.__name__} was not seen"
            assert trial(Random(turn), pair, Counts(), **options) == []
        if sum(spoiled) == 3:
            break
    assert any(spoiled), f"{mutant.__name__} found nothing to spoil"
