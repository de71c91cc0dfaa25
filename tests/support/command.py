"""The copier command as a user runs it, without the second that Python needs to import it.

A copy of this process runs it, with a folder, an environment and an end of its own.
"""

import os
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

from copier.__main__ import CopierApp
from plumbum import local

OWN = ("hooks", "support")
"""Modules of this process that Copier is not to find: a template brings its own."""


def run_copier(arguments, cwd, environment):
    """Run the command; the result has returncode, stdout and stderr."""
    arguments = [*map(str, arguments)]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as error:
        sys.stdout.flush()
        sys.stderr.flush()
        child = os.fork()
        if child == 0:
            _become(arguments, cwd, environment, out, error)
        _, status = os.waitpid(child, 0)
        printed = []
        for file in (out, error):
            file.seek(0)
            printed.append(file.read().decode())
    return subprocess.CompletedProcess(arguments, os.waitstatus_to_exitcode(status), *printed)


def _become(arguments, cwd, environment, out, error):
    """Be the command, and end."""
    code = 1
    try:
        with open(os.devnull) as nothing:
            os.dup2(nothing.fileno(), 0)
        os.dup2(out.fileno(), 1)
        os.dup2(error.fileno(), 2)
        sys.stdin, sys.stdout = os.fdopen(0, closefd=False), os.fdopen(1, "w", closefd=False)
        sys.stderr = os.fdopen(2, "w", closefd=False, errors="backslashreplace")
        os.chdir(cwd)
        os.environ.update(environment)
        tempfile.tempdir = None
        local.env.clear()  # plumbum, by which Copier runs git, remembers it
        local.env.update(os.environ)
        tests = Path(__file__).parents[1]
        sys.path[:] = [path for path in sys.path if Path(path) not in (tests, tests.parent)]
        for name in [name for name in sys.modules if name.split(".")[0] in OWN]:
            del sys.modules[name]
        CopierApp.run(["copier", *arguments])
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else bool(end.code)
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
