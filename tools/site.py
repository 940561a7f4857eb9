# SPDX-License-Identifier: Apache-2.0
"""Makes the web site of the documentation: docs/ and the keyword reference of the program itself.

    python3 tools/site.py NUGGET SITE

Works in a folder beside SITE, so that nothing generated stands in the source tree: docs/ is copied, a page for each
family of keywords is written from `NUGGET keywords` and `NUGGET keywords NAME`, folders in the navigation of
docs/mkdocs.yml are replaced by their pages, a link to a script that is alone in its line becomes the script, one to the
Python package what its docstrings say, tools/tutorial.py runs the tutorials and makes their pictures, web/screens.mjs takes
those of report.html where there is Chromium, MkDocs builds the site (--strict), and KaTeX is copied into it, so that
formulas need no network. Then every link with a #place is looked up. Exits with 1 where a link leads nowhere, or a
tutorial says what does not happen.
"""
import ast
import concurrent.futures
import html.parser
import inspect
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

import tutorial

ROOT = pathlib.Path(__file__).resolve().parent.parent
KATEX = pathlib.Path("/usr/share/javascript/katex")
KEYWORDS = "manual/keywords"  # folder of the generated pages


def cell(text):
    return text.strip().replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;").replace("_", "\\_")


def anchor(name):
    return name.lower().replace("-", "").replace("*", "")


def read_keywords(listing):
    """(name, verdict, options, note) of each row of `nugget keywords`; columns start where those of the headline do."""
    head, *rows = listing.splitlines()
    starts = [head.index(word) for word in ("keyword", "verdict", "options", "note")]
    for row in rows:
        if row.startswith("*"):
            yield tuple(row[a:b].strip() for a, b in zip(starts, starts[1:] + [None]))


def table(lines):
    """The table of one card or history file: the headline's words say where its columns start."""
    head = lines[0]
    words = re.findall(r"\S+", head)
    starts = [0] + [head.index(word) for word in words[1:]]
    rows = [[line[a:b].strip() for a, b in zip(starts, starts[1:] + [None])] for line in lines]
    out = ["| " + " | ".join(rows[0]) + " |", "|" + "---|" * len(rows[0])]
    for row in rows[1:]:
        row = [cell(value) for value in row]
        row[1] = f"**{row[1].upper() if words[1] == 'field' else row[1]}**"
        out.append("| " + " | ".join(row) + " |")
    return "\n".join(out)


def keyword_section(name, text):
    """One keyword: what the program says of it, cards and the columns of a history file as tables."""
    out = [f"## `{name}` {{: #{anchor(name)} }}"]
    block = []

    def close():
        if block:
            out.append(table(block))
            block.clear()

    for line in text.splitlines()[1:]:
        if line.startswith("  ") and (block or line.split()[0] in ("columns", "branch")):
            block.append(line)
            continue
        close()
        if line.startswith("card "):
            out.append(f"**{cell(line.strip())}**")
        elif line.strip():
            out.append(cell(line.strip()))
    close()
    return "\n\n".join(out)


def write_keyword_pages(nugget, folder):
    folder.mkdir(parents=True)

    def ask(*name):
        return subprocess.run([nugget, "keywords", *name], check=True, capture_output=True, text=True).stdout

    families = {}
    for row in read_keywords(ask()):
        families.setdefault(re.match(r"\*([A-Z0-9]+)", row[0])[1], []).append(row)
    small = {family for family, rows in families.items() if len(rows) < 3}
    pages = {family: rows for family, rows in families.items() if family not in small}
    pages["OTHERS"] = [row for family in sorted(small) for row in families[family]]
    index = ["# Keyword reference",
             "Written by the program itself, `nugget keywords`: reader, checks, messages and these pages use the same "
             "tables. What the verdicts mean: [keywords](../keywords.md).",
             "| family | used | ignored | refused |\n|---|---|---|---|\n"]
    for family, rows in pages.items():
        title = "Other keywords" if family == "OTHERS" else f"*{family}"
        out = [f"# {cell(title)}"]
        if any(row[1] == "used" for row in rows):
            out.append("| used | options | note |\n|---|---|---|\n" + "\n".join(
                f"| [{cell(name)}](#{anchor(name)}) | {cell(options)} | {cell(note)} |"
                for name, verdict, options, note in rows if verdict == "used"))
        if any(row[1] != "used" for row in rows):
            out.append("| not used | verdict | why |\n|---|---|---|\n" + "\n".join(
                f"| {cell(name)} | {verdict} | {cell(note)} |" for name, verdict, _, note in rows if verdict != "used"))
        out += [keyword_section(name, ask(name[1:])) for name, verdict, _, _ in rows if verdict == "used"]
        (folder / f"{family.lower()}.md").write_text("\n\n".join(out) + "\n", encoding="utf-8")
        count = {verdict: sum(row[1] == verdict for row in rows) for verdict in ("used", "ignored", "refused")}
        index[-1] += f"| [{cell(title)}]({family.lower()}.md) | " + " | ".join(map(str, count.values())) + " |\n"
    (folder / "index.md").write_text("\n\n".join(index), encoding="utf-8")


