"""Packages that tests render without Copier are those that Copier makes."""

import pytest

from support import model_checks

MODELS = model_checks.models()


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_copier_makes_the_same_files(renderers, tmp_path, model):
    source = model_checks.template(tmp_path / "template")
    for distro in {model.distros[0], model.distros[-1]}:
        spec = model.spec(model.everything(distro))
        made = model_checks.render(model, spec, distro, source)
        assert made == renderers[model.name].render(model.context(spec, distro), distro)
