"""What several nodes have in common: one type for their code, and nothing where there is none."""

import itertools
import subprocess

import pytest

from support import ros
from support.linters import cpp_faults, python_faults, ruff_faults, type_faults, write
from support.packages import DATA, model_of

SPEC = (DATA / "groups.ros_package").read_text()
MODELS = ("python_model", "cpp_model", "mixed_model")
VARIANTS = list(itertools.product(MODELS, ("noetic", "kilted")))
LANGUAGES = {"left_arm": "python", "right_arm": "cpp", "door": "python", "alone": "cpp"}
COMMON = '''"""What all nodes of the group do."""

from {package}.every_kind_interface import (
    EveryKindConfig,
    EveryKindData,
    EveryKindPassthrough,
    PubFix,
)
from {package}.left_arm_interface import LeftArmConfig, LeftArmData, LeftArmPassthrough
from {package}.place_interface import PlaceConfig


def act(passthrough: EveryKindPassthrough, config: EveryKindConfig, data: EveryKindData) -> float:
    """Publish, log and compute."""
    passthrough.pub_fix.publish(PubFix())
    passthrough.log.info(config.frame_id)
    return config.gain * float(data.in_speed.data)


def left(passthrough: LeftArmPassthrough, config: LeftArmConfig, data: LeftArmData) -> float:
    """Do it for a node that has the group."""
    return act(passthrough, config, data) + config.port


def place(config: PlaceConfig) -> str:
    """Return what nodes with the other group have."""
    return config.place
'''


def spec_for(model):
    text = SPEC
    for name, language in LANGUAGES.items() if model == "mixed_model" else ():
        text = text.replace(f'<node name="{name}"', f'<node name="{name}" language="{language}"')
    return text


@pytest.fixture
def packages(renderers, tmp_path):
    """The package of each model and ROS, and its context, by its folder."""
    contexts = {}
    for model, distro in VARIANTS:
        text = spec_for(model).replace('"sharing"', f'"sharing_{model[:3]}_{distro}"')
        context = model_of(model).context(text.encode(), "spec.xml", distro)
        contexts[f"{model}-{distro}"] = context
        write(tmp_path / "all" / f"{model}-{distro}", renderers[model].render(context, distro))
    return contexts


def test_a_group_has_one_type_for_the_code_of_its_nodes(packages, tmp_path):
    for name, context in packages.items():
        folder, package = tmp_path / "all" / name, context["name"]
        python = folder / package
        if (python / "left_arm_interface.py").exists():
            left = (python / "left_arm_interface.py").read_text()
            for base in ("Config", "Data", "Passthrough"):
                assert f"class LeftArm{base}(EveryKind{base}):" in left
            own = left.partition("\nclass ")[2]
            assert "port: int = 1" in own
            assert "frame_id" not in own
            assert "in_speed" not in own
            assert "log: Log" not in own
            assert "frame_id: str = 'gps'" in (python / "every_kind_interface.py").read_text()
        headers = folder / "include" / package
        if (headers / "right_arm_interface.hpp").exists():
            right = (headers / "right_arm_interface.hpp").read_text()
            assert "struct RightArmConfig : PlaceConfig, EveryKindConfig\n" in right
            assert "struct RightArmData : EveryKindData\n" in right
            assert "struct RightArmPassthrough : PlacePassthrough, EveryKindPassthrough\n" in right
            assert "using PubFix = every_kind_types::PubFix;" in right
            assert "frame_id" not in right
            place = (headers / "place_interface.hpp").read_text()
            assert "struct PlacePassthrough : virtual Passthrough\n" in place
            assert "PlaceData" not in place


def test_a_part_of_a_mixed_package_has_the_groups_of_its_nodes(packages, tmp_path):
    for distro in ("noetic", "kilted"):
        folder = tmp_path / f"all/mixed_model-{distro}"
        names = {file.name for file in folder.rglob("*_interface.*")}
        assert names == {
            "left_arm_interface.py",
            "door_interface.py",
            "every_kind_interface.py",
            "place_interface.py",
            "right_arm_interface.hpp",
            "alone_interface.hpp",
            "every_kind_interface.hpp",
            "place_interface.hpp",
        }


def test_readmes_and_attributes_of_git_have_groups(packages, tmp_path):
    readme = (tmp_path / "all/python_model-kilted/README.md").read_text()
    assert "| place | right_arm, door | `PlaceConfig`, `PlacePassthrough` |" in readme
    marked = (tmp_path / "all/cpp_model-kilted/.gitattributes").read_text()
    assert "every_kind_interface.hpp gitlab-generated" in marked


def test_a_package_without_groups_has_no_line_of_them(renderers, tmp_path):
    """A node is the same whether the package has groups that it does not use."""
    for model, distro in VARIANTS:
        hook = model_of(model)
        text = spec_for(model)
        without = text[: text.index("  <group")] + text[text.index('  <node name="alone"') :]
        files = renderers[model].render(hook.context(without.encode(), "x", distro), distro)
        assert "passthrough.hpp" not in {name.rpartition("/")[2] for name in files}
        for name, lines in files.items():
            lines = lines.replace("getGroupNames", "").replace("callback_group", "")
            assert "every_kind" not in lines, name
            assert "What nodes have in common" not in lines, name
        both = renderers[model].render(hook.context(text.encode(), "x", distro), distro)
        alone = [name for name in files if "alone_interface" in name]
        assert alone
        assert all(both[name] == files[name] for name in alone)


def test_packages_with_groups_have_the_layout_of_ruff(packages, tmp_path):
    faults = ruff_faults(tmp_path / "all")
    assert not faults, faults


def test_packages_with_groups_pass_their_linters(packages, tmp_path, ros2):
    faults = python_faults(ros2, tmp_path / "all") + cpp_faults(ros2, tmp_path / "all")
    assert not faults, faults


def test_code_for_nodes_with_a_group_passes_mypy(renderers, tmp_path, ros2):
    found = {}
    for model in ("python_model", "mixed_model"):
        text = ros.fitting(ros2, spec_for(model)).replace('"sharing"', f'"sharing_{model[:3]}"')
        context = model_of(model).context(text.encode(), "spec.xml", "kilted")
        package = context["name"]
        files = renderers[model].render(context, "kilted")
        common = {f"{package}/act.py": COMMON.format(package=package)}
        write(tmp_path / "all" / package, {**files, **common})
        found[package] = context
    faults = type_faults(ros2, tmp_path / "all", found)
    assert not faults, faults


ASSIGNED = """
#include <type_traits>
#include "support/talk_harness.hpp"

static_assert(!std::is_assignable_v<lab::TalkHarness &, const lab::TalkHarness &>);
"""


def test_a_harness_is_not_assigned(renderers, tmp_path):
    """Its fakes know it; and GCC warns of an assignment of the virtual base that groups have."""
    spec = """
<package name="lab" author="A" author_email="a@example.org" description="d" license="MIT">
  <group name="voice"><directPublisher name="said" type="std_msgs::String"/></group>
  <node name="talk"><use group="voice"/></node>
</package>
"""
    context = model_of("cpp_model").context(spec.encode(), "spec.xml", "noetic")
    write(tmp_path, renderers["cpp_model"].render(context, "noetic"))
    write(tmp_path, {"std_msgs/String.h": "#pragma once\nnamespace std_msgs {struct String {};}"})
    write(tmp_path, {"main.cpp": ASSIGNED})
    command = "g++ -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I. -Iinclude -Itest main.cpp"
    subprocess.run(command.split(), cwd=tmp_path, check=True)
