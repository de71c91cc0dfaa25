"""Make CMake find things where the ROS 2 wheels have been installed; run by their Python.

Their CMake files name folders of the machine they were built on.
"""

import sys
import sysconfig
from pathlib import Path

PREFIX = Path(sys.prefix)
BUILDER = "/opt/python/cp{0}-cp{0}".format("{}{}".format(*sys.version_info))
PYTHON = "{}.{}".format(*sys.version_info)


def replacements():
    import numpy

    site = Path(sysconfig.get_path("purelib"))
    yield f"{BUILDER}/include/python{PYTHON}", sysconfig.get_path("include")
    yield f"{BUILDER}/lib/python{PYTHON}/site-packages/numpy/_core/include", numpy.get_include()
    for library in site.glob("ros_fastdds.libs/libtinyxml2*"):
        yield "/usr/lib64/libtinyxml2.so", str(library)
    yield ";lttng-ust", ""
    yield "lttng-ust;", ""


def main():
    words = list(replacements())
    for file in (PREFIX / "share").rglob("*.cmake"):
        text = mended = file.read_text()
        for old, new in words:
            mended = mended.replace(old, new)
        if mended != text:
            file.write_text(mended)


if __name__ == "__main__":
    main()
