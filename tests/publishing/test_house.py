"""House models: a published model with a few files of a team's own, without a fork."""

import functools
import re
import shutil

import pytest

from support.model_checks import template
from support.packages import answers
from support.repository import EXAMPLES, ROOT, bare_repository, commit, git, publish

PAGE = "docs/house.md"
PLACES = {
    "header.jinja": "Copyright Acme\n\nOf {{ spec.name }}\n",
    "README_before.md.jinja": "\n## Before {{ spec.name }}\n",
    "README_after.md.jinja": "\n## After {{ spec.name }}\n",
    "depends.xml.jinja": "  <test_depend>acme_{{ spec.name }}</test_depend>\n",
    "tests.cmake.jinja": "  add_test(acme_{{ spec.name }} true)\n",
    "github.yml.jinja": "  acme: {{ spec.name }}\n",
    "gitlab.yml.jinja": "acme: {{ spec.name }}\n",
}
LANDS = {
    "README_before.md.jinja": "README.md",
    "README_after.md.jinja": "README.md",
    "depends.xml.jinja": "package.xml",
    "tests.cmake.jinja": "CMakeLists.txt",
    "github.yml.jinja": ".github/workflows/package.yml",
    "gitlab.yml.jinja": ".gitlab-ci.yml",
}
SPECS = {
    "python_model": EXAMPLES / "all_kinds.ros_package",
    "cpp_model": EXAMPLES / "all_kinds.ros_package",
    "mixed_model": EXAMPLES / "driving.ros_package",
    "interfaces_model": EXAMPLES / "contact_msgs.ros_package",
}


def without(model, distro):
    """Return the places that the packages of a model do not have."""
    found = {"tests.cmake.jinja"} if (model, distro) == ("python_model", "kilted") else set()
    return found | (
        {"tests.cmake.jinja", "header.jinja"} if model == "interfaces_model" else set()
    )


@pytest.fixture(scope="module")
def filled(tmp_path_factory):
    """The collection with all places of a house filled."""
    folder = template(tmp_path_factory.mktemp("filled") / "collection")
    shutil.rmtree(folder / "examples")
    (folder / "house").mkdir()
    for name, text in PLACES.items():
        (folder / "house" / name).write_text(text)
    return folder


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("model", SPECS)
def test_places_are_in_packages_of_every_model(filled, render, model, distro):
    ci = {"github.yml.jinja": "github", "gitlab.yml.jinja": "gitlab"}
    packages = {
        name: render(
            SPECS[model], template=filled, name=name, model=model, ros_distro=distro, ci=name
        )
        for name in ci.values()
    }
    for place in PLACES.keys() - {"header.jinja"} - without(model, distro):
        package = packages[ci.get(place, "github")]
        said = PLACES[place].replace("{{ spec.name }}", SPECS[model].stem)
        assert said in (package / LANDS[place]).read_text(), place
    if "header.jinja" not in without(model, distro):
        written = [
            file.read_text()
            for file in packages["github"].rglob("*")
            if file.suffix in (".py", ".cpp", ".hpp", ".yaml")
        ]
        header = re.compile(r"^(#|//) Copyright Acme\n\1\n\1 Of \w+\n", re.MULTILINE)
        assert sum(map(len, map(header.findall, written))) > 20
        assert "SPDX" not in "".join(written)


def test_places_are_those_of_the_page():
    """Each one that a template has, and no other."""
    templates = [*ROOT.glob("shared/**/*.jinja"), *ROOT.glob("*_model/template/**/*.jinja")]
    found = {name for file in templates for name in re.findall(r'"house/(.+?)"', file.read_text())}
    told = re.findall(r"^\| `house/(.+?)` \|", (ROOT / PAGE).read_text(), re.MULTILINE)
    assert found == set(told) == set(PLACES)


BEGIN, *FILL_IN, PUBLISH, MOVE, NEXT, REPLACE, CLONE, MERGE = re.findall(
    r"^```sh\n(.*?)^```$", (ROOT / PAGE).read_text(), re.DOTALL | re.MULTILINE
)
CHECK = NEXT.splitlines()[1]


