"""Faults of templates and models are told with the file and the line, without a traceback."""

import runpy
import sys
import tempfile
from types import SimpleNamespace

import jinja2
import jinja2.environment
import pytest
from copier.errors import UserMessageError
from jinja2 import Environment, FileSystemLoader

from extensions.compiled import CompiledExtension
from extensions.paths import PathsExtension, all_of
from extensions.spec import SpecExtension, _is_render
from hooks import faults, model, templates
from support.repository import ROOT


@pytest.fixture
def root(tmp_path):
    (tmp_path / "hooks").symlink_to(ROOT / "hooks")
    (tmp_path / "extensions").symlink_to(ROOT / "extensions")
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/[a].md").write_text("One.\n")
    (tmp_path / "copier.yml").write_text("model:\n  default: '{{ nobody }}'\n")
    return tmp_path


def test_names_of_files_are_of_components_alone():
    """A list of the spec may hold texts: packages that it depends on."""
    node = {"tag": "node", "timers": [{"name": "poll"}]}
    spec = {"depends": ["apriltag_msgs"], "nodes": [node]}
    assert all_of(spec, "timer") == [{"name": "poll", "node": node}]


def test_of_several_files_the_first_is_named(root):
    for name in "abcdefgh":
        (root / f"parts/part_{name}.jinja").touch()
    assert templates.found("part_", root) == "parts/part_a.jinja"


@pytest.fixture
def environment(root):
    environment = Environment(
        loader=FileSystemLoader([root, ROOT]), undefined=jinja2.StrictUndefined
    )
    environment.bridge = SpecExtension(environment)
    return environment


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("One.\n{{ nobody }}\n", "a.md:2: 'nobody' is undefined"),
        ("{% if %}\n", "a.md:1: Expected an expression, got 'end of statement block'"),
        ("\n{% include 'b.md' %}", 'a.md:2: no such template "b.md"'),
        ("\n\n{{ 1 + [] }}", "a.md:3: TypeError: unsupported operand type(s) for +: 'int' and 'l"),
        ("{% include 'c.md' %}", "c.md:2: ZeroDivisionError: division by zero"),
        ("{{ 'x' | is_lacking('y') }}", None),
    ],
)
def test_fault_of_a_template(environment, root, text, said):
    (root / "a.md").write_text(text)
    (root / "c.md").write_text("\n{{ 1 / 0 }}")
    with pytest.raises(UserMessageError) as caught:
        environment.get_template("a.md").render()
    if said:
        assert str(caught.value).startswith(said)
        assert str(caught.value).endswith(" [template-fails]")
    else:
        assert str(caught.value).startswith('unknown feature "y"; allowed: ')
        assert str(caught.value).endswith(" (in a.md:1) [unknown-feature]")


def test_fault_that_the_model_tells_of_a_template(environment, root):
    """The file is named where the bridge, too, is one of the model, as it is for Copier."""
    runpy.run_path(str(root / "extensions/load.py"))["AllExtensions"](environment)
    (root / "a.md").write_text("\n{{ 'x' | is_lacking('y') }}")
    with pytest.raises(UserMessageError, match=r" \(in a\.md:2\) \[unknown-feature\]$"):
        environment.get_template("a.md").render()


def test_name_of_a_file_with_a_tag_that_the_model_has_not(environment):
    PathsExtension(environment)
    environment.bridge._use(model.Model(ROOT / "python_model", ROOT))
    template = environment.from_string("{{ {} | all_of('leg', known_tags) }}")
    with pytest.raises(jinja2.TemplateRuntimeError, match='^unknown tag "leg"; ') as caught:
        template.render()
    tags = str(caught.value).partition("allowed: ")[2].split(", ")
    assert tags[:4] == ["maintainer", "url", "node", "publisher"]
    assert len(tags) == len({*tags})


@pytest.mark.parametrize("file", ["hooks/copier.yml", "copier.yml"])
def test_functions_that_a_copier_yml_calls_are_there(environment, file):
    calls = environment.parse((ROOT / file).read_text()).find_all(jinja2.nodes.Call)
    called = {call.node.name for call in calls if isinstance(call.node, jinja2.nodes.Name)}
    assert called <= environment.globals.keys()


