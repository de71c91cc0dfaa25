"""What the developer wrote into launch and build files, carried into those of another ROS.

As it is written there, without a render: changes are as `diff -U0` shows them.
"""

import difflib

import pytest

from hooks.merge.builds import carry_build_files
from hooks.merge.languages import XML
from hooks.merge.launch import carry, carry_launch_files
from hooks.merge.package import Result
from hooks.merge.proof import prove
from hooks.merge.renaming import Renaming
from hooks.merge.tree import File, encode


def changes(old, new):
    """Return what `new` has more, or less, with the line above each."""
    lines = difflib.unified_diff(old.splitlines(), new.splitlines(), n=1, lineterm="")
    return "\n".join(line.rstrip() for line in lines if line[:2] not in ("--", "++", "@@")) + "\n"


def patched(text, change):
    """Apply such changes."""
    found, rest = [], text.splitlines()
    for line in change.splitlines():
        sign, content = line[:1], line[1:]
        if sign == "+":
            found.append(content)
            continue
        while True:
            known = rest.pop(0)
            if known == content:
                break
            found.append(known)
        found += [content] if sign != "-" else []
    return "\n".join([*found, *rest]) + "\n"


LAUNCH_2 = """\
<launch>
  <arg name="namespace" default="" description="Namespace"/>
  <arg name="level" default="info"/>

  <!-- The node -->
  <node pkg="arm" exec="reach" name="reach" namespace="$(var namespace)"
    output="screen" args="--log $(var level)">
    <param name="autostart" value="true"/>
  </node>

  <node pkg="arm" exec="watch" name="watch" output="screen">
    <param name="autostart" value="true"/>
  </node>
</launch>
"""
LAUNCH_1 = """\
<launch>
  <arg name="namespace" default="" doc="Namespace"/>
  <arg name="level" default="info"/>

  <include file="$(find arm)/launch/arm.launch" ns="$(arg namespace)">
    <arg name="level" value="$(arg level)"/>
  </include>
  <group if="$(eval arg('namespace') == '')">
    <node pkg="arm" type="reach" name="reach" output="screen">
      <param name="log_level" value="$(arg level)"/>
    </node>
    <node pkg="arm" type="watch" name="watch" output="screen">
      <param name="log_level" value="$(arg level)"/>
    </node>
  </group>
</launch>
"""
LAUNCH_2_TO_1 = """\
 <launch>
-  <arg name="namespace" default="" description="Namespace"/>
+  <arg name="namespace" default="left" description="Namespace"/>
   <arg name="level" default="info"/>
+  <arg name="bag" default="$(find-pkg-share arm)/bags" description="Where bags are"/>
+
+  <!-- Mine: a camera -->
+  <node pkg="camera" exec="driver" name="camera" namespace="$(var namespace)">
+    <remap from="image" to="$(var namespace)/image"/>
+  </node>

   <node pkg="arm" exec="reach" name="reach" namespace="$(var namespace)"
-    output="screen" args="--log $(var level)">
+    output="log" respawn="true" args="--log $(var level)">
     <param name="autostart" value="true"/>
+    <param name="speed" value="2.0"/>
+    <remap from="pose" to="arm/pose"/>
   </node>

-  <node pkg="arm" exec="watch" name="watch" output="screen">
-    <param name="autostart" value="true"/>
-  </node>
+  <include file="$(find-pkg-share camera)/launch/camera.launch.xml" if="$(var bag)">
+    <arg name="bag" value="$(var bag)"/>
+  </include>
+  <include file="$(find-pkg-share camera)/launch/camera.launch.py"/>
+  <odd/>
+  <group unless="$(var bag)">
+    <node pkg="arm" exec="watch" name="watch" output="screen">
+      <param name="autostart" value="true"/>
+      <env name="HOME" value="$(env HOME)"/>
+    </node>
+  </group>
 </launch>
"""
CARRIED_2_TO_1 = """\
 <launch>
-  <arg name="namespace" default="" doc="Namespace"/>
+  <arg name="namespace" default="left" doc="Namespace"/>
   <arg name="level" default="info"/>
+  <arg name="bag" default="$(find arm)/bags" doc="Where bags are"/>

   <group if="$(eval arg('namespace') == '')">
-    <node pkg="arm" type="reach" name="reach" output="screen">
+    <node pkg="arm" type="reach" name="reach" output="log" respawn="true">
       <param name="log_level" value="$(arg level)"/>
+      <param name="speed" value="2.0"/>
+      <remap from="pose" to="arm/pose"/>
     </node>
+    <include file="$(find camera)/launch/camera.launch" if="$(arg bag)">
+      <arg name="bag" value="$(arg bag)"/>
+    </include>
     <node pkg="arm" type="watch" name="watch" output="screen">
   </group>
+  <!-- Mine: a camera -->
+  <node pkg="camera" type="driver" name="camera" ns="$(arg namespace)">
+    <remap from="image" to="$(arg namespace)/image"/>
+  </node>
 </launch>
"""
# By number, what became of the developer's lines
LINES_2_TO_1 = [2, 4, 6, 7, 8, 9, 13, 15, 16, 19, 20, 21]
BACK_2_TO_1 = []
LAUNCH_1_TO_2 = """\
   <arg name="namespace" default="" doc="Namespace"/>
-  <arg name="level" default="info"/>
+  <arg name="level" default="debug"/>
+  <arg name="bag" default="$(find arm)/bags" doc="Where bags are"/>

     <arg name="level" value="$(arg level)"/>
+    <arg name="bag" value="$(arg bag)"/>
   </include>
   <group if="$(eval arg('namespace') == '')">
-    <node pkg="arm" type="reach" name="reach" output="screen">
+    <node pkg="arm" type="reach" name="reach" output="log" launch-prefix="gdb">
       <param name="log_level" value="$(arg level)"/>
+      <param name="speed" value="2.0"/>
     </node>
-    <node pkg="arm" type="watch" name="watch" output="screen">
-      <param name="log_level" value="$(arg level)"/>
-    </node>
+    <node pkg="bag" type="record" name="record" args="$(arg bag) $(optenv X)"/>
+    <node pkg="bag" type="play" name="play" ns="bags" args="$(arg bag)"/>
   </group>
+  <rosparam command="load" file="x.yaml"/>
 </launch>
"""
CARRIED_1_TO_2 = """\
   <arg name="namespace" default="" description="Namespace"/>
-  <arg name="level" default="info"/>
+  <arg name="level" default="debug"/>
+  <arg name="bag" default="$(find-pkg-share arm)/bags" description="Where bags are"/>

   <node pkg="arm" exec="reach" name="reach" namespace="$(var namespace)"
-    output="screen" args="--log $(var level)">
+    output="log" args="--log $(var level)" launch-prefix="gdb">
     <param name="autostart" value="true"/>
+    <param name="speed" value="2.0"/>
   </node>
+  <node pkg="bag" exec="play" name="play" namespace="bags" args="$(var bag)"/>

"""
# By number, what became of the developer's lines
LINES_1_TO_2 = [3, 4, 8, 11, 13, 16]
BACK_1_TO_2 = ["node watch"]
BESIDE = [
    (1, '<set_remap from="a" to="b"/>', '<remap from="a" to="b"/>'),
    (1, '<set_env name="A" value="b"/>', '<env name="A" value="b"/>'),
    (1, '<remap from="a" to="b"/>', ""),
    (1, '<set_parameter name="a" value="1"/>', ""),
    (2, '<remap from="a" to="b"/>', '<set_remap from="a" to="b"/>'),
    (2, '<env name="A" value="b"/>', '<set_env name="A" value="b"/>'),
    (2, '<param name="a" value="1"/>', ""),
    (
        2,
        '<group><remap from="a" to="b"></remap></group>',
        '<group><set_remap from="a" to="b"></set_remap></group>',
    ),
    (
        2,
        '<group><node name="a"><remap from="a" to="b"/></node></group>',
        '<group><node name="a"><remap from="a" to="b"/></node></group>',
    ),
    (2, '<group><param name="a" value="1"/></group>', ""),
]
"""To which ROS, what a developer has written beside nodes, and what it is there."""


