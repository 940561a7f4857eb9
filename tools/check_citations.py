# SPDX-License-Identifier: Apache-2.0
"""Checks that what sources, tests and pages cite stands in the repository.

    docs/theory/shell.md           a page that exists
    docs/theory/shell.md#frame     and a heading in it, by its anchor
    docs/decisions/0017            a decision, by its number or whole name

Sources and tests cite no document outside of the repository. In docs links between pages are looked at too, but those
to the pages of the keywords, which are generated.
"""
import pathlib
import re
import sys
import unicodedata

PAGE = re.compile(r"(?<![\w./-])docs/[\w./-]*?\.md\b(?:#([\w-]+))?")
DECISION = re.compile(r"(?<![\w./-])docs/decisions/(\d{4})(?![\w-])")
OUTSIDE = re.compile(r"\.\./shared/(?:reference|design)|\b(?:element|spotweld)-theory\b")
LINK = re.compile(r"\]\(([\w./-]*\.md)?(?:#([\w-]+))?\)")
HEADING = re.compile(r"^#{1,6} +(.*?) *#*$", re.M)
GENERATED = "docs/manual/keywords"  # by tools/site.py
SUFFIXES = {".cpp", ".hpp", ".py", ".txt", ".cmake", ".in", ".md"}


def anchor_of(heading):
    """As Python-Markdown's table of contents makes it."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode("ascii")
    return re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", text).strip().lower())


class Pages:
    """The headings of pages, each page read once."""

    def __init__(self, root):
        self.root = root.resolve()
        self.anchors = {}

    def fault(self, path, anchor):
        """What is wrong with a citation of the page at `path`; None where nothing is."""
        path = path.resolve()
        if not path.is_file():
            return "there is no such page"
        if anchor is None:
            return None
        if path not in self.anchors:
            text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)
            self.anchors[path] = {anchor_of(heading) for heading in HEADING.findall(text)}
        return None if anchor in self.anchors[path] else "the page has no such heading"

    def decision_exists(self, number):
        return any((self.root / "docs/decisions").glob(f"{number}*.md"))


def citations(pages, path, text):
    """Pairs of a place in `text` and what is wrong with what it cites."""
    inside = path.relative_to(pages.root).as_posix()
    for match in PAGE.finditer(text):
        fault = pages.fault(pages.root / match.group(0).split("#")[0], match.group(1))
        if fault:
            yield match, fault
    for match in DECISION.finditer(text):
        if not pages.decision_exists(match.group(1)):
            yield match, "there is no such decision"
    if inside.startswith(("src/", "tests/")):
        for match in OUTSIDE.finditer(text):
            yield match, "cites a document outside of the repository; its theory belongs into docs/theory"
    if inside.startswith("docs/"):
        for match in LINK.finditer(text):
            page = path.parent / match.group(1) if match.group(1) else path
            if page.parent.resolve() == pages.root / GENERATED:
                continue
            fault = pages.fault(page, match.group(2))
            if fault:
                yield match, fault


def breaches(root):
    """All breaches under root, as `file:line: text`."""
    pages, found = Pages(root), []
    for folder in ("src", "tests", "docs"):
        for path in sorted((pages.root / folder).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file():
                continue
            text = path.read_text(encoding="utf-8")
            for match, fault in citations(pages, path, text):
                place = f"{path.relative_to(pages.root).as_posix()}:{text.count(chr(10), 0, match.start()) + 1}"
                found.append(f"{place}: {match.group(0)}: {fault}")
    return found


def main():
    found = breaches(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