def test_template_that_is_no_utf_8(environment, root):
    """Of one that another includes, too, the message names its own file and line."""
    (root / "a.md").write_bytes("Größe.\n\nGröße".encode() + "ö".encode("latin-1"))
    (root / "b.md").write_text("{% include 'a.md' %}")
    for name in ("a.md", "b.md"):
        with pytest.raises(UserMessageError, match=r"^a\.md:3: not UTF-8 text; .* \[not-utf-8\]$"):
            environment.get_template(name).render()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{{ nobody }}", "copier.yml:2: 'nobody' is undefined"),
        ("[a].md{{ 1 / 0 }}", '"[a].md{{ 1 / 0 }}": ZeroDivisionError: division by zero'),
    ],
)
def test_fault_of_a_setting(environment, text, said):
    """Jinja knows no file; what it was is looked for."""
    CompiledExtension(environment)
    with pytest.raises(UserMessageError) as caught:
        environment.from_string(text).render()
    assert str(caught.value) == f"{said} [template-fails]"


def test_where_the_text_of_a_fault_stands(root):
    assert templates.found("[a].md", root) == "parts/[a].md"
    assert templates.found("nobody", root) == "copier.yml:2"
    assert templates.found("somebody", root) == ""


def raised(code, file):
    """Return what some code raises, as if it stood in a file."""
    try:
        exec(compile(code, str(file), "exec"), {})
    except Exception as error:
        return error
    raise AssertionError


def test_place_of_a_fault(root):
    """That of the innermost template; a fault of the code of the model needs its traceback."""
    assert templates.place(raised("\n1 / 0", root / "a.md"), root) == ("a.md:2", True)
    assert templates.place(raised("1 / 0", root / "a.py"), root) == ("", False)
    assert templates.place(raised("1 / 0", root / "a.py"), root, is_told=True) == ("", False)
    assert templates.place(raised("1 / 0", root.parent / "a.py"), root) == ("", False)
    assert templates.place(raised("1 / 0", '"{{ a }}"'), root) == ("{{ a }}", False)
    code = f"exec(compile('1 / 0', {str(root / 'b.md')!r}, 'exec'))"
    assert templates.place(raised(code, root / "a.md"), root) == ("b.md:1", True)
    code = f"exec(compile('1 / 0', {str(root / 'a.py')!r}, 'exec'))"
    assert templates.place(raised(code, root / "a.md"), root) == ("", False)
    assert templates.place(raised(code, root / "a.md"), root, is_told=True) == ("a.md:1", True)
    own = "import jinja2\nraise jinja2.TemplateError('no')"
    code = f"exec(compile({own!r}, {str(root / 'a.py')!r}, 'exec'))"
    assert templates.place(raised(code, root / "a.md"), root) == ("a.md:1", True)
    assert templates.place(ValueError("never raised"), root) == ("", False)


def test_newer_copier_is_refused(environment, monkeypatch):
    bridge = environment.bridge
    monkeypatch.delenv("UNTESTED_COPIER", raising=False)
    for version in ("9.19.0", "9.19.7.dev1", "8.99.0"):
        bridge._check_copier(version)
    for version in ("9.20.0", "10.0.0", "9.100.0a1"):
        with pytest.raises(faults.SpecError) as caught:
            bridge._check_copier(version)
        said = f"Copier {version} is newer than 9.19, the newest that this version of the model is"
        assert str(caught.value).startswith(
            f"{said} tested with; install that, as by pipx install"
        )
        assert '"copier==9.19.*"' in str(caught.value)
    monkeypatch.setenv("UNTESTED_COPIER", "1")
    bridge._check_copier("9.20.0")


def context(**conf):
    usual = {"dst_path": "arm", "answers_file": "a.yml", "data": {}}
    return {"_copier_conf": {**usual, **conf}, "_copier_answers": {"_src_path": "model"}}


