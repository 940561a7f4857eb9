# SPDX-License-Identifier: Apache-2.0
"""Joins test files to one source, so that what they instantiate alike is made once (docs/decisions/0066).

    tests/join.py JOINED.cpp TEST.cpp...

Test files call their helpers alike: the namespace in which a file stands becomes one of its own inside of it. Messages
and breakpoints name the files and lines as they are.
"""
import pathlib
import re
import sys


def joined(paths):
    text = ""
    for path in paths:
        source = re.sub(r"^(namespace nugget::[\w:]+) \{$", rf"\1::{path.stem} {{", path.read_text(encoding="utf-8"), flags=re.M)
        text += f'#line 1 "{path}"\n{source}\n'
    return text


def main():
    target = pathlib.Path(sys.argv[1])
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(joined([pathlib.Path(name) for name in sys.argv[2:]]), encoding="utf-8")


if __name__ == "__main__":
    main()
