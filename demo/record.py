"""Record what `make demo` prints as the picture of the README."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from rich.console import Console
from rich.terminal_theme import DIMMED_MONOKAI
from rich.text import Text

ROOT = Path(__file__).parents[1]
PICTURE = ROOT / "docs/demo.svg"
STYLES = {"# ": "bold cyan", "$ ": "bold", "+ ": "green", "+  ": "green"}


def main() -> None:
    """Run the demo and write the picture."""
    command = [sys.executable, ROOT / "demo/demo.py"]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    with open("/dev/null", "w") as nowhere:
        console = Console(record=True, width=112, file=nowhere)
        for line in printed.strip().splitlines():
            style = next((STYLES[start] for start in STYLES if line.startswith(start)), "")
            console.print(Text(line, style=style), soft_wrap=True)
    PICTURE.write_text(console.export_svg(title="make demo", theme=DIMMED_MONOKAI))


if __name__ == "__main__":
    main()
