"""Read the tables that stand beside the hook."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml


def load_data(name: str) -> Any:
    """Return the content of a YAML file of this folder."""
    return yaml.safe_load((Path(__file__).parent / name).read_text(encoding="utf-8"))
