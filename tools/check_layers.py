# SPDX-License-Identifier: Apache-2.0
"""Checks who includes whom: a folder of src/ includes only what stands before it.

    python3 tools/check_layers.py [ROOT]

Prints `file:line: what is wrong` for each breach and exits with 1, or with 0 where there is none.
"""
import pathlib
import re
import sys

# For each folder, those it may include besides itself. Neighbours (deck and kernel, contact and output, impact and
# nvh) do not know each other.
MAY_INCLUDE = {
    "base": [],
    "deck": ["base"],
    "kernel": ["base"],
    "model": ["base", "deck", "kernel"],
    "weld": ["base", "deck", "kernel", "model"],
    "system": ["base", "deck", "kernel", "model", "weld"],
    "contact": ["base", "deck", "kernel", "model", "weld", "system"],
    "output": ["base", "deck", "kernel", "model", "weld", "system"],
    "impact": ["base", "deck", "kernel", "model", "weld", "system", "contact", "output"],
    "nvh": ["base", "deck", "kernel", "model", "weld", "system", "contact", "output"],
    "report": ["base", "deck", "kernel", "model", "weld", "system", "contact", "output", "impact", "nvh"],
    "app": ["base", "deck", "kernel", "model", "weld", "system", "contact", "output", "impact", "nvh", "report"],
}

# A kernel is a pure function of one element or point: it does no input or output and starts no threads.
NOT_IN_KERNEL = {"iostream", "fstream", "ostream", "istream", "cstdio", "stdio.h", "filesystem", "thread", "mutex", "mpi.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def breaches(root):
    """All breaches under root/src, as `file:line: text`."""
    found = []
    src = root / "src"
    for path in sorted(src.rglob("*")):
        if path.suffix not in (".cpp", ".hpp", ".h", ".inl"):
            continue
        place = path.relative_to(root).as_posix()
        room = path.relative_to(src).parts[0]
        if room not in MAY_INCLUDE:
            found.append(f"{place}:1: src/{room} has no place among the layers; give it one in tools/check_layers.py")
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            if match:
                text = fault(room, match.group(1) == '"', match.group(2))
                if text:
                    found.append(f"{place}:{number}: {text}")
    return found


def fault(room, quoted, name):
    """What is wrong with `#include "name"` (or <name>) in a file of `room`; None where nothing is."""
    target = name.split("/")[0]
    if "/" in name and target in MAY_INCLUDE:
        if target != room and target not in MAY_INCLUDE[room]:
            return f'{room} may not include "{name}": {target} does not stand before {room}'
    elif quoted:
        return f'"{name}": own headers are included from src/, as "folder/file.hpp"'
    elif room == "kernel" and name in NOT_IN_KERNEL:
        return f"kernel may not include <{name}>: kernels are pure functions"
    return None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    found = breaches(root)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