@pytest.fixture
def house(shell, github, tmp_path):
    """Make and publish the house model of the page; return its folder, and a shell."""
    run = functools.partial(shell, GIT_ALLOW_PROTOCOL="file")
    bare_repository(tmp_path / "github/acme/acme_model.git")
    run(BEGIN, tmp_path)
    folder = tmp_path / "acme_model"
    run("".join(FILL_IN), folder)
    run(PUBLISH, folder)
    return folder, run


@pytest.fixture
def release(github):
    """Publish a version of the collection, after a change of it."""
    collection, publish, _ = github

    def run(tag, **files):
        for name, text in files.items():
            (collection / "python_model" / name).write_text(text)
        gitignore = collection / "shared/gitignore"
        gitignore.write_text(f"{gitignore.read_text()}*.{tag}\n")
        commit(collection, tag=tag)
        publish()

    return run


def in_house(package, version):
    """Say what a package does not have of its house, or of a version of upstream."""
    logic = (package / "arm/reach_impl.py").read_text()
    told = {
        "header": "# Copyright 2026 Ada for Acme Robotics\n# All rights reserved.\n" in logic,
        "logic": "# Written by hand\n" in logic,
        "README": "The team wheels answers" in (package / "README.md").read_text(),
        "test": "as the team wheels wants" in (package / "test/test_acme.py").read_text(),
        "depends": all(
            f"_depend>{name}<" in (package / "package.xml").read_text()
            for name in ("acme_msgs", "acme_checks", "rclpy")
        ),
        "version": answers(package)["_commit"] == version,
        "upstream": f"*.{version.split('+')[0]}\n" in (package / ".gitignore").read_text(),
        "clean": "<<<<<<<" not in git(package, "grep", "-h", "-e", "^[^ ]", "--", "."),
    }
    return [name for name, found in told.items() if not found]


@pytest.fixture
def arm(shell, tmp_path):
    """Make a package of upstream, with logic."""
    (tmp_path / "arm.xml").write_text(
        """<package name="arm" author="Ada" author_email="ada@example.org" description="d"
                    license="MIT" copyright="2026 Ada">
             <node name="reach" frequency="10">
               <subscriber name="goal" type="std_msgs::Float64"/>
             </node>
           </package>"""
    )
    shell("copier copy --trust --defaults -d spec_file=arm.xml gh:org/python_model arm", tmp_path)
    logic = tmp_path / "arm/arm/reach_impl.py"
    logic.write_text(
        logic.read_text().replace("    def update", "    # Written by hand\n    def update")
    )
    commit(tmp_path / "arm")
    return tmp_path / "arm"


def test_three_versions_of_upstream(house, arm, release, tmp_path):
    """The commands of the page; a package moves to the house and follows it."""
    model, run = house
    run(MOVE, arm)
    commit(arm)
    spec = arm / "arm.ros_package"
    spec.write_text(spec.read_text().replace("<package ", '<package team="wheels" '))
    commit(arm)
    run("copier update --trust --defaults", arm)
    commit(arm)
    assert in_house(arm, "1.0.0+acme.1") == ["upstream"]

    release("1.1.0", **{"template/NEWS.md.jinja": "News\n"})
    run(NEXT, model)
    run("copier update --trust --defaults", arm)
    commit(arm)
    assert in_house(arm, "1.1.0+acme.1") == []
    assert (arm / "NEWS.md").read_text() == "News\n"

    release("1.2.0", **{"more.yaml": "", "template/test/test_acme.py": ""})
    checkout, check, *publish = NEXT.replace("1.1.0", "1.2.0").splitlines()
    run(checkout, model)
    said = run(f"{check} || true", model)
    assert "ln -s upstream/more.yaml . or name it in LEFT_OUT: ['more.yaml']" in said
    assert "upstream has these files, too: ['test/test_acme.py']" in said
    run("ln -s upstream/more.yaml . && git mv template/test/test_{acme,rules}.py.jinja", model)
    run("\n".join(["git add -A", check, *publish]), model)
    run("copier update --trust --defaults", arm)
    commit(arm)
    assert in_house(arm, "1.2.0+acme.1") == ["test"]
    assert "as the team wheels wants" in (arm / "test/test_rules.py").read_text()
    tags = git(tmp_path / "github/acme/acme_model.git", "tag").split()
    assert tags == [f"1.{minor}.0+acme.1" for minor in range(3)]


