"""The spec that a package starts with, letter by letter."""

import pytest

from hooks.model import Model
from hooks.skeleton import tag_lines

DICTIONARY = """\
package_attributes:
  - name: {doc: of the package, example: $folder}
  - author: {example: "$user <$other>"}
  - title: {optional: true}
skeleton: [out, home]
arm_attributes:
  - name: {doc: its name, unique: true, example: left}
  - side: {doc: where, choices: {left: [l], right: []}, default: left, example: right}
  - label: {same_as: name}
  - old: {ignored: true}
  - speed: {doc: how fast, format: double, default: 2.0}
  - moves: {format: bool, default: false}
  - note: {doc: what a reader is to know -- in as many words as it takes to say it, optional: true}
arm_interface:
  out: &out
    doc: what goes out
    attributes:
      - name: {unique: true, example: one}
      - via: {refers_to: in, optional: true}
  in: [name]
  pair:
    doc: two that belong together
    attributes: [name]
    interface:
      part: {least: 2, attributes: [{name: {unique: true, example: side}}]}
  home:
    attributes: [x]
    interface: {out: *out}
long_attributes:
  - name: {example: a very long example of a name that makes the tag longer than its line may be}
  - other: {example: another}
folder_attributes:
  - name: {doc: what is installed, example: urdf}
"""
SKELETON = """\
<?xml version="1.0" encoding="UTF-8"?>
<?xml-model href="ros_package.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<!-- This file describes the package: change it, commit, run copier update.
       name    of the package
       author
       title   optional -->
<package name="pkg" author='A "b" &lt;$other&gt;'>
  <!-- arm
         name   its name
         side   where; one of left, right; default left
         label  default name
         speed  how fast; default 2
         moves  default false
         note   what a reader is to know - - in as many words as it takes to say it; optional -->
  <arm name="left" side="right">
    <!-- out: what goes out
           name
           via   the name of a in; optional -->
    <out name="one"/>
    <!-- home
           x -->
    <home x="x">
      <out name="one"/>
    </home>

    <!-- The other interface kinds, to uncomment where needed. -->

    <!-- in
           name -->
    <!-- <in name="name"/> -->

    <!-- pair: two that belong together
           name -->
    <!-- <pair name="name">
      <part name="side"/>
      <part name="side_2"/>
    </pair> -->
  </arm>

  <!-- A package that no interface above names:
         kind  one of build, build_export, buildtool, buildtool_export, doc, exec, group, test;
               optional -->
  <!-- <depend>package_name</depend> -->

  <!-- long
         name
         other -->
  <!-- <long name="a very long example of a name that makes the tag longer than its line may be"
             other="another"/> -->

  <!-- folder
         name  what is installed -->
  <!-- <folder name="urdf"/> -->
</package>
"""


def test_skeleton(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY)
    model = Model(tmp_path, tmp_path)
    assert model.skeleton({"folder": "pkg", "user": 'A "b"'}) == SKELETON


@pytest.mark.parametrize(("letters", "lines"), [(86, 1), (87, 2)])
def test_tag_that_is_too_long_has_a_line_for_each_attribute(letters, lines):
    written = tag_lines("a", {"b": "c", "d": "x" * letters}, "", ">")
    assert len(written) == lines
    assert tag_lines("a" * 200, {}, "", ">") == [f"<{'a' * 200}>"]
