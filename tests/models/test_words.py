"""What packages say of names: another spelling in code, but no comment that repeats one."""

import re

import pytest

from support.model_checks import Model
from support.repository import ROOT

SPEC = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="reach" frequency="10">
    <publisher name="power" type="std_msgs::Float64"/>
    <subscriber name="goal" type="std_msgs::Float64"/>
    <directPublisher name="tell" type="std_msgs::Float64"/>
    <serviceClient name="ask" type="std_srvs::Trigger"/>
    <actionClient name="move" type="test_msgs::Fibonacci"/>
    <listener name="frames"/>
    <broadcaster name="pose"/>
    <synchronizer name="sight">
      <input name="left" type="geometry_msgs::PointStamped"/>
      <input name="right" type="geometry_msgs::PointStamped"/>
    </synchronizer>
    <parameter name="lambda" type="double" value="1"/>
    <dynParameter name="gain" type="double" value="1"/>
  </node>
</package>
"""
NAMES = "power goal tell ask move frames pose left right".split()
"""Those of parameters stand in comments of `Config`: by these a rename finds an edited line."""


@pytest.fixture(params=["noetic", "kilted"])
def files(request, renderers, model):
    context = Model(ROOT / model).context(SPEC, request.param)
    return renderers[model].render(context, request.param)


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_readme_gives_the_spelling_of_the_logic(files):
    assert "| `lambda`, `config.lambda_` in the logic | double |" in files["README.md"]
    assert "| `gain` | double |" in files["README.md"]


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_no_comment_repeats_a_name(files):
    comment = rf"^ *(#|///?) ({'|'.join(NAMES)})$"
    found = {path: re.search(comment, text, re.MULTILINE) for path, text in files.items()}
    assert not {path: match[0] for path, match in found.items() if match}