def test_what_copier_tells_of_a_run(environment, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    bridge = environment.bridge
    monkeypatch.setattr("hooks.run.updating", [tmp_path / "other"])
    run = bridge._run(context())
    assert run.package.folder == tmp_path / "arm"
    assert (run.package.answers_file, run.source, run.template) == ("a.yml", "model", tmp_path)
    assert (run.pretend, run.overwrite, run.quiet, run.inline) == (False, False, False, True)
    assert (run.model, run.distro, run.is_inner) == ("", "", False)
    told = {
        "data": {"spec": {}},
        "conflict": "rej",
        "pretend": True,
        "overwrite": 1,
        "quiet": True,
    }
    run = bridge._run({**context(**told), "model": "m", "ros_distro": "kilted"})
    assert (run.pretend, run.overwrite, run.quiet, run.inline) == (True, True, True, False)
    assert (run.model, run.distro, run.is_inner) == ("m", "kilted", True)


def test_temporary_folder_of_an_update_stands_for_the_package(environment, tmp_path, monkeypatch):
    """Decision 139: but not where Copier knows the spec already, as in its renders."""
    bridge, place = environment.bridge, tmp_path / "copier._main.new_copy.x/arm"
    begun = []
    monkeypatch.setattr(bridge.steps, "begin", begun.append)
    monkeypatch.setattr("hooks.run.updating", [])
    assert _is_render(place)
    assert not _is_render(tmp_path / "main.new_copy.x")
    assert bridge._run(context(dst_path=str(place))).package.folder == place
    for folder in (tmp_path / "arm", place):
        run = SimpleNamespace(package=SimpleNamespace(folder=folder))
        assert bridge._begin(run) is False
    assert [run.package.folder for run in begun] == [tmp_path / "arm"]
    assert bridge._run(context(dst_path=str(place))).package.folder == tmp_path / "arm"
    inner = context(dst_path=str(place), data={"spec": {}})
    assert bridge._run(inner).package.folder == place


def test_terminal_that_may_be_asked(environment, monkeypatch):
    can_ask = environment.globals["can_ask"]
    for closed, terminal in ((False, True), (False, False), (True, True)):
        stdin = SimpleNamespace(closed=closed, isatty=lambda terminal=terminal: terminal)
        monkeypatch.setattr(sys, "stdin", stdin)
        assert can_ask() == (terminal and not closed)
    monkeypatch.setattr(sys, "stdin", None)
    assert can_ask() is False


def test_ros_distro_of_the_environment_is_the_default(environment, monkeypatch):
    default = environment.globals["default_ros_distro"]
    for given, wanted in (("kilted", "kilted"), ("fuerte", "lyrical"), (None, "lyrical")):
        monkeypatch.delenv("ROS_DISTRO", raising=False)
        if given:
            monkeypatch.setenv("ROS_DISTRO", given)
        assert default() == wanted


def test_fault_names_the_template_of_now(monkeypatch, tmp_path):
    """The compiled template may be that of a folder which is gone; expressions are kept, too."""
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    compiled, generate = [], jinja2.environment.generate

    def count(node, *more, **options):
        compiled.append(more[1] or more[2])
        return generate(node, *more, **options)

    monkeypatch.setattr(jinja2.environment, "generate", count)
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "faulty.jinja").write_text(
            "{% macro m() %}{{ 1 / 0 }}{% endmacro %}{{ m() }}"
        )
        environment = Environment(
            loader=FileSystemLoader(tmp_path / name), extensions=[CompiledExtension]
        )
        with pytest.raises(ZeroDivisionError) as fault:
            environment.get_template("faulty.jinja").render()
        assert str(fault.traceback[-1].path) == str(tmp_path / name / "faulty.jinja")
        for text in ("\n{{ 1 + a }}\n2", "\n{{ 1 + a }}\n2", "", " "):
            assert environment.from_string(text).render(a=1) == text.replace("{{ 1 + a }}", "2")
    assert compiled == ["faulty.jinja", '"{{ 1 + a }}"', '""', '""']
    (tmp_path / "two/copier.yml").write_text("a: 1\n")
    environment = Environment(
        loader=FileSystemLoader(tmp_path / "two"), extensions=[CompiledExtension]
    )
    environment.get_template("faulty.jinja")
    assert compiled[4:] == ["faulty.jinja"]  # of another version