def script_text(path):
    """A script as a block of code, without its licence line."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return "\n".join(["```python", *(line for line in lines if "SPDX-License-Identifier" not in line), "```"])


def prose(text):
    """A docstring as Markdown: signs that it would take for markup are escaped, but for code."""
    def escaped(piece):
        return re.sub(r"([*_])", r"\\\1", piece.replace("<", "&lt;"))
    out = []
    for line in inspect.cleandoc(text).splitlines():
        pieces = re.split(r"(`[^`]*`)", line)
        out.append(line if line.startswith("    ") else
                   "".join(piece if piece.startswith("`") else escaped(piece) for piece in pieces))
    return "\n".join(out)


def signature(function, name):
    arguments = ast.unparse(function.args)
    arguments = re.sub(r"^self(, )?", "", arguments)
    returned = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"{name}({arguments}){returned}"


def class_section(node, lines):
    """A class of the package: what it is, its attributes and methods."""
    out = [f"### nugget.{node.name} {{: #{node.name.lower()} }}", prose(ast.get_docstring(node) or "")]
    for each in node.body:
        if isinstance(each, ast.AnnAssign):
            comment = lines[each.lineno - 1].partition("#:")[2].strip()
            out.append(f"- `{each.target.id}`" + (f": {prose(comment)}" if comment else ""))
        elif isinstance(each, ast.FunctionDef) and ast.get_docstring(each) and \
                (not each.name.startswith("_") or each.name in ("__getitem__", "__setitem__")):
            is_value = any("property" in ast.unparse(decorator) for decorator in each.decorator_list)
            name = f"`{each.name}`" if is_value else f"`{signature(each, each.name)}`"
            out.append(f"- {name}: " + prose(ast.get_docstring(each)).replace("\n", "\n    "))
    return "\n\n".join(out)


def package_reference(package):
    """What a Python package shows: each name of __all__ with what its docstring says."""
    exported = re.search(r"__all__ = (\[.*?\])", (package / "__init__.py").read_text(encoding="utf-8"), re.S)
    sections = {}
    for path in sorted(package.glob("_*.py")):
        text = path.read_text(encoding="utf-8")
        for node in ast.parse(text).body:
            if isinstance(node, ast.ClassDef):
                sections[node.name] = class_section(node, text.splitlines())
            elif isinstance(node, ast.FunctionDef):
                sections[node.name] = "\n\n".join([f"### nugget.{node.name} {{: #{node.name.lower()} }}",
                                                   f"    {signature(node, node.name)}",
                                                   prose(ast.get_docstring(node) or "")])
    names = ast.literal_eval(exported[1])
    return "\n\n".join(sections[name] for name in sorted(names, key=lambda n: (n[0].isupper(), n)) if name in sections)


def with_scripts(text, root):
    """A page in which a link to a script, alone in its line, is that script, and one to a Python package what it shows."""
    def shown(match):
        path = root / match[1]
        return package_reference(path) if (path / "__init__.py").exists() else script_text(path)
    return re.sub(r"(?m)^\[[^\]]*\]\((?:\.\./)+((?:examples|src)/[^)]*)\)$", shown, text)


def run_tutorials(nugget, docs, folder):
    """Runs each page of docs/tutorials in folder/NAME, two at a time, and copies its pictures to where the page has them; what is
    wrong, as text."""
    def run(page):
        command = [sys.executable, ROOT / "tools" / "tutorial.py", page, nugget, folder / page.stem]
        return page, subprocess.run(command, capture_output=True, text=True)

    wrong = []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for page, done in pool.map(run, sorted((docs / "tutorials").glob("*.md"))):
            if done.returncode not in (0, tutorial.LEFT_OUT):
                wrong.append(done.stdout + done.stderr)
            elif done.stdout:
                print(done.stdout.strip())
            for _, of, path in tutorial.read(page)[1]:
                made, shown = folder / of / path, docs / "tutorials" / "img" / of / path
                if of == page.stem and made.is_file():
                    shown.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(made, shown)
    return wrong


def take_screens(folder, pictures):
    """Pictures of the pages that the tutorials left in folder; why there are none, or nothing."""
    node = shutil.which("node")
    if not node or not (ROOT / "web" / "node_modules" / "playwright-core").exists():
        return "no Node, or no packages in web/ (./dev setup)"
    done = subprocess.run([node, ROOT / "web" / "screens.mjs", folder, pictures], capture_output=True, text=True)
    return done.stderr.strip() if done.returncode else ""


def without_missing_pictures(text, page):
    """A page in which a picture that could not be made, alone in its line, is a word about it."""
    def shown(match):
        return match[0] if (page.parent / match[2]).exists() else f"*(Not here: a picture of {match[1]}.)*"
    return re.sub(r"(?m)^!\[([^\]]*)\]\(((?:\.\./tutorials/)?img/[^)]*)\)$", shown, text)


def title(page):
    return next(line[2:].strip() for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("# "))


def with_folders(entry, docs):
    """A navigation in which `folder/` stands for its pages: index.md or README.md first, the others by name."""
    if isinstance(entry, list):
        return [with_folders(each, docs) for each in entry]
    if isinstance(entry, dict):
        return {key: with_folders(value, docs) for key, value in entry.items()}
    if not entry.endswith("/"):
        return entry
    first = ("index.md", "README.md")
    pages = sorted((docs / entry).glob("*.md"), key=lambda page: (page.name not in first, page.name))
    return [{title(page).replace("\\", ""): page.relative_to(docs).as_posix()} for page in pages]


class Links(html.parser.HTMLParser):
    def __init__(self, page):
        super().__init__()
        self.ids, self.links = set(), []
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])


def broken_links(site):
    """Links within the site whose page or place is not there."""
    pages = {page: Links(page) for page in sorted(site.rglob("*.html")) if page.name != "404.html"}
    for page, parsed in pages.items():
        for link in parsed.links:
            path, place = urllib.parse.urldefrag(link)
            if ":" in path.split("/")[0]:
                continue
            target = pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(path))) if path else page
            if target.is_dir():
                target /= "index.html"
            has_place = not place or target not in pages or urllib.parse.unquote(place) in pages[target].ids
            if not target.exists() or not has_place:
                yield f"{page.relative_to(site)}: {link}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    import yaml  # comes with MkDocs; the other functions do not need it

    nugget, site = map(pathlib.Path, arguments)
    work = site.resolve().parent / (site.name + "_source")
    shutil.rmtree(work, ignore_errors=True)
    shutil.rmtree(site, ignore_errors=True)
    shutil.copytree(ROOT / "docs", work / "docs")
    config = yaml.safe_load((work / "docs" / "mkdocs.yml").read_text(encoding="utf-8"))
    (work / "docs" / "mkdocs.yml").unlink()
    write_keyword_pages(nugget.resolve(), work / "docs" / KEYWORDS)
    wrong = run_tutorials(nugget.resolve(), work / "docs", work / "tutorials")
    if wrong:
        print("\n".join(wrong), file=sys.stderr)
        return 1
    lacking = take_screens(work / "tutorials", work / "docs" / "manual" / "img" / "screens")
    if lacking:
        print(f"without pictures of report.html: {lacking}")
    for page in (work / "docs").rglob("*.md"):
        text = with_scripts(page.read_text(encoding="utf-8"), ROOT)
        page.write_text(without_missing_pictures(text, page), encoding="utf-8")
    config["nav"] = with_folders(config["nav"], work / "docs")
    (work / "mkdocs.yml").write_text(yaml.safe_dump(config, allow_unicode=True, sort_keys=False), encoding="utf-8")
    command = ["/usr/bin/mkdocs", "build", "--strict", "--config-file", work / "mkdocs.yml", "--site-dir"]
    build = subprocess.run([*command, site.resolve()], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if build.returncode:
        print("\n".join(line for line in build.stdout.splitlines() if not line.startswith("INFO")), file=sys.stderr)
        return 1
    shutil.copytree(KATEX, site / "katex", symlinks=False)
    broken = list(broken_links(site))
    for line in broken:
        print(f"broken link in {line}", file=sys.stderr)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
