"""The workflows that `ci` adds to a package: their scripts are run, as far as they are ours."""

import pytest
import yaml

from support.repository import bare_repository, commit, git
from support.workflows import script_of

FILES = {"github": ".github/workflows/package.yml", "gitlab": ".gitlab-ci.yml"}


@pytest.fixture(params=FILES)
def service(request):
    return request.param


@pytest.mark.parametrize("model", ["python_model", "cpp_model", "mixed_model", "interfaces_model"])
@pytest.mark.parametrize("distro", ["noetic", "lyrical"])
def test_package_is_tested_on_its_distribution(render, service, model, distro):
    package = render(model=model, ros_distro=distro, ci=service)
    text = (package / FILES[service]).read_text()
    jobs = yaml.safe_load(text)
    jobs = jobs.get("jobs", jobs)
    assert {"test", "current", "update"} <= set(jobs)
    assert f"ROS_DISTRO: {distro}\n" in text
    assert [file for file in FILES.values() if (package / file).exists()] == [FILES[service]]


def test_only_the_update_may_write(render):
    package = render(ci="github")
    workflow = yaml.safe_load((package / FILES["github"]).read_text())
    assert workflow["permissions"] == {"contents": "read"}
    writing = [name for name, job in workflow["jobs"].items() if "permissions" in job]
    assert writing == ["update"]


def test_none_by_default_and_when_asked_for_none(render, update):
    package = render()
    assert not any((package / file).exists() for file in FILES.values())
    for service, file in FILES.items():
        update(package, ci=service)
        assert (package / file).exists()
        commit(package)
        update(package, ci="none")
        assert not (package / file).exists()
        commit(package)


def test_package_that_lags_behind_its_spec_fails(render, shell, service):
    package = render(name="arm", ci=service)
    script = script_of(package / FILES[service], "current")
    shell(script, package)
    spec = package / "arm.ros_package"
    spec.write_text(spec.read_text().replace("</node>", '<listener name="tf"/></node>'))
    commit(package)
    with pytest.raises(AssertionError, match=r"listener_tf"):
        shell(script, package)


@pytest.fixture
def origin(lagging, tmp_path):
    """A repository for the package that its model is ahead of."""
    bare = bare_repository(tmp_path / "github/org/arm.git")
    git(lagging, "remote", "add", "origin", bare)
    return bare


def test_update_opens_a_pull_request(lagging, origin, shell, tmp_path):
    """It pushes a branch with the update; a second run in the updated package does nothing."""
    script = script_of(lagging / FILES["github"], "update")
    shell(script, lagging)
    assert "*.bag" in git(lagging, "show", "origin/model-update:.gitignore")
    assert git(lagging, "log", "-1", "--format=%s", "origin/model-update") == "Update the model"
    assert (tmp_path / "tools/gh.log").read_text() == "pr create --fill\n"
    shell(script, lagging)
    assert len((tmp_path / "tools/gh.log").read_text().splitlines()) == 1


def test_update_opens_a_merge_request(lagging, origin, shell):
    git(origin, "config", "receive.advertisePushOptions", "true")
    shell("copier update --trust --defaults --vcs-ref=:current: -d ci=gitlab", lagging)
    commit(lagging)
    script = script_of(lagging / FILES["gitlab"], "update")
    shell(
        script,
        lagging,
        CI_SERVER_HOST="github.com",
        CI_PROJECT_PATH="org/arm",
        **token_for(origin),
    )
    assert "*.bag" in git(origin, "show", "model-update:.gitignore")


def token_for(origin):
    """Let the address with the token lead to the repository, beside that of the model."""
    return {
        "MODEL_UPDATE_TOKEN": "secret",
        "GIT_CONFIG_COUNT": "2",
        "GIT_CONFIG_KEY_1": f"url.file://{origin.parents[1]}/.insteadOf",
        "GIT_CONFIG_VALUE_1": "https://oauth2:secret@github.com/",
    }


def test_update_says_where_conflicts_are(lagging, origin, shell):
    gitignore = lagging / ".gitignore"
    gitignore.write_text(gitignore.read_text().replace("log/", "*.log"))
    commit(lagging)
    shell(script_of(lagging / FILES["github"], "update"), lagging)
    subject = git(lagging, "log", "-1", "--format=%s", "origin/model-update")
    assert subject == "Update the model (conflicts)"
