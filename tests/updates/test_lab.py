"""The merge laboratory: a seeded part of what `make lab` runs, and a judge that is not blind."""

import os
import time
from random import Random

import pytest

from support.laboratory import specs
from support.laboratory.mutants import MUTANTS
from support.laboratory.trials import DISTROS, MODELS, Counts, Laboratory, chain, trial

TRIALS = int(os.environ.get("LAB_TRIALS", "20"))
"""Trials for each model and each ROS."""
SEED = os.environ.get("LAB_SEED", "1").replace("random", str(time.time_ns()))
CHAIN = int(os.environ.get("LAB_CHAIN", "2"))
"""How many updates follow one another in a package, with all of Copier's."""
EACH = 5 if TRIALS < 100 else 20
"""How often one pair of renders is edited, for renders take longer than merges."""
VARIANTS = [(model, distro) for model in MODELS for distro in DISTROS]


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory):
    return Laboratory(tmp_path_factory.mktemp("lab"))


def run(laboratory, model, distro, callbacks_only, ways=None):
    """Run the trials of a variant; say how far they are, and how long it will take."""
    random, counts, start = Random(f"{SEED} {model} {distro}"), Counts(), time.monotonic()
    while counts.updates < TRIALS:
        spec = specs.random_spec(random, callbacks_only)
        new_spec = specs.change(random, spec, callbacks_only, ways)
        moves = not callbacks_only and random.random() < 0.15
        other = random.choice(DISTROS) if moves else distro
        version = random.choice(("1.0.0", "2.0.0"))
        pair = laboratory.pair(spec, new_spec, model, (distro, other), version)
        for _ in range(min(EACH, TRIALS - counts.updates)):
            trial(random, pair, counts, only_logic=callbacks_only)
        spent = time.monotonic() - start
        left = spent / counts.updates * (TRIALS - counts.updates)
        print(f"{model} {distro}: {counts.updates} of {TRIALS}, {left / 60:.0f} minutes left")
    print(f"{model} {distro}: {counts.row()}")
    return counts


@pytest.mark.parametrize(("model", "distro"), VARIANTS)
def test_no_callback_changes_place(laboratory, model, distro):
    """Reorder, remove, add, replace, retype, rename callbacks: bodies stay with their names."""
    ways = "add remove reorder replace retype rename swap".split()
    counts = run(laboratory, model, distro, callbacks_only=True, ways=ways)
    assert counts.updates >= TRIALS
    assert counts.lines > counts.updates
    assert counts.wrong == []
    assert sum(counts.conflicts.values()) == 0


@pytest.mark.parametrize(("model", "distro"), VARIANTS)
def test_no_line_is_lost(laboratory, model, distro):
    """Edit everything, change everything."""
    counts = run(laboratory, model, distro, callbacks_only=False)
    assert counts.both_changed > counts.updates
    assert counts.wrong == []
    assert sum(counts.conflicts.values()) <= 0.01 * counts.edited_files


@pytest.mark.parametrize(("model", "distro"), VARIANTS)
def test_updates_follow_one_another(laboratory, model, distro):
    """Run Copier itself: other specs, models, ROS and formatters, one after the other."""
    random, counts = Random(f"{SEED} chain {model} {distro}"), Counts()
    chain(random, laboratory, model, distro, CHAIN, counts)
    print(f"{model} {distro}, chain: {counts.row()}")
    assert counts.updates
    assert counts.wrong == []


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


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.__name__)
def test_the_judge_sees_a_wrong_merge(pairs, mutant):
    random = Random(3)
    spoiled = []

    def spoil(*arguments):
        spoiled.append(mutant(*arguments))

    for pair in [*pairs, *pairs]:
        assert trial(random, pair, Counts(), formatters=False) == []
        complaints = trial(random, pair, Counts(), spoil, formatters=False)
        assert complaints or not spoiled[-1], f"{mutant.__name__} was not seen"
        if sum(spoiled) == 3:
            break
    assert any(spoiled), f"{mutant.__name__} found nothing to spoil"
