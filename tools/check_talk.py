# SPDX-License-Identifier: Apache-2.0
"""Checks the table of docs/verification/talk.md: every test that it names exists, every statement has its row.

    python3 tools/check_talk.py [ROOT]

Prints `file:line: what is wrong` for each breach and exits with 1, or with 0 where there is none. A row is

    | 12 | statement | verdict | text with `names of tests` |

with a verdict held, partly, open or background. A statement that is held names a test, one that is background none. Names are
those of ctest for GoogleTest, `verify.Suite.Name` and `unit.ROOM.Suite.Name`, and `FILE.py::test_name` for Python.
The sentence `Of N statements: ...` counts the verdicts; variants (57b, 57c) do not count.
"""
import collections
import pathlib
import re
import sys

PAGE = "docs/verification/talk.md"
VERDICTS = ("held", "partly", "open", "background")
VARIANTS = ("57b", "57c")
NUMBERS = [n for i in range(1, 87) for n in [str(i), *{57: VARIANTS, 76: ("76b",), 84: ("84b",)}.get(i, ())]] + ["ex"]
ROW = re.compile(r"^\| (\d+[a-z]?|ex) \| (.+?) \| (\w+) \| (.*?) ?\|$")
NAME = re.compile(r"`((?:verify|unit)\.[\w./]+|[\w/]+\.py::\w+)`")
COUNT = re.compile(r"^Of (\d+) statements: (\d+) held, (\d+) partly, (\d+) open, (\d+) background\.$", re.M)


def google_tests(folder, prefix):
    """Names of the tests in the sources of a folder, as ctest has them."""
    for path in folder.glob("*.cpp"):
        for suite, name in re.findall(r"^\s*TEST(?:_F)?\((\w+),\s*(\w+)\)", path.read_text(encoding="utf-8"), re.M):
            yield f"{prefix}.{suite}.{name}"


def known_tests(root):
    names = set(google_tests(root / "tests/verify", "verify"))
    for room in (root / "tests/unit").glob("*/"):
        names.update(google_tests(room, f"unit.{room.name}"))
    for folder in ("tests/decks", "examples"):
        for path in (root / folder).glob("test_*.py"):
            names.update(f"{folder}/{path.name}::{name}" for name in re.findall(r"^\s+def (test_\w+)\(", path.read_text(encoding="utf-8"), re.M))
    return names


def breaches_of_row(number, verdict, held_by, tests, numbers):
    named = NAME.findall(held_by)
    if number in numbers:
        yield f"{number} stands here twice"
    if verdict not in VERDICTS:
        yield f"{number}: the verdict is {', '.join(VERDICTS)}, not {verdict}"
    if verdict == "held" and not named and number not in VARIANTS:
        yield f"{number} is held, but by no test"
    if verdict == "background" and named:
        yield f"{number} is background, but has a test"
    for name in named:
        if name not in tests:
            yield f"{number}: there is no test {name}"


def breaches(root):
    path, tests = root / PAGE, known_tests(root)
    text, numbers, counted = path.read_text(encoding="utf-8"), [], collections.Counter()
    for line, row in enumerate(text.splitlines(), 1):
        if not (found := ROW.match(row)):
            continue
        number, _, verdict, held_by = found.groups()
        yield from (f"{PAGE}:{line}: {fault}" for fault in breaches_of_row(number, verdict, held_by, tests, numbers))
        numbers.append(number)
        counted[verdict] += number not in VARIANTS
    if missing := [n for n in NUMBERS if n not in numbers]:
        yield f"{PAGE}: no row for {', '.join(missing)}"
    elif numbers != NUMBERS:
        yield f"{PAGE}: rows are not in the order of the talk"
    told = COUNT.search(text)
    seen = [sum(counted.values()), *(counted[v] for v in VERDICTS)]
    if not told or [int(n) for n in told.groups()] != seen:
        yield f"{PAGE}: expected the sentence `Of {seen[0]} statements: " + ", ".join(f"{n} {v}" for n, v in zip(seen[1:], VERDICTS)) + ".`"


def main():
    found = list(breaches(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
