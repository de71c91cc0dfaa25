"""What code and its files call the types of ROS: for messages that name what is meant."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from .data import load_data
from .names import class_name

TYPES_OF_ROS: dict[str, dict[str, list[str]]] = {
    package: {folder: names.split() for folder, names in folders.items()}
    for package, folders in load_data("types.yaml").items()
}
"""The types that come with ROS: by package and folder, their names."""
PRIMITIVES = (
    *("bool", "byte", "char", "float32", "float64"),
    *(f"{sign}int{bits}" for bits in (8, 16, 32, 64) for sign in ("", "u")),
    *("string", "wstring", "time", "duration"),
)
"""The types of fields that ROS has built in; time and duration in ROS 1 alone."""
_PRIMITIVES_IN_CODE = {
    **{name: name for name in PRIMITIVES},
    **{f"{name}_t": name for name in PRIMITIVES if "int" in name},
    "boolean": "bool",
    "double": "float64",
    "float": "float32",
    "int": "int32",
    "long": "int64",
    "size_t": "uint64",
    "str": "string",
    "unsigned char": "uint8",
    "unsigned int": "uint32",
}
FOLDERS = {"msg": "a message", "srv": "a service", "action": "an action"}
_PARTS = {"Request", "Response", "Goal", "Result", "Feedback"}
_CLIENTS = ("std", "ros", "rclcpp", "rospy", "rclpy")
"""What has classes in code, and no types of ROS."""
_AROUND = {
    *_CLIENTS,
    *("const", "from", "h", "hpp", "import", "include"),
    *("Client", "Publisher", "Service", "Subscription"),
    *("msgs", "shared_ptr", "unique_ptr"),
}
_POINTER = r"(Const|Shared|Unique)*Ptr\b"
_LIST = r"\[|\b(array|list|sequence|vector)\b|_array\b"


def words(text: str) -> list[str]:
    """Return the words of a type without what code has around them: `std::vector<a::B>`."""
    text = re.sub(rf"{_POINTER}|\[(<=)?\d*\]$|\b(array|list|sequence|vector)\b", "", text)
    found = [word for word in re.findall(r"[A-Za-z]\w*", text) if word not in _AROUND]
    if len(found) > 2 and found[-1] in _PARTS:
        found.pop()
    return found


def is_of_code(text: str) -> bool:
    """Say whether a text is a type of a language, or of a client library."""
    return bool(re.match(rf"({'|'.join(_CLIENTS)})\W", text)) or (
        text in _PRIMITIVES_IN_CODE and text not in PRIMITIVES
    )


def primitive(text: str) -> str:
    """Return the primitive type of fields that a text of code means; nothing for others."""
    return _PRIMITIVES_IN_CODE.get(" ".join(words(text)).lower(), "")


def with_capital(name: str) -> str:
    """Return the name of a type that is written as a file or a primitive: `twist`, `uint8`."""
    is_small = name[0].islower()
    return class_name(primitive(name) or name).replace("Uint", "UInt") if is_small else name


def packages(name: str, folder: str) -> list[str]:
    """Return the packages of ROS that have a type."""
    return [package for package, of in TYPES_OF_ROS.items() if name in of.get(folder, ())]


def field(text: str) -> str:
    """Return the type of a field that a text of code means, or nothing."""
    found = [word for word in words(text) if word not in FOLDERS]
    if not (meant := primitive(" ".join(found))):
        if len(found) == 1:
            found = [*packages(found[0], "msg")[:1], *found]
        meant = "::".join(found) if len(found) == 2 else ""
    return f"{meant}[]" if meant and re.search(_LIST, text) else meant


def choice(text: str, choices: Mapping[str, Sequence[str]]) -> str:
    """Return the choice that a text of code holds, or nothing: `rclcpp::SensorDataQoS()`.

    `choices` has the other spellings of each. Of a list it is that for lists, where there is one.
    """
    snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", text).lower()
    spellings = {word: each for each, others in choices.items() for word in (each, *others)}
    found = [
        (match.end(), len(word), each)
        for word, each in spellings.items()
        for match in re.finditer(rf"(?<![a-z0-9]){re.escape(word)}(?![a-z0-9])", snake)
    ]
    each = max(found)[2] if found else primitive(text)
    listed = f"{each}[]" if re.search(_LIST, snake) else ""
    return next((one for one in (listed, each) if one in choices), "")
