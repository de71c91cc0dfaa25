"""The names of a spec as names in code: for the hook, and filters for the templates."""

from __future__ import annotations

import re

from .words import CPP_NAMES, meaning


def identifier(name: str) -> str:
    """Return a ROS name as one word of an identifier: `~/arm/pose` gives `arm_pose`."""
    return re.sub("[/.]", "_", name.lstrip("~/"))


def member(name: str) -> str:
    """Return a name as a member of a class: `axis.x` gives `axis_x`, `lambda` gives `lambda_`.

    Decision 156: what code has already, in either language, gets an underscore.
    """
    word = identifier(name)
    if re.fullmatch(r"zq\d+x", word):  # a mark of `hooks.changes`: its name decides
        return f"{word[:-1]}y"
    return f"{word}_" if meaning(word, (*CPP_NAMES, "a word of types")) else word


def graph_id(name: str, owner: str) -> str:
    """Return one word for a name in the graph of all nodes; a private name is its owner's.

    Different names give different words, for no name has two underscores together.
    """
    return name.replace("~", owner).strip("/").replace("/", "__")


def ros_type(type_: str, ros: int) -> str:
    """Return a type as users of a ROS generation write it: in ROS 1 `std_msgs/String`.

    Decision 80: the context has one spelling for both.
    """
    return f"{type_package(type_)}/{type_name(type_)}" if ros == 1 else type_


def type_package(type_: str) -> str:
    """Return the package of a ROS type: `std_msgs/msg/String` gives `std_msgs`."""
    return type_.split("/")[0]


def type_name(type_: str) -> str:
    """Return the last part of a ROS type: `std_msgs/msg/String` gives `String`."""
    return type_.split("/")[-1]


def class_name(name: str) -> str:
    """Return the name of a class for a name: `contact_evaluate` gives `ContactEvaluate`."""
    return "".join(word[0].upper() + word[1:] for word in re.split(r"[_/~]+", name) if word)


def type_alias(name: str) -> str:
    """Return a ROS name as part of the name of a type: `~/arm/pose` gives `ArmPose`.

    Different names give different types: only `_` before a small letter is dropped.
    """
    word = identifier(name)
    if re.fullmatch(r"[a-z][a-z0-9]*(_[a-z][a-z0-9]*)*", word):
        return "".join(part.capitalize() for part in word.split("_"))
    return word + "_"
