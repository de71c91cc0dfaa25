"""The faults that `make mutate` puts into the hooks."""

import ast

from scripts import mutate

TEXT = """
import a

__all__ = ["f"]
E = 7
D = E
D += 8

def f(b: int = 1) -> bool:
    \"\"\"Say so.\"\"\"
    if b > 2 and not a.c("x", d=[1, 2]):
        raise ValueError
    zip(b, D, strict=True)
    return b in (1,)
"""


def test_faults(tmp_path, monkeypatch):
    """Each is another program that is still Python, and changes what stands in its place."""
    monkeypatch.setattr(mutate, "ROOT", tmp_path)
    file, copy = tmp_path / "a.py", tmp_path / "copy"
    file.write_text(TEXT)
    copy.mkdir()
    found = [mutant for mutant in mutate.mutants("a.py") if mutant.is_python]
    for mutant in found:
        mutant.apply(copy)
        faulty = (copy / "a.py").read_text()
        assert ast.dump(ast.parse(faulty)) != ast.dump(ast.parse(TEXT)), mutant
        mutant.remove(copy)
        assert (copy / "a.py").read_text() == TEXT
    said = {str(mutant).partition(": ")[2] for mutant in found}
    assert said >= {
        "b > 2 -> (b >= 2)",
        "raise ValueError -> pass",
        "return b in (1,) -> return None",
        "b in (1,) -> (b not in (1,))",
        "not a.c(\"x\", d=[1, 2]) -> (a.c('x', d=[1, 2]))",
        "[1, 2] -> ([1])",
        "\"x\" -> ('')",
        "1 -> (2)",
    }
    assert not any("Say so" in each or "int" in each.split() for each in said)
    asserted = {"True -> (False)", "zip(b, D, strict=True) -> (zip(b, D))", "\"f\" -> ('')"}
    assert not said & asserted
    lines = {mutant.old: (mutant.line, *mutant.lines) for mutant in found}
    assert (lines["7"], lines["8"], lines["2"]) == ((5, 6, 13), (7, 13), (11, 11))
