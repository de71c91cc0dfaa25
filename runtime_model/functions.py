"""The runtime as a package: its parts in each language, and what they need."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import yaml

_ROOT = next(
    folder for folder in Path(__file__).parents if (folder / "cpp_model/functions.py").exists()
)
_MODELS = {
    language: runpy.run_path(str(_ROOT / f"{language}_model/functions.py"))
    for language in ("python", "cpp")
}
_SHARED = next(folder for folder in Path(__file__).parents if (folder / "shared").exists())
_COMMON = runpy.run_path(str(_SHARED / "shared/functions.py"))
_KINDS = sorted(
    yaml.safe_load((_SHARED / "shared/dictionary.yaml").read_text("utf-8"))["node_interface"]
)
# A node that uses all of the runtime, as functions and templates of the other models ask for it.
_TYPES = ("bool", "int", "double", "string")
_PARAMETER = {"name": "", "type": "int", "value": 0, "min": 0, "max": 0, "choices": [0]}
_REQUIRED = {**_PARAMETER, "name": "a.b", "type": "int[]", "value": None}
_KEYWORD = {**_PARAMETER, "name": "lambda"}
_HEARD = {"topic_parameter": None, "for_each": None, "deadline": 1.0, "qos": "sensor_data"}
_SERVICE = {"reliability": "best_effort", "depth": 1}
_NODE = {
    "frequency": 1.0,
    "diagnostics": True,
    "client_library": True,
    "reconfigure": True,
    "parameters": [*({**_PARAMETER, "type": each} for each in _TYPES), _REQUIRED, _KEYWORD],
    "dynParameters": [_PARAMETER],
    "publishers": [{"topic_parameter": "topic", "lifespan": 1.0}],
    "subscribers": [_HEARD],
    "directPublishers": [{"topic_parameter": None, "for_each": "topics"}],
    "directSubscribers": [
        _HEARD | {"for_each": None, "topic_parameter": "topic"},
        _HEARD | {"for_each": "topics", "deadline": None},
    ],
    "synchronizers": [{"slop": None, "inputs": []}, {"slop": 1.0, "inputs": []}],
    "serviceClients": [_SERVICE],
    "serviceServers": [_SERVICE],
    "actionServers": [{"accept": True, "goal": "parallel", "max_goals": 2}],
}


def parts(spec: dict[str, Any], language: str, ros_distro: str) -> list[dict[str, Any]]:
    """Return the spec of a node with every interface, for a language of the runtime or "any"."""
    own = _MODELS if spec["language"] == "both" else [spec["language"]]
    languages = [each for each in own if language in (each, "any")]
    if not languages:
        return []
    depends = set(_COMMON["dependencies_from_component"]("node", _NODE, ros_distro))
    for functions in map(_MODELS.__getitem__, languages):
        depends.update(functions["dependencies_from_template"](ros_distro))
        for kind in _KINDS:
            depends.update(functions["dependencies_from_interface"](kind, _PARAMETER, ros_distro))
    unused = {"launch_ros", "launch_xml", "roslaunch", "rclcpp_components", *spec["depends"]}
    return [{**spec, "nodes": [_NODE], "kinds": _KINDS, "depends": sorted(depends - unused)}]
