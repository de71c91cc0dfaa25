"""The spec of a package's folder."""

import pytest

from hooks.faults import SpecError
from hooks.package import Package
from hooks.trees import is_yaml

SPEC = "<package/>\n"


@pytest.fixture
def package(tmp_path):
    return Package(tmp_path, ".copier-answers.yml")


def test_new_package_has_no_spec(package):
    assert package.spec_file("") is None
    assert package.spec_file("other.xml").name == "other.xml"


def test_package_has_one_spec(package):
    for name in ("b", "a"):
        (package.folder / f"{name}.ros_package").write_text(SPEC)
        if name == "b":
            assert package.spec_file("") == package.folder / "b.ros_package"
    with pytest.raises(SpecError, match=r"one spec is allowed, found a\.ros_package, b\.ros_pack"):
        package.spec_file("")


def test_another_spec_is_given(package, tmp_path):
    (package.folder / "a.ros_package").write_text(SPEC)
    same, other = tmp_path / "same.xml", tmp_path / "other.xml"
    same.write_bytes(b"\xef\xbb\xbf<package/>\r\n")
    other.write_text("<package />\n")
    assert package.spec_file(str(same)) == same
    with pytest.raises(SpecError, match=r"a\.ros_package is the spec of this package; change"):
        package.spec_file(str(other))


def test_spec_at_an_address_is_not_read(package):
    with pytest.raises(SpecError, match=r"^https://a\.b/c\.xml: an address is not read; download"):
        package.spec_file("https://a.b/c.xml")


@pytest.mark.parametrize(
    ("name", "text", "is_one"),
    [
        *((f"a{suffix}", "[1]", True) for suffix in (".yaml", ".yml", ".json")),
        ("a.yaml", "\ufeff \n<a/>", False),
        ("a.txt", "a: 1", True),
        ("a.txt", "<a: 1", False),
        ("a.txt", "[1]", False),
        ("a.txt", "a: b: c", False),
    ],
)
def test_spec_that_is_yaml(tmp_path, name, text, is_one):
    """In a folder the suffix alone tells; a file of another one says so itself."""
    (tmp_path / name).write_text(text, encoding="utf-8")
    assert is_yaml(tmp_path / name) == is_one
    assert is_yaml(tmp_path) == (not name.endswith(".txt"))


def test_package_has_lost_its_spec(package):
    (package.folder / package.answers_file).write_text("a: 1\n")
    assert package.answers() == {"a": 1}
    with pytest.raises(SpecError, match="lost its spec .*; git does not have it either"):
        package.spec_file("")


def test_package_is_made_without_git_or_by_a_name_in_another_encoding(
    package, monkeypatch, tmp_path
):
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)  # this repository may have a name of its own
    (tmp_path / "config").write_bytes(b'[user]\n\tname = "Ren\xe9"\n')
    assert package.about()["user"] == "Ren\N{REPLACEMENT CHARACTER}"
    monkeypatch.setenv("PATH", str(tmp_path))
    assert package.about()["folder"]
