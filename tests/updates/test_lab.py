"""Updates lose no line: some trials of the merge laboratory. `make lab` runs many more."""

import os

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from support import lab

TRIALS = int(os.environ.get("LAB_TRIALS", "16"))
SEED = os.environ.get("LAB_SEED")


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory):
    laboratory = lab.Laboratory(tmp_path_factory.mktemp("lab"))
    yield laboratory
    print(report(laboratory.counts))


def report(counts):
    free = counts.independent - sum(counts.unneeded.values())
    return (
        f"{counts.updates} updates, {counts.merges} edited files, {counts.lines} lines written\n"
        f"lost lines: {counts.lost}; lines in removed files, said: {counts.said}\n"
        f"conflicts: {counts.conflicts}; independent edits merged without one: "
        f"{free} of {counts.independent}; others: {dict(counts.unneeded)}"
    )


@settings(
    max_examples=TRIALS,
    deadline=None,
    derandomize=SEED is None,
    database=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.generate],
)
@given(st.data())
def trial(laboratory, data):
    spec = data.draw(lab.specs())
    new_spec = data.draw(lab.changed(spec))
    version = data.draw(st.sampled_from(("1.0.0", "2.0.0")))
    model = data.draw(st.sampled_from(lab.MODELS))
    distro = data.draw(st.sampled_from(lab.DISTROS))
    random = data.draw(st.randoms(use_true_random=False))
    laboratory.trial(spec, new_spec, version, model, distro, random)


def test_no_line_is_lost(laboratory):
    trial(laboratory)
    counts = laboratory.counts
    assert counts.updates >= TRIALS
    assert counts.lost == 0
    assert counts.independent > TRIALS
    free = counts.independent - sum(counts.unneeded.values())
    assert free >= 0.995 * counts.independent, report(counts)
