"""Read YAML: that of others, and the tables that stand beside the hook."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # in C where PyYAML has it: 8 times as fast


def load_yaml(text: str | bytes) -> Any:
    """Return the content of a YAML text.

    Raises:
        yaml.YAMLError: it is not YAML.

    """
    return yaml.load(text, LOADER)


def load_data(name: str) -> Any:
    """Return the content of a YAML file of this folder."""
    return load_yaml(Path(__file__).with_name(name).read_text(encoding="utf-8"))
