"""What the developer wrote into launch and build files, carried into those of another ROS.

As it is written there, without a render: changes are as `diff -U0` shows them.
"""

import difflib

import pytest

from hooks.merge.builds import carry_build_files
from hooks.merge.languages import XML
from hooks.merge.launch import carry, carry_launch_files
from hooks.merge.package import Result
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
 install(DIRECTORY config DESTINATION share/${PROJECT_NAME})
+target_compile_options(reach PRIVATE -O3)
+install(PROGRAMS scripts/tool DESTINATION lib/${PROJECT_NAME})
+install(PROGRAMS scripts/more.py DESTINATION lib/${PROJECT_NAME})

 ament_export_dependencies(
+  tf2_ros
   std_msgs
"""
NUMBERS_1_TO_2 = [7, 13, 16, 17, 20, 22, 28, 33, 37, 40, 41, 42, 43, 45, 46]
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
NUMBERS_2_TO_1 = [6, 7, 11, 13, 19, 24, 25, 28, 29, 31, 32, 33, 44]
SETUP = """\
from glob import glob
from setuptools import setup

package_name = 'arm'


def installed(folder):
    return folder


setup(
    name=package_name,
    data_files=[
        ('share/' + package_name, ['package.xml']),
        *installed('config'),
    ],
)
"""
PYTHON_CMAKE = """\
cmake_minimum_required(VERSION 3.10)
project(arm)

find_package(catkin REQUIRED)

catkin_python_setup()
catkin_package()

install(DIRECTORY
    config
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
)
"""
PYTHON_1_TO_2 = """\
     config
+    urdf
   DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
 )
+install(FILES plugin.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
+install(DIRECTORY meshes DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
+add_library(x x.cpp)
"""
SET_UP_1_TO_2 = """\
         *installed('config'),
+        *installed('urdf'),
+        ('share/' + package_name, ['plugin.xml']),
+        ('lib/' + package_name, ['scripts/tool']),
+        *installed('meshes'),
     ],
"""
PYTHON_2_TO_1 = """\
         *installed('config'),
+        *installed('urdf'),
+        ('lib/' + package_name, ['scripts/tool']),
+        ('share/' + package_name + '/meshes', glob('meshes/*')),
+        ('share/' + package_name, ['plugin.xml']),
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
+install(FILES plugin.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
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


def test_cmake_that_nobody_changed_is_the_new_one():
    files = {"CMakeLists.txt": CMAKE_1}
    result = built(files, files, {"CMakeLists.txt": CMAKE_2}, 2)
    assert (result.tree, result.carried) == ({}, {})


def test_what_python_installs():
    """In CMakeLists.txt in ROS 1, in setup.py in ROS 2."""
    cmake, setup = "CMakeLists.txt", "setup.py"
    mine = patched(PYTHON_CMAKE, PYTHON_1_TO_2)
    result = built({cmake: mine}, {cmake: PYTHON_CMAKE}, {setup: SETUP}, 2)
    assert changes(SETUP, result.tree[setup].text) == SET_UP_1_TO_2
    mine = patched(SETUP, PYTHON_2_TO_1)
    result = built({setup: mine}, {setup: SETUP}, {cmake: PYTHON_CMAKE}, 1)
    assert changes(PYTHON_CMAKE, result.tree[cmake].text) == SET_UP_2_TO_1


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


def test_launch_file_that_is_no_xml_stays_behind():
    broken = {"arm.launch.xml": LAUNCH_2 + "<"}
    new = {"arm.launch": LAUNCH_1}
    result = launched(mine=broken, old={"arm.launch.xml": LAUNCH_2}, new=new)
    assert result.tree["launch/arm.launch"].text == LAUNCH_1
    assert result.carried == {}
