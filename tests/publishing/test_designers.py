"""The commands of docs/designers.md, run against local repositories."""

from support.documentation import blocks
from support.packages import answers
from support.repository import bare_repository, git

PAGE = "docs/designers.md"


def test_from_an_empty_folder_to_a_published_model(shell, tmp_path):
    bare_repository(tmp_path / "github/team/my_model.git")
    work = tmp_path / "work"
    work.mkdir()
    output = shell("\n".join(blocks(PAGE, "From an empty folder to a published model")), work)
    assert "node server: no template makes use of name, type\n" in output
    assert "as it should be" in output
    node = (work / "mypkg/mypkg/example_node.py").read_text()
    assert "import std_srvs.srv" in node
    assert '"""Go home: fill in the response and return it."""' in node
    assert answers(work / "mypkg")["_commit"] == "0.2.0"
    assert git(work / "mypkg", "status", "--short") == ""


def test_fleet_view(lagging, shell):
    (script,) = blocks(PAGE, "Which packages lag behind")
    output = shell(script, lagging.parent)
    (example,) = blocks(PAGE, "Which packages lag behind", "text")
    assert output == example.replace("0.1.0", "1.0.0").replace("0.2.0", "1.1.0")