@pytest.mark.parametrize(("ros", "own", "wanted"), BESIDE)
@pytest.mark.parametrize("is_inside", [True, False])
def test_what_stands_beside_nodes_has_a_name_of_its_own(ros, own, wanted, is_inside):
    """It is for the nodes behind it, and stays before them."""
    old, new = (LAUNCH_1, LAUNCH_2) if ros == 2 else (LAUNCH_2, LAUNCH_1)
    start = "  <group" if ros == 2 and not is_inside else "    <node" if ros == 2 else "  <!-- The"
    mine = old.replace(start, f"{start[: -len(start.lstrip())]}{own}\n{start}", 1)
    assert mine != old
    carried = carry(XML.blocks(mine), XML.blocks(old), new, ros)
    added = [line for line in carried.text.split("\n") if line not in new.split("\n")]
    assert [line.strip() for line in added] == [wanted] * bool(wanted)
    assert bool(carried.lines) == bool(wanted)
    if wanted and not own.startswith("<group"):
        assert carried.text.index(wanted) < carried.text.index("<node")


CMAKE_1 = """\
cmake_minimum_required(VERSION 3.10)
project(arm)

find_package(catkin REQUIRED COMPONENTS
  message_generation
  roscpp
  std_msgs
)

add_message_files(FILES
  Pose.msg
)
generate_messages(
  DEPENDENCIES
    std_msgs
)

catkin_package(
  CATKIN_DEPENDS
    std_msgs
)

add_executable(reach
  src/reach_impl.cpp
)
target_link_libraries(reach
  ${catkin_LIBRARIES}
)

install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_reach
    test/test_reach.cpp
  )
endif()
"""
CMAKE_2 = """\
cmake_minimum_required(VERSION 3.16)
project(arm)

find_package(ament_cmake REQUIRED)
find_package(std_msgs REQUIRED)

rosidl_generate_interfaces(${PROJECT_NAME}
  msg/Pose.msg
  DEPENDENCIES
    std_msgs
)

add_library(reach SHARED
  src/reach_impl.cpp
)
target_link_libraries(reach
  PUBLIC
    ${std_msgs_TARGETS}
)

target_link_libraries(${PROJECT_NAME}_interface
  PUBLIC
    ${std_msgs_TARGETS}
)

install(DIRECTORY config DESTINATION share/${PROJECT_NAME})

if(BUILD_TESTING)
  ament_add_gtest(test_reach
    test/test_reach.cpp
  )
endif()
ament_export_dependencies(
  std_msgs
)
ament_package()
"""
CMAKE_1_TO_2 = """\
   roscpp
+  tf2_ros
   std_msgs
   Pose.msg
+  Grip.msg
+)
+add_service_files(FILES
+  Hold.srv
 )
   DEPENDENCIES
+    geometry_msgs
     std_msgs
+    tf2_ros
 )
     std_msgs
+    tf2_ros
 )
   src/reach_impl.cpp
+  src/mine.cpp
 )
   ${catkin_LIBRARIES}
+  fmt
 )
+
+# Mine: a table
+find_package(Eigen3 REQUIRED)
+set(MINE 1)
+target_compile_options(reach PRIVATE -O3)
+target_compile_options(other PRIVATE -O3)
+install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+catkin_install_python(PROGRAMS scripts/more.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+roslaunch_add_file_check(launch)

"""
BUILT_1_TO_2 = """\
 find_package(std_msgs REQUIRED)
+find_package(tf2_ros REQUIRED)
+
+# Mine: a table
+find_package(Eigen3 REQUIRED)
+set(MINE 1)

 rosidl_generate_interfaces(${PROJECT_NAME}
+  srv/Hold.srv
   msg/Pose.msg
+  msg/Grip.msg
   DEPENDENCIES
+    tf2_ros
+    geometry_msgs
     std_msgs
   src/reach_impl.cpp
+  src/mine.cpp
 )
   PUBLIC
+    fmt
     ${std_msgs_TARGETS}
   PUBLIC
+    ${tf2_ros_TARGETS}
     ${std_msgs_TARGETS}
 install(DIRECTORY config DESTINATION share/${PROJECT_NAME})
+target_compile_options(reach PRIVATE -O3)
+install(PROGRAMS scripts/tool DESTINATION lib/${PROJECT_NAME})
+install(PROGRAMS scripts/more.py DESTINATION lib/${PROJECT_NAME})

 ament_export_dependencies(
+  tf2_ros
   std_msgs
"""
NUMBERS_1_TO_2 = [7, 13, 15, 16, 17, 20, 22, 28, 33, 37, 40, 41, 42, 43, 45, 46]
CMAKE_2_TO_1 = """\
 find_package(std_msgs REQUIRED)
+find_package(tf2_ros REQUIRED)
+find_package(Eigen3 REQUIRED)

   msg/Pose.msg
+  srv/Hold.srv
   DEPENDENCIES
+    geometry_msgs
     std_msgs
   src/reach_impl.cpp
+  src/mine.cpp
 )
     ${std_msgs_TARGETS}
+    ${tf2_ros_TARGETS}
+    fmt
 )
+
+# Mine: a table
+target_compile_options(reach PRIVATE -O3)
+set_target_properties(gone PROPERTIES PREFIX "")
+install(PROGRAMS scripts/tool DESTINATION lib/${PROJECT_NAME})
+install(FILES plugin.xml
+  DESTINATION share/${PROJECT_NAME})
+ament_export_include_directories(include)

 ament_export_dependencies(
+  tf2_ros
   std_msgs
"""
BUILT_2_TO_1 = """\
 find_package(catkin REQUIRED COMPONENTS
+  tf2_ros
   message_generation
 )
+find_package(Eigen3 REQUIRED)

 )
+
+add_service_files(
+  FILES
+    Hold.srv
+)
 generate_messages(
   DEPENDENCIES
+    geometry_msgs
     std_msgs
   CATKIN_DEPENDS
+    tf2_ros
     std_msgs
   src/reach_impl.cpp
+  src/mine.cpp
 )
   ${catkin_LIBRARIES}
+  fmt
 )
 install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+
+# Mine: a table
+target_compile_options(reach PRIVATE -O3)
+install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+install(FILES plugin.xml
+  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

"""
NUMBERS_2_TO_1 = [6, 7, 11, 13, 19, 24, 25, 28, 29, 31, 32, 33, 49]
SETUP = """\
from glob import glob
from setuptools import setup

package_name = 'arm'


def installed(folder):
    return folder


setup(
    name=package_name,
    classifiers=[
    ],
    data_files=[
        ('share/' + package_name, ['package.xml']),
        *installed('config'),
    ],
)
"""
PYTHON_CMAKE = """\
cmake_minimum_required(VERSION 3.10)
project(arm)

find_package(catkin REQUIRED
  COMPONENTS
)

catkin_python_setup()
catkin_package()

install(DIRECTORY
    config
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
)
"""
PYTHON_1_TO_2 = """\
   COMPONENTS
+  tf2_ros
 )
     config
+    urdf
+    ${folders}
+    PATTERN
+    "*.in" EXCLUDE
   DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
 )
+install(FILES plugin.xml a.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+install(FILES ${files} DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+install(FILES elsewhere DESTINATION etc)
+install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+install(DIRECTORY tools DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+install(DIRECTORY meshes/ DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+install(DIRECTORY two folders DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+add_library(x x.cpp)
"""
SET_UP_1_TO_2 = """\
         *installed('config'),
+        *installed('urdf'),
+        ('share/' + package_name, ['plugin.xml', 'a.xml']),
+        ('lib/' + package_name, ['scripts/tool']),
+        *installed('meshes'),
     ],
"""
PYTHON_2_TO_1 = """\
         *installed('config'),
+        *installed('urdf'),
+        ('lib/' + package_name, ['scripts/tool']),
+        ('share/' + package_name + '/meshes', glob('meshes/*')),
+        ('share/' + package_name + '/one', ['one/file']),
+        ('lib/' + package_name + '/tools', glob('tools/*')),
+        ('share/' + package_name, ['plugin.xml', 'a.xml']),
+        mine(),
     ],
"""
SET_UP_2_TO_1 = """\
     config
+    urdf
+    meshes
   DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
 )
+
+install(FILES plugin.xml a.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+
+install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""
EACH_WAY = {
    1: (LAUNCH_2, LAUNCH_2_TO_1, LAUNCH_1, CARRIED_2_TO_1, LINES_2_TO_1, BACK_2_TO_1),
    2: (LAUNCH_1, LAUNCH_1_TO_2, LAUNCH_2, CARRIED_1_TO_2, LINES_1_TO_2, BACK_1_TO_2),
}
BUILDS = {
    1: (CMAKE_2, CMAKE_2_TO_1, CMAKE_1, BUILT_2_TO_1, NUMBERS_2_TO_1),
    2: (CMAKE_1, CMAKE_1_TO_2, CMAKE_2, BUILT_1_TO_2, NUMBERS_1_TO_2),
}


@pytest.mark.parametrize("ros", EACH_WAY)
def test_launch_files(ros):
    old, change, new, expected, lines, back = EACH_WAY[ros]
    mine = patched(old, change)
    carried = carry(XML.blocks(mine), XML.blocks(old), new, ros)
    assert changes(new, carried.text) == expected
    assert sorted(carried.lines) == lines
    assert carried.back == back


ARG = '  <arg name="a"/>\n'
NODE = '  <node pkg="p" name="a" output="log"/>\n'
OTHER = NODE.replace('"a"', '"b"')
OWN = '  <node name="own"/>\n'
WITHIN = '  <node name="a">\n    <param name="p"/>\n  </node>\n'
COMPOSABLE = WITHIN.replace("node", "composable_node").replace('a">', 'a" namespace="">')
EMPTY = "  <group/>\n"
TURN = '    <remap from="b" to="c"/>\n'
TURNED = COMPOSABLE.replace("  </", f"{TURN}  </")
WITHIN_TURNED = WITHIN.replace("  </", f"{TURN}  </")
WHERE = '  <node name="a" if="1"/>\n'
DEFAULT = ARG.replace("/>", ' default="1"/>')
GROUP = f'  <group if="x">\n  {NODE}  </group>\n'
GROUP_WITH_OWN = GROUP.replace("  </", f"  {OWN}  </")
IN_LINE = '  <node name="a"><param name="p"/></node>\n'
REQUIRED = '  <node name="own" required="1"/>\n'
SAID = "<!-- <b> -->"
INCLUDE = """  <include file="$(find a)/a.launch">
    <arg name="x" value="y"/>
  </include>
