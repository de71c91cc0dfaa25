"""What packages of this model must be. This file is yours; test_models.py is the starter's."""

import ast

from support import model_checks

SPEC = """<package name="robot" author="Ada" author_email="ada@example.org" description="A robot"
         license="MIT">
  <node name="driver">
    <publisher name="speed" type="std_msgs::Float64"/>
    <subscriber name="goal" type="std_msgs::Float64"/>
    <timer name="drive" period="0.1"/>
  </node>
</package>
"""


def test_one_python_file_for_each_node():
    (model,) = model_checks.models()
    files = model_checks.render(model, SPEC, "jazzy")
    tree = ast.parse(files["robot/driver.py"])
    (driver,) = [item for item in tree.body if isinstance(item, ast.ClassDef)]
    methods = [item.name for item in driver.body if isinstance(item, ast.FunctionDef)]
    assert methods == ["__init__", "receive_goal", "run_drive"]
