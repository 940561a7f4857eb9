# SPDX-License-Identifier: Apache-2.0
"""Runs by several ranks of mpirun."""
import os
import pathlib
import shutil

from nugget_command import NUGGET

MPIRUN = shutil.which("mpirun")
# mpirun wants to be asked twice before it runs as root, which is what containers do.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def mpirun(ranks, *arguments):
    """The command of a call of nugget by so many ranks."""
    return [MPIRUN, "--oversubscribe", "--bind-to", "none", "-n", str(ranks), NUGGET, *map(str, arguments)]


def ranks_in(folder):
    """Processes that stand in a folder, but for mpirun."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if (process / "cwd").resolve() == folder.resolve() and (process / "exe").resolve().name.startswith("nugget-mpi"):
                found.append(int(process.name))
        except OSError:
            continue  # of somebody else, or gone
    return sorted(found)
