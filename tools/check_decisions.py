# SPDX-License-Identifier: Apache-2.0
"""Checks the pages of docs/decisions: one format for all, an index that is complete, no mention of a decision that is not there.

    python3 tools/check_decisions.py [ROOT]

Prints `file:line: what is wrong` for each breach and exits with 1, or with 0 where there is none. A page is `NNNN-words.md`:

    # NNNN Title

    Status: accepted · Date: YYYY-MM-DD          (or: Status: superseded by NNNN · Date: …)

    ## Context, ## Decision, ## Measured, ## Not taken, ## Consequences

in this order; Context and Decision always, the others where there is something to say. Lines end at 120 columns, but for tables. README.md has
a row `| [NNNN](file) | title | status | date | one line |` for each.
"""
import pathlib
import re
import sys

SECTIONS = ["Context", "Decision", "Measured", "Not taken", "Consequences"]
NEEDED = SECTIONS[:2]
WIDTH = 120

NAME = re.compile(r"(\d{4})-[a-z0-9-]+\.md")
STATUS = re.compile(r"Status: (accepted|superseded by (\d{4})) · Date: (\d{4}-\d\d-\d\d)")
ROW = re.compile(r"\| \[(\d{4})\]\(([^)]+)\) \| (.+?) \| (.+?) \| (.+?) \| (.+?) \|")
MENTION = re.compile(r"\b(?:[Dd]ecisions? (\d{4})|decisions/(\d{4}))\b")
OUTSIDE = re.compile(r"\.\./shared|[Dd]esign decision|\bDesign \d")
MENTIONED_IN = [("src", {".cpp", ".hpp"}), ("tests", {".cpp", ".hpp", ".py"}), ("docs", {".md"}), ("tools", {".py"})]


class Page:
    """What a page says of itself, and what is wrong with its form."""

    def __init__(self, path, place):
        self.name, self.number, self.place = path.name, path.name[:4], place
        self.lines = path.read_text(encoding="utf-8").splitlines()
        self.found = []
        head = self.line(1)
        self.title = head[len(f"# {self.number} "):]
        if not head.startswith(f"# {self.number} ") or not self.title:
            self.breach(1, f"expected `# {self.number} Title`")
        status = STATUS.fullmatch(self.line(3))
        self.status, self.successor, self.date = (status[1], status[2], status[3]) if status else ("", None, "")
        if not status:
            self.breach(3, "expected `Status: accepted · Date: YYYY-MM-DD`, or `Status: superseded by NNNN · Date: …`")
        self.sections()
        self.text()

    def line(self, number):
        return self.lines[number - 1] if len(self.lines) >= number else ""

    def breach(self, line, text):
        self.found.append(f"{self.place}/{self.name}:{line}: {text}")

    def sections(self):
        names = []
        for number, line in enumerate(self.lines, 1):
            if number > 1 and re.match(r"#+ ", line):
                name = line.removeprefix("## ")
                if name not in SECTIONS:
                    self.breach(number, f"expected one of the headings {', '.join('## ' + s for s in SECTIONS)}, found {line}")
                elif names and name in SECTIONS[:SECTIONS.index(names[-1]) + 1]:
                    self.breach(number, f"## {name} does not come after ## {names[-1]}")
                else:
                    names.append(name)
        for name in NEEDED:
            if name not in names:
                self.breach(1, f"has no ## {name}")

    def text(self):
        for number, line in enumerate(self.lines, 1):
            if len(line) > WIDTH and not line.lstrip().startswith("|"):
                self.breach(number, f"{len(line)} columns, at most {WIDTH}")
            if OUTSIDE.search(line):
                self.breach(number, "cites what is not in the repository")


def index_breaches(folder, place, pages):
    index = folder / "README.md"
    if not index.is_file():
        return [f"{place}/README.md:1: is missing"]
    found, seen = [], set()
    for number, line in enumerate(index.read_text(encoding="utf-8").splitlines(), 1):
        row = ROW.fullmatch(line)
        if not row:
            if line.startswith("| ["):
                found.append(f"{place}/README.md:{number}: expected | [NNNN](file) | title | status | date | one line |")
            continue
        page = pages.get(row[1])
        if page is None or row[1] in seen:
            found.append(f"{place}/README.md:{number}: {row[1]} " + ("stands here twice" if page else "has no page"))
            continue
        seen.add(row[1])
        for what, said, real in [("file", row[2], page.name), ("title", row[3], page.title), ("status", row[4], page.status),
                                 ("date", row[5], page.date)]:
            if said != real:
                found.append(f"{place}/README.md:{number}: {what} of {row[1]} is {real}")
    return found + [f"{place}/README.md:1: {pages[n].name} is missing" for n in sorted(set(pages) - seen)]


def dangling(root, numbers):
    found = []
    for folder, kinds in MENTIONED_IN:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in kinds or path.name in ("check_decisions.py", "test_checks.py"):
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for match in MENTION.finditer(line):
                    named = match[1] or match[2]
                    if named not in numbers:
                        found.append(f"{path.relative_to(root)}:{number}: there is no decision {named}")
    return found


def breaches(root):
    """All breaches under root, as `file:line: text`."""
    folder = root / "docs/decisions"
    place = folder.relative_to(root)
    found, pages = [], {}
    for path in sorted(folder.glob("*.md")):
        if path.name == "README.md":
            continue
        if not NAME.fullmatch(path.name):
            found.append(f"{place}/{path.name}:1: expected a name like 0001-words-of-the-title.md")
        elif path.name[:4] in pages:
            found.append(f"{place}/{path.name}:1: {path.name[:4]} is the number of {pages[path.name[:4]].name}")
        else:
            pages[path.name[:4]] = Page(path, place)
    for page in pages.values():
        found += page.found
        if page.successor and page.successor not in pages:
            found.append(f"{place}/{page.name}:3: there is no decision {page.successor}")
    return found + index_breaches(folder, place, pages) + dangling(root, pages)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    found = breaches(root)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
