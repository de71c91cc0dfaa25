"""runtime_model makes the runtime that the packages of the other models hold, as a package."""

import re
import xml.etree.ElementTree as ET

import pytest

from support.packages import RUNTIME, all_kinds, model_of
from support.repository import ROOT

NAME = RUNTIME.stem
DISTROS = ("noetic", "humble", "kilted")


def context(model, xml, distro):
    return model_of(model).context(xml.encode(), "spec", distro)


def held(renderers, model, distro):
    """Return the runtime of a package that uses all of it, as it is in its own folders."""
    root = ET.fromstring(all_kinds().replace("all_kinds", NAME))
    ET.SubElement(root, "group", name="common")
    ET.SubElement(root.find("node"), "use", group="common")
    spec = context(model, ET.tostring(root, encoding="unicode"), distro)
    spec |= {"copyright": "2026 Ada Lovelace", "license": "Apache-2.0"}
    spec["nodes"][0] |= {"diagnostics": True, "client_library": True, "reconfigure": True}
    every = {"name": "a.b", "type": "int[]", "value": None, "min": 1, "max": 2, "choices": [1]}
    spec["nodes"][0]["parameters"][0] |= every
    files = renderers[model].render(spec, distro)
    return {name: text for name, text in files.items() if "/ros/" in name}


def shared(renderers, distro, language="both"):
    spec = context("runtime_model", RUNTIME.read_text(), distro) | {"language": language}
    return renderers["runtime_model"].render(spec, distro)


def test_it_has_the_version_of_the_models():
    text = (ROOT / "shared/runtime/place.yml").read_text() + (ROOT / "pyproject.toml").read_text()
    versions = set(re.findall(r'^(?:version =|  default:) "([\d.]+)"$', text, re.MULTILINE))
    assert len(versions) == 1, versions


@pytest.mark.parametrize("distro", DISTROS)
def test_modules_are_those_of_a_package(renderers, distro):
    files = {n: t for n, t in shared(renderers, distro).items() if n.startswith(f"{NAME}/ros/")}
    assert files == held(renderers, "python_model", distro)


@pytest.mark.parametrize("distro", DISTROS)
def test_headers_are_those_of_a_package(renderers, distro):
    """They are in one folder, and their guards say so."""
    expected = {
        name.replace("src/", f"include/{NAME}/"): re.sub(
            r"\bROS__(\w+_HPP_)", rf"{NAME.upper()}__ROS__\1", text
        )
        for name, text in held(renderers, "cpp_model", distro).items()
    }
    files = {n: t for n, t in shared(renderers, distro).items() if n.startswith("include/")}
    assert files == expected


@pytest.mark.parametrize("distro", DISTROS)
def test_one_language(renderers, distro):
    python, cpp = (shared(renderers, distro, language) for language in ("python", "cpp"))
    assert not [name for name in python if name.endswith(".hpp")]
    assert not [name for name in cpp if name.endswith(".py")]
    for word in ("rclcpp", "roscpp", "gtest", "include"):
        assert word not in python["package.xml"] + python["CMakeLists.txt"]
    for word in ("rclpy", "rospy", "python", "pytest"):
        assert word not in cpp["package.xml"] + cpp["CMakeLists.txt"]
