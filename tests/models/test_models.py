"""What every model must be: sound over all that its dictionary allows, and kind to edits."""

import ast
import re
import xml.etree.ElementTree as ET

import copier
import copier._main
import pytest
import yaml

from support import model_checks

MODELS = model_checks.models()
EDIT = "# An edit of the developer"


@pytest.fixture(scope="session")
def source(tmp_path_factory):
    return model_checks.template(tmp_path_factory.mktemp("source") / "template")


@pytest.fixture(scope="session")
def rendered():
    """What has been rendered: of the same spec, several tests look at the package."""
    return {}


@pytest.fixture(scope="session")
def quick(request):
    """The renderers of the collection, in its own tests; a model of one's own has Copier alone."""
    try:
        return request.getfixturevalue("renderers")
    except pytest.FixtureLookupError:
        return {}


@pytest.fixture
def render(quick, source, model, rendered):
    """Render a package of some elements for a ROS, and see that its files can be parsed."""

    def run(elements, distro):
        key = (model.name, model.spec(elements), distro)
        if key not in rendered:
            if model.name in quick:
                context = model.context(key[1], distro)
                assert context, f"{distro}: {key[1]}"
                rendered[key] = quick[model.name].render(context, distro)
            else:
                rendered[key] = model_checks.render(model, key[1], distro, source)
            check_syntax(rendered[key])
        return rendered[key]

    return run


def check_syntax(files):
    """Parse what has a parser in Python's library."""
    for path, text in files.items():
        try:
            if path.endswith(".py"):
                ast.parse(text)
            elif path.endswith((".xml", ".launch", ".test")):
                ET.fromstring(text)
            elif path.endswith((".yaml", ".yml")):
                yaml.safe_load(text)
        except (SyntaxError, ET.ParseError, yaml.YAMLError) as error:
            raise AssertionError(f"{path}: {error}\n{text}") from error


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_model_asks_what_every_model_asks(model):
    """Without, Copier has no extensions, and can say no more than that a name is undefined."""
    text = (model.folder / "copier.yml").read_text()
    included = re.search("^!include (hooks|upstream)/copier.yml$", text, re.MULTILINE)
    assert included, "copier.yml: no `!include hooks/copier.yml`"


@pytest.mark.parametrize(
    ("model", "distro"), [(model, distro) for model in MODELS for distro in model.distros], ids=str
)
def test_all_of_the_dictionary_renders(render, model, distro):
    render(model.everything(distro), distro)


@pytest.mark.parametrize(
    ("model", "distro"), [(model, distro) for model in MODELS for distro in model.distros], ids=str
)
def test_what_starts_the_launch_file_is_declared(render, model, distro):
    files = render(model.everything(distro), distro)
    elements = ET.fromstring(files["package.xml"]).iter()
    declared = {item.text for item in elements if item.tag in ("depend", "exec_depend")}
    launcher = {"roslaunch"} if distro == "noetic" else {"launch_ros", "launch_xml"}
    has_launch_file = any(path.startswith("launch/") for path in files)
    assert launcher <= declared or not has_launch_file


@pytest.mark.parametrize(
    ("model", "owner"), [(model, owner) for model in MODELS for owner in model.owners], ids=str
)
def test_each_kind_renders_alone(render, model, owner):
    element = owner, model.base(owner)
    for distro in model.fitting(element):
        render([element], distro)


@pytest.mark.parametrize(
    ("model", "distro"), [(model, distro) for model in MODELS for distro in model.distros], ids=str
)
def test_texts_are_escaped(render, model, distro):
    """A text of the spec is never code, whatever signs are in it."""
    render(model.hostile(), distro)


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_files_of_two_components(source, model, tmp_path):
    """Each template makes files, and no file is made twice."""
    made = set()
    for distro in {model.distros[0], model.distros[-1]}:
        package = tmp_path / distro
        files = model_checks.make(source, package, model, model.several(distro), distro)
        made |= {template for templates in files.values() for template in templates}
    folder = next(
        folder for folder in (model.folder / "template", model.folder) if folder.is_dir()
    )
    templates = {str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}
    unused = sorted(templates - made)
    assert not unused, f"{', '.join(unused)}: of no use to any package"


