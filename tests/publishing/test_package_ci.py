"""The workflows that `ci` adds to a package: their scripts are run, as far as they are ours."""

import re

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
    said = git(lagging, "log", "-1", "--format=%b", "origin/model-update")
    assert re.search(r"^merged +\.gitignore$", said, re.MULTILINE), said
    assert asked(tmp_path) == ["pr create --fill --head model-update"]
    shell(script, lagging)
    assert len(asked(tmp_path)) == 1


def asked(tmp_path):
    """Return what GitHub was asked to do."""
    log = (tmp_path / "tools/gh.log").read_text().splitlines()
    return [line for line in log if line.startswith("pr ") and " list " not in line]


def test_open_request_is_brought_up_to_date(lagging, origin, shell, tmp_path):
    """Nobody has worked on the branch: it is made anew from the package as it is now."""
    script = script_of(lagging / FILES["github"], "update")
    shell(script, lagging)
    (tmp_path / "tools/requests").write_text("1\n")
    git(lagging, "switch", "main")
    git(lagging, "branch", "-D", "model-update")
    (lagging / "own.txt").write_text("own\n")
    commit(lagging, "Go on")
    shell(script, lagging)
    assert "own" in git(origin, "show", "model-update:own.txt")
    assert asked(tmp_path)[1].startswith("pr edit model-update --title Update the model --body ")


@pytest.mark.parametrize("service", FILES)
def test_commits_of_a_reviewer_stay(lagging, origin, shell, tmp_path, service):
    git(origin, "config", "receive.advertisePushOptions", "true")
    shell(f"copier update --trust --defaults --vcs-ref=:current: -d ci={service}", lagging)
    if git(lagging, "status", "--porcelain"):
        commit(lagging)
    script = script_of(lagging / FILES[service], "update")
    more = {"CI_SERVER_HOST": "github.com", "CI_PROJECT_PATH": "org/arm", **token_for(origin)}
    shell(script, lagging, **more)
    git(lagging, "config", "user.email", "reviewer@example.org")
    (lagging / "review.txt").write_text("mine\n")
    commit(lagging, "Mend what the update asks")
    git(lagging, "push", f"file://{origin}", "model-update")
    reviewed = git(origin, "rev-parse", "model-update")
    git(lagging, "switch", "main")
    git(lagging, "branch", "-D", "model-update")
    assert "has commits of others" in shell(script, lagging, **more)
    assert git(origin, "rev-parse", "model-update") == reviewed


def test_request_that_fails_is_told(lagging, origin, shell, tmp_path):
    (tmp_path / "tools/gh").write_text("#!/bin/sh\n[ $2 = list ] && echo 0\n")
    with pytest.raises(AssertionError):
        shell(script_of(lagging / FILES["github"], "update"), lagging)


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
