"""How the tests are shared among the processes of a run."""

import re
import zlib

from xdist.scheduler import LoadFileScheduling

PARTS = 4
VARIANT = re.compile(r"/test_contract\.py::.*\[(\w+_model-[a-z]+)")


class Scheduling(LoadFileScheduling):
    """Give a process a whole file; of the contract, whose tests mostly wait, parts of a variant.

    They are no marks `xdist_group`, which pytest-xdist 3.8 does not see with pytest 9.2.
    """

    def _split_scope(self, nodeid):
        variant = VARIANT.search(nodeid)
        return f"{variant[1]} {part(nodeid)}" if variant else super()._split_scope(nodeid)


def part(nodeid):
    return zlib.crc32(nodeid.encode()) % PARTS