"""
PASSES = INCLUDE.replace("  </", '    <arg name="a" value="$(arg a)"/>\n  </')
AGAIN = '  <include file="$(find a)/a.launch" if="1"/>\n'
ALSO = '  <include file="$(find-pkg-share a)/a.launch.xml" if="1"/>\n'
PASSED = '<arg name="a" value="$(var a)"/>'


@pytest.mark.parametrize(
    ("ros", "old", "mine", "new", "wanted", "lines", "back"),
    [
        # Where an element belongs: arguments above all, others below what they stood below
        (2, "", ARG, OTHER, f"{ARG}{OTHER}", {2: ARG}, []),
        (2, NODE, f"  <x/>\n{NODE}{OWN}", f"{NODE}{OTHER}", f"{NODE}{OWN}{OTHER}", {4: OWN}, []),
        (2, NODE, f"{OWN}{NODE}", f"{NODE}{OTHER}", f"{NODE}{OTHER}{OWN}", {2: OWN}, []),
        # In a group or an include that is not there, around what is generated, with its own
        (2, GROUP, GROUP.replace("  <node", f"{OWN}  <node"), NODE, f"{NODE}{OWN}", {3: OWN}, []),
        (1, GROUP, GROUP_WITH_OWN, GROUP, GROUP_WITH_OWN, {4: OWN}, []),
        (2, NODE, f"  <group>\n{NODE}{OWN}  </group>\n", NODE, f"{NODE}{OWN}", {4: OWN}, []),
        (
            2,
            "",
            f"  <group>\n{OWN}  </group>\n",
            NODE,
            f"{NODE}  <group>\n{OWN}  </group>\n",
            {2: "<group>", 3: OWN, 4: "</group>"},
            [],
        ),
        (2, INCLUDE, INCLUDE.replace("    <", OWN + "    <"), NODE, NODE, {}, []),
        (
            2,
            INCLUDE,
            INCLUDE.replace("  </", '    <arg name="z"/>\n  </'),
            INCLUDE,
            INCLUDE.replace("  </", '    <arg name="z"/>\n  </'),
            {4: '<arg name="z"/>'},
            [],
        ),
        # In a node that has another tag there, which takes less
        (
            2,
            WITHIN,
            WITHIN.replace('a">', 'a" output="log" ns="x">').replace(
                "  </", '    <remap from="b" to="c"/>\n    <env name="d" value="e"/>\n  </'
            ),
            COMPOSABLE,
            COMPOSABLE.replace('""', '"x"').replace("  </", '    <remap from="b" to="c"/>\n  </'),
            {2: 'output="log" namespace="x"', 4: '<remap from="b" to="c"/>'},
            [],
        ),
        (1, COMPOSABLE, TURNED, WITHIN, WITHIN_TURNED, {4: TURN}, []),
        # What has the name and is another thing
        (
            2,
            WHERE,
            WHERE.replace("1", "2"),
            f"{WHERE.replace('node', 'arg')}{WHERE}",
            f"{WHERE.replace('node', 'arg')}{WHERE.replace('1', '2')}",
            {2: 'if="2"'},
            [],
        ),
        (
            2,
            ARG,
            DEFAULT,
            f"{ARG}{PASSES}",
            f"{DEFAULT}{PASSES}",
            {2: 'default="1"'},
            [],
        ),
        # What is there already, or only seems to be
        (2, INCLUDE, f"{AGAIN}{INCLUDE}", INCLUDE, f"{INCLUDE}{ALSO}", {2: ALSO}, []),
        (2, OTHER, f"{OTHER}{NODE}", f"{NODE}{OTHER}", f"{NODE}{OTHER}", {3: NODE}, []),
        # Of what is in the line of another element, and in one without an inside: nothing
        (
            2,
            IN_LINE,
            IN_LINE.replace('"a">', '"a" output="x">').replace("</", '<param name="q"/></'),
            IN_LINE,
            IN_LINE.replace('"a">', '"a" output="x">'),
            {2: 'output="x"'},
            [],
        ),
        (2, WITHIN, WITHIN.replace("  </", f"  {OWN}  </"), NODE, NODE, {}, []),
        # Arguments for an include that it gets already
        (2, INCLUDE, PASSES, INCLUDE, PASSES.replace("$(arg", "$(var"), {4: PASSED}, []),
        (2, INCLUDE, PASSES, f"{ARG}{INCLUDE}", f"{ARG}{INCLUDE}", {4: PASSED}, []),
        # Attributes, in any quotes; not where the developer took some away
        (
            1,
            NODE,
            """\
  <!-- output='x' -->
  <node pkg='q'
    name="a" output='z' respawn = "$(var b)" />
