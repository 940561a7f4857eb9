# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of docs/verification from the rows that the verification tests leave.

    NUGGET_VERIFICATION_ROWS=ROWS test_verify
    python3 tools/verification_table.py ROWS docs/verification tests/verify

A row is: case, what, reference, value, error, gate, separated by tabs. Each page of the folder that has the two
marks of a table names the test sources whose cases it shows, `<!-- sources: shells layers -->`; a case belongs to
the sources that name it, or what stands before its colon. `<!-- sources: * -->` marks the page of all other cases.
Between a page's two marks everything is replaced. Exits with 1, and changes nothing, where there are no rows, a row
is broken, a mark is missing, a page names a source that is not there, or no page or two pages take the other cases.
"""
import pathlib
import re
import sys

BEGIN, END = "<!-- table: begin -->", "<!-- table: end -->"
SOURCES = re.compile(r"<!-- sources: (.*?) -->")
OTHERS = "*"


def read_rows(text):
    """Rows as lists of six cells. Raises ValueError that names the line of a broken one."""
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        cells = line.split("\t")
        if len(cells) != 6:
            raise ValueError(f"line {number}: expected 6 cells, found {len(cells)}")
        try:
            [float(cell) for cell in cells[2:]]
        except ValueError:
            raise ValueError(f"line {number}: reference, value, error and gate must be numbers") from None
        rows.append(cells)
    if not rows:
        raise ValueError("no rows")
    return rows


def headings(page):
    """Names of the cases that a page explains, in its order."""
    return re.findall(r"^### (.+)$", page, re.MULTILINE)


def order(case, explained):
    """Cases that have an explanation in the order of these, then the others by name."""
    return (0, explained.index(case), case) if case in explained else (1, 0, case)


def share(cell):
    return f"{100.0 * float(cell):.2g} %"


def table(rows, explained):
    lines = ["| case | what | reference | Nugget | error | gate |", "|---|---|---|---|---|---|"]
    last = None
    for case, what, reference, value, error, gate in sorted(rows, key=lambda row: order(row[0], explained)):
        verdict = share(error) if float(error) <= float(gate) else f"**{share(error)}**"
        what = what.replace("|", "\\|")
        lines.append(f"| {case if case != last else ''} | {what} | {reference} | {value} | {verdict} | {share(gate)} |")
        last = case
    return "\n".join(lines)


def with_table(page, rows, explained):
    before, begin, rest = page.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"the page has no {BEGIN} ... {END}")
    text = table(rows, explained) if rows else "None."
    return f"{before}{BEGIN}\n\n{text}\n\n{END}{after}"


def read_sources(folder):
    """Text of each test source by its name, without test_ and suffix."""
    return {path.stem.removeprefix("test_"): path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.cpp"))}


def read_pages(folder, sources):
    """Path -> (text, names of its sources) of the pages with a table. Raises ValueError that names a page."""
    pages = {}
    for path in sorted(folder.glob("*.md")):
        text = path.read_text(encoding="utf-8")
        if named := SOURCES.search(text):
            pages[path] = (text, named[1].split())
        elif BEGIN in text:
            raise ValueError(f"{path.name}: no <!-- sources: ... --> says whose cases the table has")
    for path, (_, names) in pages.items():
        for name in names:
            if name != OTHERS and name not in sources:
                raise ValueError(f"{path.name}: there is no test source {name}")
    if sum(OTHERS in names for _, names in pages.values()) != 1:
        raise ValueError(f"expected one page with <!-- sources: {OTHERS} -->")
    return pages


def page_of(case, pages, sources):
    """The first page one of whose sources names the case, or else what stands before its colon; or that of all others."""
    for known in (case, case.split(": ")[0]):
        for path, (_, names) in pages.items():
            if any(f'"{known}"' in sources[name] for name in names if name != OTHERS):
                return path
    return next(path for path, (_, names) in pages.items() if OTHERS in names)


def written(rows, pages, sources, explained):
    """Path -> new text of each page."""
    shown = {path: [] for path in pages}
    page_by_case = {case: page_of(case, pages, sources) for case in {row[0] for row in rows}}
    for row in rows:
        shown[page_by_case[row[0]]].append(row)
    return {path: with_table(text, shown[path], explained) for path, (text, _) in pages.items()}


def main(arguments):
    if len(arguments) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    rows, folder, tests = map(pathlib.Path, arguments)
    try:
        sources = read_sources(tests)
        explained = headings((folder / "cases.md").read_text(encoding="utf-8"))
        texts = written(read_rows(rows.read_text(encoding="utf-8")), read_pages(folder, sources), sources, explained)
    except (OSError, ValueError) as error:
        print(f"{rows}: {error}", file=sys.stderr)
        return 1
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
