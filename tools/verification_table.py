# SPDX-License-Identifier: Apache-2.0
"""Writes the table of docs/book/verification.md from the rows that the verification tests leave.

    NUGGET_VERIFICATION_ROWS=ROWS test_verify
    python3 tools/verification_table.py ROWS docs/book/verification.md

A row is: case, what, reference, value, error, gate, separated by tabs. Between the page's two marks everything is replaced, in the order
in which docs/verification/cases.md explains the cases. Exits with 1 where there are no rows, a row is broken, or a mark is missing.
"""
import pathlib
import re
import sys

CASES = pathlib.Path(__file__).parent.parent / "docs/verification/cases.md"
BEGIN, END = "<!-- table: begin -->", "<!-- table: end -->"


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
    return f"{before}{BEGIN}\n\n{table(rows, explained)}\n\n{END}{after}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    rows, page = map(pathlib.Path, arguments)
    try:
        explained = headings(CASES.read_text(encoding="utf-8"))
        text = with_table(page.read_text(encoding="utf-8"), read_rows(rows.read_text(encoding="utf-8")), explained)
    except (OSError, ValueError) as error:
        print(f"{rows}: {error}", file=sys.stderr)
        return 1
    page.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
