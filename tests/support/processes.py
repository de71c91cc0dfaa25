"""How the tests are shared among the processes of a run."""

import re
import zlib

from xdist.scheduler import LoadFileScheduling

PARTS = 4
SINGLE = re.compile(r"tests/(adoption|publishing|updates)/(?!test_(form|lab|nesting))")
WAITING = re.compile(r"tests/(contract|ros)/|\w+_model-[a-z]+ \d")
"""What waits for nodes most of its time."""
VARIANT = re.compile(r"/test_contract\.py::.*\[(\w+_model-[a-z]+)")


class Scheduling(LoadFileScheduling):
    """Give a process a whole file, or the single test where tests take seconds and share little.

    Of the contract, whose tests mostly wait, it is a part of those of a variant. The parts are no
    marks `xdist_group`, which pytest-xdist 3.8 does not see with pytest 9.2.
    """

    def _assign_work_unit(self, node):
        """Give one process in four what computes, while there is such; the others what waits."""
        computes = int(re.search(r"\d+", node.gateway.id)[0]) % 4 == 3
        wanted = (scope for scope in self.workqueue if bool(WAITING.match(scope)) != computes)
        self.workqueue.move_to_end(next(wanted, next(iter(self.workqueue))), last=False)
        super()._assign_work_unit(node)

    def _split_scope(self, nodeid):
        if SINGLE.search(nodeid):
            return nodeid
        variant = VARIANT.search(nodeid)
        return f"{variant[1]} {part(nodeid)}" if variant else super()._split_scope(nodeid)


def part(nodeid):
    return zlib.crc32(nodeid.encode()) % PARTS
