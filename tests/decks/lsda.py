# SPDX-License-Identifier: Apache-2.0
"""Reads binout (LSDA): walks its records from the first byte to the last, as LSTC's public translator l2a reads them. The symbol tables at the
end of each flush repeat what stands in the data records and are stepped over."""
import struct

NUMBERS = {1: "s", 3: "i", 4: "q", 9: "f", 10: "d"}


def read(path):
    """{"swforc/d000001/axial": [...]}; text where the items are characters."""
    data = path.read_bytes()
    header, length_bytes, _, command_bytes, type_bytes, little = data[:6]
    order = "<" if little == 1 else ">"
    found, folder, at = {}, [], header
    while at < len(data):
        size = int.from_bytes(data[at:at + length_bytes], "little" if little == 1 else "big")
        body = data[at + length_bytes + command_bytes:at + size]
        command = data[at + length_bytes]
        if command == 2:  # CD
            path_text = body.decode("ascii")
            steps = path_text.split("/")
            folder = [] if path_text.startswith("/") else list(folder)
            for step in steps:
                if step == "..":
                    folder.pop()
                elif step:
                    folder.append(step)
        elif command == 3:  # DATA
            kind, name_length = body[0], body[type_bytes]
            name = body[type_bytes + 1:type_bytes + 1 + name_length].decode("ascii")
            raw = body[type_bytes + 1 + name_length:]
            code = NUMBERS[kind]
            found["/".join([*folder, name])] = (raw.decode("ascii") if code == "s" else
                                                list(struct.unpack(f"{order}{len(raw) // struct.calcsize(code)}{code}", raw)))
        at += size
    return found


def states(found, branch):
    """[{name: values}] of a branch, however deep it lies, in the order of the states."""
    by_state = {}
    for key, value in found.items():
        if key.startswith(branch + "/d"):
            by_state.setdefault(key[len(branch) + 1:].split("/")[0], {})[key.split("/")[-1]] = value
    return [by_state[name] for name in sorted(by_state)]
