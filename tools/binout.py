# SPDX-License-Identifier: Apache-2.0
"""Reads binout (LSDA) files.

    tools/binout.py FILE            lists the branches and their variables
"""
import collections
import pathlib
import struct
import sys

TYPES = {1: "b", 2: "h", 3: "i", 4: "q", 5: "B", 6: "H", 7: "I", 8: "Q", 9: "f", 10: "d"}


def variables(path):
    """{path: values}, by following the records from the head; strings as bytes."""
    data = pathlib.Path(path).read_bytes()
    at, folder, found = data[0], "", {}
    while at < len(data):
        length, command = struct.unpack_from("<QB", data, at)
        body = data[at + 9:at + length]
        if command == 2:
            name = body.decode()
            folder = name if name.startswith("/") else f"{folder}/{name}"
        elif command == 3:
            name = body[2:2 + body[1]].decode()
            values = body[2 + body[1]:]
            code = TYPES[body[0]]
            found[f"{folder}/{name}"] = values if code == "b" else struct.unpack(f"<{len(values) // struct.calcsize(code)}{code}", values)
        at += length
    return found


def history(path, branch, name):
    """[(time, values)] of a variable of a branch such as bndout/velocity/rigidbodies."""
    rows = []
    states = collections.defaultdict(dict)
    for place, values in variables(path).items():
        folder, _, variable = place.rpartition("/")
        if folder.startswith(f"/{branch}/d") and variable in ("time", name):
            states[folder][variable] = values
    for folder in sorted(states):
        if len(states[folder]) == 2:
            rows.append((states[folder]["time"][0], states[folder][name]))
    return rows


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    shown = collections.Counter()
    for key in variables(sys.argv[1]):
        parts = ["*" if p[0] == "d" and p[1:].isdigit() else p for p in key.split("/") if p]
        shown["/".join(parts)] += 1
    for key, count in shown.items():
        print(f"{count:6d} {key}")
