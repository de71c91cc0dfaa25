"""runtime_model makes the runtime that the packages of the other models hold, as a package."""

import re
import xml.etree.ElementTree as ET

import pytest

from support.packages import RUNTIME, all_kinds, model_of
from support.repository import ROOT

NAME = RUNTIME.stem
DISTROS = ("noetic", "humble", "kilted")
WORKER = """
<package name="worker" author="A" author_email="a@b.example.org" description="d" license="MIT">
  <node name="worker" frequency="10">
    <publisher name="state" type="std_msgs::String"/>
    <subscriber name="command" type="std_msgs::String"/>
    <dynParameter name="gain" type="double" value="1.0" description="How much"/>
  </node>
</package>
"""


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
    spec["nodes"][0]["parameters"][-1]["name"] = "lambda"
    spec["nodes"][0]["directSubscribers"][0]["topic_parameter"] = "echo_topic"
    spec["nodes"][0]["serviceServers"][0] |= {"reliability": "best_effort", "depth": 1}
    spec["nodes"][0]["serviceClients"][0] |= {"reliability": "best_effort"}
    return renderers[model].render(spec, distro)


def runtime_of(files):
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
    assert files == runtime_of(held(renderers, "python_model", distro))


@pytest.mark.parametrize("distro", DISTROS)
def test_headers_are_those_of_a_package(renderers, distro):
    """They are in one folder, and their guards say so."""
    expected = {
        name.replace("src/", f"include/{NAME}/"): re.sub(
            r"\bROS__(\w+_HPP_)", rf"{NAME.upper()}__ROS__\1", text
        )
        for name, text in runtime_of(held(renderers, "cpp_model", distro)).items()
    }
    files = shared(renderers, distro)
    assert {n: t for n, t in files.items() if n.startswith(f"include/{NAME}/ros/")} == expected


@pytest.mark.parametrize("language", ["python", "cpp"])
@pytest.mark.parametrize("distro", DISTROS)
def test_support_of_tests_is_that_of_a_package(renderers, distro, language):
    """But for its place, and what belongs to one node; the packages that share it have none."""
    model = f"{language}_model"
    files = shared(renderers, distro, language)
    support = {n: t for n, t in files.items() if "/testing/" in n and "__init__" not in n}
    spec = context(model, all_kinds(), distro)
    left = [n for n in renderers[model].render(spec, distro, runtime=NAME) if "/support/" in n]
    expected = {}
    for name, text in held(renderers, model, distro).items():
        if "test/support/" in name and name.replace(f"/{NAME}/", "/all_kinds/") not in left:
            place = f"include/{NAME}/testing/" if name.endswith(".hpp") else f"{NAME}/testing/"
            expected[place + name.rpartition("/")[2]] = moved(text)
    assert {name: moved(text) for name, text in support.items()} == expected
    assert len(support) > 2
    assert all("run_test" in n or "harness.hpp" in n or "_impl.hpp" in n for n in left), left


@pytest.mark.parametrize(("model", "most"), [("python_model", 950), ("cpp_model", 1400)])
@pytest.mark.parametrize("distro", DISTROS)
def test_a_package_that_shares_it_is_small(renderers, distro, model, most):
    """One node with three interfaces, with its documentation and tests."""
    package = renderers[model].render(context(model, WORKER, distro), distro, runtime=NAME)
    assert 300 < sum(len(text.splitlines()) for text in package.values()) < most


@pytest.mark.parametrize("runtime", ["inside", NAME])
@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
@pytest.mark.parametrize("distro", DISTROS)
def test_each_file_that_is_marked_as_generated_is_there(renderers, distro, model, runtime):
    package = renderers[model].render(context(model, WORKER, distro), distro, runtime=runtime)
    marked = [line.split()[0] for line in package[".gitattributes"].splitlines()[1:]]
    missing = [
        path for path in marked if not any(name.startswith(path.strip("/*")) for name in package)
    ]
    assert missing == ["/.copier-answers.yml"]  # Copier's own


@pytest.mark.parametrize("distro", DISTROS)
def test_cpp_names_what_it_uses_of_the_support(renderers, distro):
    """In the tests of a package that shares it, with `using`."""
    spec = context("cpp_model", all_kinds(), distro)
    spec["nodes"][0] |= {"diagnostics": True, "reconfigure": True}
    package = renderers["cpp_model"].render(spec, distro, runtime=NAME)
    support = shared(renderers, distro, "cpp")
    for header, pattern in (("recorder", "_impl.hpp"), ("fakes", "_harness.hpp")):
        text = support[f"include/{NAME}/testing/{header}.hpp"]
        offered = re.findall(
            r"^(?:inline )?[\w:<>]+(?: &)? (\w+)\(|^class (\w+)", text, re.MULTILINE
        )
        offered = {name for names in offered for name in names if name}
        assert len(offered) > 5
        found = [text for name, text in package.items() if "/support/" in name and pattern in name]
        assert found
        for text in found:
            named = set(re.findall(rf"^using {NAME}::(\w+);", text, re.MULTILINE))
            code = re.sub(r"//.*|\"[^\"]*\"|^using .*", "", text, flags=re.MULTILINE)
            used = set(re.findall(r"(?<![\w.>:])\w+(?=[(<{]| recorder_)", code))
            assert used & offered == (named & offered) - {
                "FakeGoal"
            }  # which tests of the logic make


def moved(text):
    """Return a text whichever place of the support it names, and in whichever order."""
    text = re.sub(rf"\b(support|{NAME}\.testing)\b", "SUPPORT", text)
    text = re.sub(r"\b(SUPPORT__RECORDER|SUPPORT|\w+__TESTING)__(\w+_HPP_)", r"\2", text)
    return sorted(text.splitlines())


@pytest.mark.parametrize("distro", DISTROS)
def test_one_language(renderers, distro):
    python, cpp = (shared(renderers, distro, language) for language in ("python", "cpp"))
    assert not [name for name in python if name.endswith(".hpp")]
    assert not [name for name in cpp if name.startswith(f"{NAME}/ros/")]
    for word in ("rclcpp", "roscpp", "gtest", "include"):
        assert word not in python["package.xml"] + python["CMakeLists.txt"]
    assert "pytest" not in cpp["package.xml"] + cpp["CMakeLists.txt"]
