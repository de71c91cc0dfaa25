"""What the documentation tells a reader to type."""

import re

from support.repository import ROOT


def blocks(page, heading, language="sh"):
    """Return the code blocks of a section of a page, such as README.md."""
    section = (ROOT / page).read_text().split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return re.findall(rf"^```{language}\n(.*?)^```$", section, re.DOTALL | re.MULTILINE)