@pytest.mark.parametrize(
    ("model", "owner"), [(model, owner) for model in MODELS for owner in model.owners], ids=str
)
def test_every_attribute_is_used(render, model, owner):
    """Another value of an attribute changes a file besides the spec and Copier's answers."""
    used, tried = set(), set()
    for name, base, values in model.variants(owner):
        tried.add(name)
        for distro in () if name in used else reversed(model.fitting((owner, base))):
            if render([(owner, base)], distro) != render([(owner, values)], distro):
                used.add(name)
                break
    known = {
        name
        for name, attribute in owner.attributes.items()
        if not attribute.ignored
        and (name in tried or not (attribute.pattern or attribute.refers_to))
    }
    unused = ", ".join(sorted(known - used))
    assert not unused, f"dictionary.yaml: {owner}: no template makes use of {unused}"


@pytest.fixture(scope="session")
def is_valid(tmp_path_factory):
    """Return what tells whether a spec is valid by the schema of its model."""
    found = {}

    def run(model, spec):
        if model.name not in found:
            schema = tmp_path_factory.mktemp("schema") / f"{model.name}.xsd"
            schema.write_text(model.hook.schema(), encoding="utf-8")
            found[model.name] = model_checks.validators(schema)
        verdicts = {is_valid(spec) for is_valid in found[model.name]}
        if not verdicts:
            pytest.skip("needs xmlschema, or xmllint of libxml2")
        assert len(verdicts) == 1, f"xmlschema and xmllint do not agree:\n{spec}"
        return verdicts.pop()

    return run


@pytest.mark.parametrize(
    ("model", "owner"), [(model, owner) for model in MODELS for owner in model.owners], ids=str
)
def test_schema_refuses_what_the_dictionary_does_not_have(is_valid, model, owner):
    for spec in model.faulty(owner):
        assert model.context(spec) is None, spec
        assert not is_valid(model, spec), spec


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_schema_has_all_of_the_dictionary(is_valid, model):
    sources = {"folder": "arm", "user": "Ada", "email": "ada@example.org", "year": "2026"}
    specs = [
        model.hook.skeleton(sources).partition("?>")[2].strip(),
        model.spec(model.everything()),
    ]
    specs += [
        model.spec(model.everything(distro)) for distro in (model.distros[0], model.distros[-1])
    ]
    for spec in specs:
        assert is_valid(model, spec), spec


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_spec_names_the_schema_beside_it(source, model, tmp_path):
    """An editor finds it in a new package, without network."""
    package = tmp_path / "fresh"
    model_checks.make(source, package, model, None, model.distros[-1])
    (spec,) = package.glob("*.ros_package")
    named = re.search(r'^<\?xml-model href="(.*?)"', spec.read_text(), re.MULTILINE)
    assert named, f"{spec.name} names no schema: <?xml-model href=...?>"
    assert (package / named[1]).read_text() == model.hook.schema()


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_files_are_made_in_any_order(source, model, tmp_path, monkeypatch):
    """A file system lists those of the template as it likes, and Copier renders them so."""
    listed = copier._main.scantree
    packages = []
    for order in (False, True):
        monkeypatch.setattr(
            copier._main,
            "scantree",
            lambda *a, order=order: sorted(listed(*a), key=lambda e: e.path, reverse=order),
        )
        package = tmp_path / str(order) / "same"
        package.parent.mkdir()
        model_checks.make(source, package, model, None, model.distros[-1])
        packages.append(
            {
                path.relative_to(package): path.read_text()
                for path in package.rglob("*")
                if path.is_file() and path.name != ".copier-answers.yml"
            }
        )
    assert packages[0] == packages[1]


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_updates_keep_edits(source, model, tmp_path, monkeypatch):
    """A line of the developer's in each file is there after all came that a spec can have."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    versions = model_checks.template(tmp_path / "versions")
    model_checks.commit(versions, "1.0.0")
    package = tmp_path / "package"
    small, everything = model.spec(model.small()), model.spec(model.everything())
    model_checks.make(versions, package, model, small, model.distros[-1])
    edited = [
        path for path in package.rglob("*") if path.is_file() and path.suffix != ".ros_package"
    ]
    edited = [path for path in edited if path.name != ".copier-answers.yml"]
    for path in edited:
        path.write_text(f"{EDIT}\n{path.read_text()}")
    (spec,) = package.glob("*.ros_package")
    spec.write_text(everything)
    model_checks.commit(package)
    options = {"defaults": True, "unsafe": True, "quiet": True, "overwrite": True}
    copier.run_update(package, **options)
    for path in edited:
        text = path.read_text()
        assert "<<<<<<<" not in text, f"{path}:\n{text}"
        assert text.startswith(EDIT), path
