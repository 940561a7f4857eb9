# SPDX-License-Identifier: Apache-2.0
"""Checks what every source file must have: a licence line, `#pragma once` in headers, no path of one machine. That no two
types of one namespace have one name: the linker takes functions of the one for those of the other, and says nothing. And that
git keeps no generated file: no deck but the seeds of fuzzing, nothing of more than 500 kB.

    python3 tools/check_sources.py [ROOT]

Prints `file:line: what is wrong` for each breach and exits with 1, or with 0 where there is none. A file of more than
700 lines is named, without failing: is there a second one in it?
"""
import pathlib
import re
import subprocess
import sys

FOLDERS = ("src", "tests", "bench", "examples", "packaging", "tools", ".ci")
TOP_FILES = ("CMakeLists.txt", "dev")
SUFFIXES = {".cpp", ".hpp", ".h", ".inl", ".py", ".sh", ".cmake"}
LICENCE = "SPDX-License-Identifier: Apache-2.0"
LONG = 700
DECKS = {".k", ".key", ".dyn", ".rad"}
SEEDS = "tests/fuzz/"
LARGE = 500_000  # bytes

# Folders that are another thing on the next machine. System programs (/usr/bin) and devices (/dev) are not.
MACHINE_PATH = re.compile(r"(?<![\w./)}>-])/(?:home|root|work|tmp|mnt|opt|data|farm|media|Users)/")

COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
BRACE = re.compile(r"namespace\s*(?P<space>[\w:]*)\s*\{"
                   r"|\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?:alignas\([^()]*\)\s*)?(?P<type>\w[\w:]*)"
                   r"(?P<arguments><[^{};]*>)?(?:\s+final)?\s*(?::[^{};()=]*)?\{|[{}]")


def sources(root):
    for name in TOP_FILES:
        if (root / name).is_file():
            yield root / name
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and (path.suffix in SUFFIXES or path.name in ("CMakeLists.txt", "run")):
                yield path


def generated(root):
    """What git keeps and no hand has written; nothing where root is no repository."""
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-z", "--", "."], capture_output=True)
    for name in listed.stdout.decode("utf-8").split("\0"):
        path = root / name
        is_deck = path.suffix in DECKS and not name.startswith(SEEDS)
        if name and path.is_file() and (is_deck or path.stat().st_size > LARGE):
            yield name


def named_types(text):
    """(name with its namespaces, line) of the types that a source defines in namespaces that other sources see, too."""
    text = COMMENT_OR_STRING.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    spaces, depth = [], 0  # namespaces that are open, each with the depth of its brace
    for match in BRACE.finditer(text):
        if match[0] == "}":
            while spaces and spaces[-1][1] >= depth:
                spaces.pop()
            depth -= 1
            continue
        names = [name for name, _ in spaces]
        if match["type"] and not match["arguments"] and len(spaces) == depth and "" not in names:
            yield "::".join([*names, match["type"]]), text.count("\n", 0, match.start("type")) + 1
        depth += 1
        if match["space"] is not None:
            spaces.append((match["space"], depth))


def of_one_name(root):
    """Types of which sources that can meet in one program have each its own."""
    known = {}
    for path in sorted(path for path in (root / "src").rglob("*") if path.suffix in (".cpp", ".hpp")):
        place = path.relative_to(root).as_posix()
        for name, line in named_types(path.read_text(encoding="utf-8")):
            if name in known:
                yield f"{place}:{line}: {name} is another type at {known[name]}; give one of them another name"
            known.setdefault(name, f"{place}:{line}")


def breaches(root):
    """(errors, warnings) of all sources under root, each as `file:line: text`."""
    errors, warnings = [], []
    for path in sources(root):
        place = path.relative_to(root).as_posix()
        lines = path.read_text(encoding="utf-8").splitlines()
        first = 1 if lines and lines[0].startswith("#!") else 0
        if len(lines) <= first or not lines[first].endswith(LICENCE):
            errors.append(f"{place}:{first + 1}: the first line must be `{LICENCE}` in a comment")
        if path.suffix in (".hpp", ".h") and "#pragma once" not in lines:
            errors.append(f"{place}:1: a header needs `#pragma once`")
        for number, line in enumerate(lines[first:], start=first + 1):
            if MACHINE_PATH.search(line):
                errors.append(f"{place}:{number}: a path of one machine; make it relative, or take it as an argument")
        if len(lines) > LONG:
            warnings.append(f"{place}:{LONG}: {len(lines)} lines; is there a second file in it?")
    errors += of_one_name(root)
    for name in generated(root):
        errors.append(f"{name}:1: git keeps a deck or a file of more than {LARGE} bytes; take it out, and write what makes it")
    return errors, warnings


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    errors, warnings = breaches(root)
    for line in warnings:
        print(f"{line} (warning)")
    for line in errors:
        print(line)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