def test_another_file_in_place_of_upstreams(house, release, tmp_path):
    model, run = house
    run(REPLACE, model)
    run(f"{CHECK} && git add -A && git commit -m Replace && git tag 1.0.0+acme.2", model)
    run("copier copy --trust --defaults acme_model mypkg", tmp_path)
    assert (tmp_path / "mypkg/ruff.toml").read_text() == "line-length = 88\n"
    assert "Acme Robotics" in (tmp_path / "mypkg/mypkg/example_impl.py").read_text()
    release("1.1.0", **{"template/NEWS.md.jinja": "News\n"})
    said = run(f"{NEXT.splitlines()[0]} && ! {CHECK}", model)
    assert "link them into template, or name them in LEFT_OUT: ['NEWS.md']" in said
    (model / "upstream/moved_files.yaml").unlink()
    depends = model / "upstream/shared/other_depends.xml.jinja"
    depends.write_text(depends.read_text().replace("house/depends", "house/more"))
    said = run(f"git tag 1.1.0 && ! {CHECK}", model)
    assert re.search(r"upstream has these no more: .*moved_files\.yaml", said)
    assert "no template of upstream includes these: ['depends.xml.jinja']" in said
    assert "git tag -d, and git push --delete origin: ['1.1.0']" in said


@pytest.mark.parametrize("model", SPECS)
def test_house_of_every_model(shell, model, tmp_path):
    """One that fills nothing in makes what upstream makes."""
    shell(BEGIN.replace("python_model", model), tmp_path, GIT_ALLOW_PROTOCOL="file")
    commit(tmp_path / "acme_model")
    copy = f"copier copy --quiet --trust --defaults -d spec_file={SPECS[model]} -d ros_distro"
    for distro in ("noetic", "kilted"):
        for source, made in (("./acme_model", "ours"), (f"gh:org/{model}", "theirs")):
            command = f"{copy}={distro} {source} {distro}/{made}/{SPECS[model].stem}"
            shell(command, tmp_path, GIT_ALLOW_PROTOCOL="file")
        shell("diff -r -x .copier-answers.yml ours theirs", tmp_path / distro)


def test_fork_whose_tags_are_its_own(shell, release, tmp_path):
    """The commands of the page; a package refuses upstream's version, should its tag get there."""
    fork, mine = tmp_path / "acme_fork", tmp_path / "arm"
    address = bare_repository(tmp_path / "github/acme/acme_fork.git")

    def publish(tag):
        shell(f"git add -A && git commit --allow-empty -m House && git tag -f {tag}", fork)
        shell(f"git push -f {address} main {tag}", fork)

    shell(CLONE, tmp_path)
    assert git(fork, "tag") == ""
    (fork / "house").mkdir()
    (fork / "house/header.jinja").write_text("Copyright Acme\n")
    publish("1.0.0+acme.1")
    shell("copier copy --trust --defaults gh:acme/acme_fork arm", tmp_path)
    commit(mine)

    release("1.1.0")
    upstream = "https://github.com/org/python_model.git"
    shell(f"git fetch {upstream} 'refs/tags/*:refs/tags/*' && git push {address} --tags", fork)
    said = shell("! copier update --trust --defaults", mine)
    assert "1.1.0 is a version without a house, and 1.0.0+acme.1 made this package" in said
    assert "[version-without-house]" in said
    assert git(mine, "status", "--short") == ""

    shell(f"git push {address} --delete 1.0.0 1.1.0 && git tag -d 1.0.0 1.1.0", fork)
    shell(MERGE, fork)
    publish("1.1.0+acme.1")
    shell("copier update --trust --defaults", mine)
    assert "*.1.1.0" in (mine / ".gitignore").read_text()
    assert "# Copyright Acme\n" in (mine / "arm/example_impl.py").read_text()


def test_fork_of_the_collection_publishes_its_places(own_collection, tmp_path):
    (own_collection / "house").mkdir()
    (own_collection / "house/header.jinja").write_text("Copyright Acme\n")
    commit(own_collection, tag="1.0.0+acme.1")
    publish(own_collection, tmp_path / "acme")
    found = git(tmp_path / "acme/cpp_model.git", "show", "1.0.0+acme.1:house/header.jinja")
    assert found == "Copyright Acme"