""",
            NODE,
            """  <node pkg='q' name="a" output='z' respawn="$(arg b)"/>\n""",
            {3: "pkg='q'", 4: "output='z' respawn=\"$(arg b)\""},
            [],
        ),
        (1, NODE, '  <node pkg="q" name="a"/>\n', NODE, NODE, {}, []),
        (2, NODE, NODE.replace("output", 'required="1" output'), NODE, NODE, {}, []),
        (2, NODE, f"{NODE}{REQUIRED}", NODE, NODE, {}, []),
        (
            2,
            NODE,
            NODE.replace("log", "x"),
            NODE.replace('output="log"', 'args="a > b"'),
            NODE.replace('output="log"', 'args="a > b" output="x"'),
            {2: 'output="x"'},
            [],
        ),
        (
            2,
            NODE,
            NODE.replace("log", "x"),
            f"  <!-- output='y' -->\n{NODE}",
            f"  <!-- output='y' -->\n{NODE.replace('log', 'x')}",
            {2: 'output="x"'},
            [],
        ),
        # Comments, whatever is in them, but for those of generated elements
        (2, "", f"  {SAID}\n{OWN}", NODE, f"{NODE}  {SAID}\n{OWN}", {2: SAID, 3: OWN}, []),
        (
            2,
            f"  <!-- One -->\n{NODE}",
            f"  <!-- One -->\n{OWN}{NODE}",
            OTHER,
            f"{OTHER}{OWN}",
            {3: OWN},
            [],
        ),
        # What the developer deleted, by its name, as far as it is there
        (2, OTHER + NODE, "", NODE + OTHER, NODE + OTHER, {}, ["node a", "node b"]),
        (2, f"{NODE}{OTHER}{EMPTY}", "", f"{NODE}{EMPTY}", f"{NODE}{EMPTY}", {}, ["node a"]),
    ],
)
def test_element_of_launch_files(ros, old, mine, new, wanted, lines, back):
    old, mine, new, wanted = (f"<launch>\n{text}</launch>\n" for text in (old, mine, new, wanted))
    carried = carry(XML.blocks(mine), XML.blocks(old), new, ros)
    assert carried.text == wanted
    assert {number: " ".join(words) for number, words in carried.lines.items()} == {
        number: line.strip() for number, line in lines.items()
    }
    assert carried.back == back


def built(mine, old, new, ros):
    """Carry build files; return what became of them."""
    mine, old, new = (
        {path: File(encode(text)) for path, text in files.items()} for files in (mine, old, new)
    )
    result = Result()
    carry_build_files(mine, old, new, Renaming(), result, ros)
    return result


@pytest.mark.parametrize("ros", BUILDS)
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_cmake(ros, end):
    old, change, new, expected, numbers = BUILDS[ros]
    path = "CMakeLists.txt"
    mine = patched(old, change).replace("\n", end)
    result = built({path: mine}, {path: old.replace("\n", end)}, {path: new}, ros)
    text = result.tree[path].text
    assert changes(new, text.replace("\r\n", "\n")) == expected
    assert text.count("\r\n") == (text.count("\n") if end == "\r\n" else 0)
    assert sorted(result.carried[path][1]) == numbers


PACKAGES = {1: "find_package(catkin COMPONENTS\n  tf2_ros\n)\n", 2: "find_package(ament_cmake)\n"}
PROPERTIES = "set_target_properties(a\n  PROPERTIES\n  PREFIX x\n)\n"
GAPS = "\n" + PROPERTIES.replace("a\n", "a\n\n")
NESTED = "if(UNIX)\n  set(x\n    1\n  )\nendif()\n"
SET = "set(y)\n"
OWN_IF = f"if(Z)\n  {SET}endif()\n"
NO_LINK = "target_link_libraries(a\n)\n"
LINK = NO_LINK.replace("\n)", " fmt)")
MESSAGES = {
    1: "add_message_files(FILES\n  A.msg\n)\n",
    2: "rosidl_generate_interfaces(${PROJECT_NAME}\n  msg/A.msg\n)\n",
}
USERS = "catkin_package(\n  CATKIN_DEPENDS\n    tf2\n)\n"
EXPORT = "ament_export_dependencies(\n"
FOUND = "find_package(own_msgs REQUIRED)"
HELPER = "function(Say x)\nmessage(STATUS x)\nendfunction()\nsay(1)\nif(X)\nSAY(2)\nendif()\n"
VARIABLES = """\
pkg_check_modules(USB libusb-1.0)
include_directories(${USB_INCLUDE_DIRS})
file(GLOB SOURCES src/*.cpp)
if(X)
  list(APPEND SOURCES x.cpp)
else()
  message(STATUS "without x")
endif()
"""


@pytest.mark.parametrize(
    ("ros", "old", "mine", "new", "wanted", "lines"),
    [
        # Of a library what catkin has not linked already
        (
            1,
            "target_link_libraries(a\n)\n",
            "target_link_libraries(a\n  PRIVATE\n  tf2_ros::tf2_ros\n  fmt::fmt\n  rclcpp\n)\n",
            "target_link_libraries(a\n)\n",
            "target_link_libraries(a\n  fmt::fmt\n)\n",
            {3: "", 4: "tf2_ros", 5: "fmt::fmt"},
        ),
        (2, NO_LINK, ("a\n", "a\n  GL\n"), NO_LINK, "mine", {5: "GL"}),
        (2, NO_LINK, ("a\n", "a\n  fmt::fmt\n"), NO_LINK, "mine", {5: "fmt::fmt"}),
        # An item of a command that both have: where the same stands in it, or above it
        (2, PROPERTIES, ("x", "y"), PROPERTIES, "mine", {6: "PREFIX y"}),
        (2, PROPERTIES, ("x", "y"), "", "", {}),
        (2, PROPERTIES, ("x", "y"), PROPERTIES.replace("x", "z"), "new", {}),
        (2, PROPERTIES, ("  PREFIX", "  Y y\n  PREFIX"), PROPERTIES, "mine", {6: "Y y"}),
        (2, PROPERTIES, ("(a\n", "(a\n  Y y\n"), PROPERTIES.replace("(a\n", "(a"), "new", {}),
        (2, PROPERTIES, ("(a\n", "(a\n  Y y\n"), PROPERTIES.replace("(a", "(b"), "new", {}),
        (2, PROPERTIES, ("x\n", "x\n  ${CATKIN_X} y\n"), PROPERTIES, "new", {}),
        (2, PROPERTIES, ("x\n", "x\n\n"), PROPERTIES, "new", {}),
        (2, GAPS, ("a\n\n", "a\n  Y y\n"), GAPS, "new", {}),
        (2, NESTED, ("1\n", "1\n    2\n"), NESTED, "mine", {7: "2"}),
        (2, NESTED, ("  set", "  find_package(x)\n  set"), NESTED, "new", {}),
        (2, NO_LINK + NESTED, ("  set", f"  {LINK}  set"), NO_LINK + NESTED, "new", {}),
        # In a condition that the developer has changed, and in one of their own
        (
            2,
            NESTED,
            NESTED.replace("UNIX", "UNIX AND Y").replace("1\n", "1\n    2\n"),
            NESTED,
            NESTED.replace("1\n", "1\n    2\n"),
            {7: "2"},
        ),
        (
            2,
            NESTED,
            NESTED + OWN_IF,
            NESTED,
            OWN_IF + NESTED,
            {9: "if(Z)", 10: "set(y)", 11: "endif()"},
        ),
        # Commands above what ends a file
        (2, "", "# Of x\nset(x 1)", "", "# Of x\nset(x 1)\n", {4: "# Of x", 5: "set(x 1)"}),
        (2, "", "run(x)", "ament_package()\n", "run(x)\nament_package()\n", {4: "run(x)"}),
        (2, "", f"run(x)\n{SET}", "", f"{SET}run(x)\n", {4: "run(x)", 5: SET.strip()}),
        # A function with its calls, or neither
        (2, "", HELPER, "", "mine", dict(enumerate(HELPER.splitlines(), 4))),
        (2, "", HELPER.replace("STATUS", "${catkin_DIR}"), "", "", {}),
        # Messages, where some are generated
        (
            1,
            MESSAGES[2],
            (")", "  DEPENDENCIES\n    b_msgs\n)"),
            "generate_messages(\n)\n",
            "generate_messages(\n  DEPENDENCIES\n    b_msgs\n)\n",
            {4: "", 5: "b_msgs"},
        ),
        (
            1,
            MESSAGES[2],
            ("A.msg\n", "A.msg\n  msg/B.msg\n"),
            "add_message_files(\n  FILES\n)\n",
            "add_message_files(\n  FILES\n  B.msg\n)\n",
            {4: "B.msg"},
        ),
        (
            1,
            MESSAGES[2],
            ("A.msg\n", "A.msg\n  # Mine\n  msg/B.msg  # Too\n"),
            "add_message_files(\n  FILES\n  A.msg\n)\n",
            "add_message_files(\n  FILES\n  A.msg\n  B.msg  # Too\n)\n",
            {5: "B.msg  # Too"},
        ),
        (
            1,
            MESSAGES[2],
            ("A.msg\n", "A.msg\n  msg/B.msg\n"),
            "add_message_files(\n  FILES\n    A.msg\n    A.srv\n)\n",
            "add_message_files(\n  FILES\n    A.msg\n    B.msg\n    A.srv\n)\n",
            {4: "B.msg"},
        ),
        (  # whose name only looks like ROS 1
            2,
            MESSAGES[1],
            ("A.msg\n", "A.msg\n  RosTest.msg\n"),
            MESSAGES[2],
            MESSAGES[2].replace("A.msg\n", "A.msg\n  msg/RosTest.msg\n"),
            {6: "msg/RosTest.msg"},
        ),
        (1, "", "find_package(tf2_ros)\n", "", "", {2: "tf2_ros"}),  # catkin has it
        (1, "", MESSAGES[2], "", "", {}),
        (2, "", MESSAGES[1], "", "", {}),
        (
            2,
            "add_executable(a a.cpp)\n",
            "if(X)\n  add_executable(a a.cpp)\nendif()\n",
            "if(X)\n  add_library(b b.cpp)\nendif()\n",
            "new",
            {},
        ),
        # What users of the package need
        (
            2,
            "",
            USERS,
            "ament_export_dependencies(\n  x\n)\n",
            "ament_export_dependencies(\n  tf2\n  x\n)\n",
            {4: "", 5: "", 6: "tf2", 7: ""},
        ),
        (
            2,
            USERS,
            ("tf2\n", "tf2\n    y\n    ${x}\n"),
            "ament_export_dependencies(\n  y\n)\n",
            "ament_export_dependencies(\n  y\n)\n",
            {7: "y"},
        ),
        (
            2,
            USERS,
            ("tf2\n", "tf2\n    y  # Too\n    Y\n"),
            "ament_export_dependencies(\n  y\n)\n",
            "ament_export_dependencies(\n  y\n)\n",
            {7: "y  # Too"},
        ),
        (2, USERS, ("tf2\n", "tf2\n    y\n"), f"\n{EXPORT})\n", f"\n{EXPORT}  y\n)\n", {7: "y"}),
        (2, USERS, ("tf2\n", "tf2\n    rospy\n    Eigen3\n"), f"{EXPORT})\n", "new", {}),
        (2, "", USERS, "", "", {}),
        (2, "", f"{FOUND}\n", "", f"{FOUND}\n", {4: FOUND}),
        # What gives a value to what follows, above all of it
        (
            2,
            "add_library(a b.cpp)\n",
            f"{VARIABLES}add_library(a b.cpp)\nif(X)\n  target_sources(a x)\nendif()\n",
            "add_library(a b.cpp)\n",
            "mine",
            {
                **{n: line.strip() for n, line in enumerate(VARIABLES.splitlines(), 4)},
                **{13: "if(X)", 14: "target_sources(a x)", 15: "endif()"},
            },
        ),
    ],
)
def test_item_of_cmake(ros, old, mine, new, wanted, lines):
    """Each after the packages; `mine` may be the change of `old`."""
    path = "CMakeLists.txt"
    mine = old.replace(*mine) if isinstance(mine, tuple) else mine
    wanted = {"mine": mine, "new": new}.get(wanted, wanted)
    before, after = PACKAGES[3 - ros], PACKAGES[ros]
    result = built({path: before + mine}, {path: before + old}, {path: after + new}, ros)
    assert result.tree[path].text == after + wanted
    assert {number: " ".join(words) for number, words in result.carried[path][1].items()} == lines


LISTS = {
    1: """\
find_package(catkin REQUIRED COMPONENTS
  roscpp
  tf2_ros
)
catkin_package(
  INCLUDE_DIRS
    include
  CATKIN_DEPENDS
    roscpp
    tf2_ros
)
add_executable(a
  src/a.cpp
  src/b.cpp
)
target_link_libraries(a
  ${catkin_LIBRARIES}
)
install(DIRECTORY
    config
    launch
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
)
""",
    2: """\
find_package(tf2_ros REQUIRED)
add_library(a SHARED
  src/a.cpp
  src/b.cpp
)
target_link_libraries(a
  PUBLIC
    ${tf2_ros_TARGETS}
)
install(DIRECTORY
    config
    launch
  DESTINATION share/${PROJECT_NAME}
)
ament_export_dependencies(
  tf2_ros
)
""",
}
COMPONENTS = "find_package(catkin REQUIRED COMPONENTS\n"
SOURCES = "  src/a.cpp\n  src/b.cpp\n"
LINKED = ("install(DIRECTORY", "target_link_libraries(a PRIVATE fmt)\ninstall(DIRECTORY")


@pytest.mark.parametrize(
    ("ros", "change", "carried", "behind"),
    [
        # What has another form, or stands elsewhere
        (2, (" COMPONENTS\n", "\n  COMPONENTS\n"), "", ""),
        (2, (f"{COMPONENTS}  roscpp\n  tf2_ros", f"{COMPONENTS}  tf2_ros\n  roscpp"), "", ""),
        (2, ("    roscpp\n    tf2_ros", "    tf2_ros roscpp"), "", ""),
        (2, ("  INCLUDE_DIRS\n    include\n  CATKIN", "  CATKIN"), "", ""),
        (2, (SOURCES, "  src/b.cpp\n  src/a.cpp\n"), "", ""),
        (1, (SOURCES, "  src/b.cpp\n  src/a.cpp\n"), "", ""),
        (2, ("    config\n    launch", "    launch\n    config"), "", "launch"),
        # Several in a line
        (
            2,
            (f"{COMPONENTS}  roscpp\n  tf2", f"{COMPONENTS[:-1]} nav_msgs roscpp\n  tf2"),
            ("(tf2_ros REQUIRED)\n", "(tf2_ros REQUIRED)\nfind_package(nav_msgs REQUIRED)\n"),
            "",
        ),
        (
            2,
            (f"(a\n{SOURCES}", "(a src/a.cpp src/b.cpp src/c.cpp"),
            (SOURCES, f"{SOURCES}  src/c.cpp\n"),
            "",
        ),
        # What means nothing there, by its keyword or its name
        (
            2,
            ("  INCLUDE", "  CFG_EXTRAS x.cmake\n  LIBRARIES a\n  INCLUDE"),
            "",
            "CFG_EXTRAS x.cmake|LIBRARIES a",
        ),
        (
            2,
            ("ros\n)\ncatkin", "ros\n  OPTIONAL_COMPONENTS\n  x\n)\ncatkin"),
            "",
            "OPTIONAL_COMPONENTS|x",
        ),
        (2, ("  roscpp\n", "  roscpp\n  rospy\n"), "", "rospy"),
        (2, ("install(", "catkin_package_xml(x)\ninstall("), "", "catkin_package_xml(x)"),
        (2, ("(a\n", "(a EXCLUDE_FROM_ALL\n"), "", "add_executable(a EXCLUDE_FROM_ALL"),
        (
            1,
            ("(tf2_ros REQUIRED)\n", "(tf2_ros REQUIRED)\nfind_package(rclcpp_action)\n"),
            "",
            "find_package(rclcpp_action)",
        ),
        # With a comment
        (
            2,
            (SOURCES, f"{SOURCES}  src/c.cpp  # C\n"),
            (SOURCES, f"{SOURCES}  src/c.cpp  # C\n"),
            "",
        ),
        (2, ("src/a.cpp", "src/a.cpp  # A"), "", "src/a.cpp  # A"),
        (
            2,
            ("  CATKIN_DEPENDS\n", "  CATKIN_DEPENDS\n    tf2  # T\n"),
            ("dependencies(\n", "dependencies(\n  tf2  # T\n"),
            "",
        ),
        # In a command of the developer's, of a form that the other ROS does not mix with its own
        (2, LINKED, ("  PUBLIC\n", "  PUBLIC\n    fmt\n"), ""),
        (1, LINKED, ("S}\n", "S}\n  fmt\n"), ""),
    ],
)
def test_what_a_list_has_more(ros, change, carried, behind):
    path = "CMakeLists.txt"
    old, new = ({path: File(encode(LISTS[which]))} for which in (3 - ros, ros))
    text = LISTS[3 - ros].replace(*change, 1)
    assert text != LISTS[3 - ros]
    mine, result = {path: File(encode(text))}, Result()
    carry_build_files(mine, old, new, Renaming(), result, ros)
    assert result.tree[path].text == (LISTS[ros].replace(*carried) if carried else LISTS[ros])
    left = prove(mine, old, result, result.tree, Renaming()).left
    assert "|".join(line.strip() for _, _, line in left) == behind


@pytest.mark.parametrize(
    "command", ["target_link_options (%s PRIVATE -g)\n", "install (TARGETS %s)\n"]
)
def test_command_with_a_blank_before_its_parenthesis_is_about_a_target(command):
    path, own = "CMakeLists.txt", (command % "reach", command % "gone")
    result = built({path: CMAKE_1 + "".join(own)}, {path: CMAKE_1}, {path: CMAKE_2}, 2)
    assert [line in result.tree[path].text for line in own] == [True, False]


def test_package_that_the_new_file_finds_already_is_found_once():
    path, own = "CMakeLists.txt", PACKAGES[1].replace("ros\n", "ros\n  nav_msgs\n")
    found = "find_package(nav_msgs REQUIRED)"
    new = {path: f"{PACKAGES[2]}{found}\n"}
    result = built({path: own}, {path: PACKAGES[1]}, new, 2)
    assert result.tree[path].text == new[path]
    assert result.carried[path][1] == {3: (found,)}


def test_package_for_targets_of_the_model_that_link_nothing_in_public():
    path, link = "CMakeLists.txt", "target_link_libraries(${PROJECT_NAME}_a\n  PRIVATE\n    x\n)\n"
    own = PACKAGES[1].replace("ros\n", "ros\n  nav_msgs\n  ${more}\n")
    result = built({path: own}, {path: PACKAGES[1]}, {path: PACKAGES[2] + link}, 2)
    found = "find_package(nav_msgs REQUIRED)\n"
    assert result.tree[path].text == PACKAGES[2] + found + link
    assert result.carried[path][1] == {3: (found.strip(),)}


def test_package_beside_catkin_without_components():
    path, new = "CMakeLists.txt", "find_package(catkin REQUIRED)\n"
    result = built({path: PACKAGES[2] + FOUND}, {path: PACKAGES[2]}, {path: new}, 1)
    assert result.tree[path].text == f"{new}{FOUND}\n"


def test_what_the_developer_deleted_of_cmake_is_said():
    path, other = "CMakeLists.txt", "install(DIRECTORY x DESTINATION include)\n"
    old = PACKAGES[1] + NESTED + "add_executable(reach x.cpp)\ninclude_directories()\n" + other
    new = PACKAGES[2] + "add_executable(reach y.cpp)\ninclude_directories()\n" + other
    result = built({path: PACKAGES[1] + other}, {path: old}, {path: new}, 2)
    assert result.back == {path: ["add_executable reach"]}


def test_generated_comment_above_an_own_command_stays_behind():
    """It was about the command below it, which the other ROS does not have."""
    path, comment, own = "CMakeLists.txt", "# NoDL of the nodes\n", "# Mine\nset(a b)\n"
    base = CMAKE_2 + f"\n{comment}install(FILES nodl DESTINATION x)\n"
    result = built({path: base.replace(comment, comment + own)}, {path: base}, {path: CMAKE_1}, 1)
    assert own in result.tree[path].text
    assert comment not in result.tree[path].text


def test_cmake_of_which_one_parenthesis_would_come_is_left_to_the_merge():
    path, mine = "CMakeLists.txt", PROPERTIES.replace("x\n", "x\n  Y (a\n    catkin b)\n")
    old, new = {path: PACKAGES[1] + PROPERTIES}, {path: PACKAGES[2] + PROPERTIES}
    result = built({path: PACKAGES[1] + mine}, old, new, 2)
    assert (result.tree, result.carried) == ({}, {})


def test_what_the_merge_said_of_files_that_are_carried():
    """That they conflict, say; and whose they are: their links and their own files stay."""
    path, other, link = "setup.py", "CMakeLists.txt", File(b"elsewhere", "120000")
    result = Result(missing={path: [], other: []}, conflicts={path: [], other: []})
    mine = {path: File(encode(SETUP + "mine()\n")), other: link}
    old = {path: File(encode(SETUP)), other: File(encode(CMAKE_1))}
    new = {path: File(encode(SETUP), "100755"), other: File(encode(CMAKE_2))}
    carry_build_files(mine, old, new, Renaming(), result, 2)
    assert (list(result.tree), result.tree[path].mode) == ([path], "100755")
    assert (list(result.missing), list(result.conflicts)) == ([other], [other])
    assert list(result.carried) == [path]


def test_cmake_that_nobody_changed_is_the_new_one():
    files = {"CMakeLists.txt": CMAKE_1}
    result = built(files, files, {"CMakeLists.txt": CMAKE_2}, 2)
    assert (result.tree, result.carried) == ({}, {})


def test_build_file_that_the_developer_has_deleted_is_made_for_another_ros():
    path, files = "setup.py", {"CMakeLists.txt": PYTHON_CMAKE, "setup.py": "setup()\n"}
    mine = {"CMakeLists.txt": PYTHON_CMAKE.replace("  config", "  config\n    urdf")}
    result = built(mine, files, {path: SETUP}, 2)
    assert ([*result.carried], [*result.tree]) == (["CMakeLists.txt"], [path])
    assert "        *installed('urdf'),\n" in result.tree[path].text


def test_lines_of_each_build_file_are_carried_by_their_own_numbers():
    """A package of ROS 1 in Python has both files."""
    cmake, setup = "CMakeLists.txt", "setup.py"
    old = {cmake: PYTHON_CMAKE, setup: "setup()\n"}
    mine = {cmake: patched(PYTHON_CMAKE, PYTHON_1_TO_2), setup: "setup()\n" + "mine()\n" * 30}
    result = built(mine, old, {setup: SETUP}, 2)
    assert sorted(result.carried[cmake][1]) == [14, 20, 23, 25]
    assert result.carried[setup][1] == {}


def test_build_file_that_is_the_developers_alone_is_none_of_the_model():
    mine = {"CMakeLists.txt": CMAKE_1, "setup.py": SETUP + "mine()\n"}
    result = built(mine, {"setup.py": SETUP}, {"setup.py": SETUP}, 2)
    assert ([*result.carried], [*result.tree]) == (["setup.py"], ["setup.py"])


def test_what_python_installs():
    """In CMakeLists.txt in ROS 1, in setup.py in ROS 2."""
    cmake, setup = "CMakeLists.txt", "setup.py"
    mine = patched(PYTHON_CMAKE, PYTHON_1_TO_2)
    for both in ({}, {setup: "setup()\n"}):  # a file of ROS 1, too, that nobody has edited
        result = built({cmake: mine, **both}, {cmake: PYTHON_CMAKE, **both}, {setup: SETUP}, 2)
        assert changes(SETUP, result.tree[setup].text) == SET_UP_1_TO_2
    assert result.carried == {
        cmake: (
            [cmake, setup],
            {
                14: ("*installed('urdf'),",),
                20: ("('share/' + package_name, ['plugin.xml', 'a.xml']),",),
                23: ("('lib/' + package_name, ['scripts/tool']),",),
                25: ("*installed('meshes'),",),
            },
        )
    }
    mine = patched(SETUP, PYTHON_2_TO_1)
    result = built({setup: mine}, {setup: SETUP}, {cmake: PYTHON_CMAKE}, 1)
    assert changes(PYTHON_CMAKE, result.tree[cmake].text) == SET_UP_2_TO_1
    programs = "install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})"
    files = "install(FILES plugin.xml a.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})"
    noted = {18: ("urdf",), 19: (programs,), 20: ("meshes",), 23: (files,)}
    assert result.carried[setup][1] == noted
    without = f"find_package(catkin)\n{programs}\n"
    result = built({setup: mine}, {setup: SETUP}, {cmake: without}, 1)
    assert (result.tree[cmake].text, result.carried[setup][1]) == (without, {})


def launched(**sides):
    """Carry launch files, of which the new one came out of the merge as it is."""
    trees = {
        name: {f"launch/{path}": File(encode(text)) for path, text in files.items()}
        for name, files in sides.items()
    }
    left = sorted(trees["mine"].keys() - trees["new"].keys())
    result = Result(tree=dict(trees["new"]), left=["README.md", *left])
    carry_launch_files(*trees.values(), Renaming(), result, 1)
    return result


def test_files_that_are_carried():
    mine = patched(LAUNCH_2, LAUNCH_2_TO_1)
    own, arm = "a.launch.xml", "arm.launch.xml"
    result = launched(
        mine={own: LAUNCH_2, arm: mine, "gone.launch.xml": mine, "z.py": ""},
        old={arm: LAUNCH_2, "gone.launch.xml": LAUNCH_2},
        new={"arm.launch": LAUNCH_1, "a.launch": LAUNCH_1},
    )
    assert changes(LAUNCH_1, result.tree["launch/arm.launch"].text) == CARRIED_2_TO_1
    assert result.tree["launch/a.launch"].text == LAUNCH_1
    assert {path: targets for path, (targets, _) in result.carried.items()} == {
        f"launch/{arm}": ["launch/arm.launch"]
    }
    assert result.back == {"launch/arm.launch": BACK_2_TO_1}


def test_launch_file_that_the_developer_has_already_stays():
    old, mine = File(encode(LAUNCH_2)), File(encode(patched(LAUNCH_2, LAUNCH_2_TO_1)))
    path, target = "arm.launch.xml", "arm.launch"
    result = Result(tree={target: mine}, left=[path])
    new = {target: File(encode(LAUNCH_1))}
    carry_launch_files({path: mine}, {path: old}, new, Renaming(), result, 1)
    assert (result.tree, result.carried) == ({target: mine}, {})


def test_launch_file_that_is_a_link_now_has_nothing_to_carry():
    path, target = "arm.launch.xml", "arm.launch"
    new = {target: File(encode(LAUNCH_1))}
    result = Result(tree=dict(new), left=[path])
    mine, old = File(b"elsewhere", "120000"), File(encode(LAUNCH_2))
    carry_launch_files({path: mine}, {path: old}, new, Renaming(), result, 1)
    assert (result.tree, result.carried) == (new, {})


def test_launch_file_that_is_no_xml_stays_behind():
    broken = {"arm.launch.xml": LAUNCH_2 + "<"}
    new = {"arm.launch": LAUNCH_1}
    result = launched(mine=broken, old={"arm.launch.xml": LAUNCH_2}, new=new)
    assert result.tree["launch/arm.launch"].text == LAUNCH_1
    assert result.carried == {}
