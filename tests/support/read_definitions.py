"""Read definitions of messages, services and actions by the parser of the ROS that runs this.

    read_definitions.py [FOLDER]

prints as JSON, by package and file, the parts of each definition: what counts and, in ROS 2, what
rosidl makes of the comments. Types of the package itself have no package. Without a folder of
packages it reads what is installed.
"""

import json
import os
import re
import sys
from pathlib import Path

KINDS = ("msg", "srv", "action")


def rosidl(package, file, others):
    from rosidl_adapter import parser

    text = file.read_text(encoding="utf-8")
    parse = {
        "msg": parser.parse_message_string,
        "srv": parser.parse_service_string,
        "action": parser.parse_action_string,
    }[file.suffix[1:]]
    found = parse(package, file.stem, text)
    names = {"srv": ("request", "response"), "action": ("goal", "result", "feedback")}
    parts = [getattr(found, name) for name in names.get(file.suffix[1:], ())] or [found]

    def member(item, value):
        about = item.annotations
        return {
            "type": re.sub(f"^{package}/", "", str(item.type)),
            "name": item.name,
            "value": value,
            "comment": about.get("comment", []),
            "unit": about.get("unit"),
        }

    return [
        {
            "comment": part.annotations.get("comment", []),
            "fields": [member(field, field.default_value) for field in part.fields],
            "constants": [member(constant, constant.value) for constant in part.constants],
        }
        for part in parts
    ]


def genmsg_parts(package, file, folders):
    from genmsg.gentools import compute_md5
    from genmsg.msg_loader import MsgContext, load_depends, load_msg_from_string

    search = {name: [str(folder / "msg")] for name, folder in folders.items()}
    parts, lines = [], []
    for line in [*file.read_text(encoding="utf-8").split("\n"), "---"]:
        if line.strip() != "---":
            lines.append(line)
            continue
        context = MsgContext.create_default()
        name = f"{package}/{file.stem}{len(parts) or ''}"
        spec = load_msg_from_string(context, "\n".join(lines), name)
        load_depends(context, spec, search)
        own = re.compile(f"^{package}/")
        fields = [{"type": own.sub("", t), "name": name} for t, name in spec.fields()]
        keys = ("type", "name", "val_text")
        constants = [{key: getattr(c, key) for key in keys} for c in spec.constants]
        md5 = compute_md5(context, spec)
        parts.append({"fields": fields, "constants": constants, "md5": md5})
        lines = []
    return parts


def installed():
    places = os.environ.get("AMENT_PREFIX_PATH", "/usr:/opt/ros/noetic").split(":")
    return [folder for place in places for folder in sorted(Path(place, "share").glob("*"))]


def main(given=None):
    known = installed()
    wanted = sorted(Path(given).iterdir()) if given else known
    folders = {folder.name: folder for folder in known + wanted}
    read = rosidl if os.environ["ROS_VERSION"] == "2" else genmsg_parts
    found = {}
    for folder in wanted:
        files = [file for kind in KINDS for file in sorted(folder.glob(f"{kind}/*.{kind}"))]
        if files:
            found[folder.name] = {
                f"{file.parent.name}/{file.name}": read(folder.name, file, folders)
                for file in files
            }
    print(json.dumps(found))


main(*sys.argv[1:])
