# SPDX-License-Identifier: Apache-2.0
"""Does what a tutorial tells its reader to do, and sees that the page says what happens.

    python3 tools/tutorial.py PAGE NUGGET FOLDER

PAGE is a page of docs/tutorials; FOLDER, which is emptied first, is where its commands run, one after the other, with the program
NUGGET on PATH and its Python module on PYTHONPATH. A line of a code block is a command where it begins with one of the words below,
else output: it has to stand in what the command before it printed, whole and in order. `…` stands for what differs between
machines, such as seconds, or for what is too long; lines may be left out. A command must end with exit code 0, or with that of a remark
`# exit code 1` at its end. A picture `img/PAGE/x/y.png` is the file x/y.png in FOLDER, and must be there in the end. Under a picture
of another page, `img/OTHER/x/y.png`, as the gallery has them, commands are not run: OTHER.md must have both, picture and commands.

Prints `PAGE:line: what is wrong` for each fault and exits with 1, or with 77 where the page needs the Python module and it was not
built.
"""
import dataclasses
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

WORDS = ("nugget ", "mkdir ", "cp ", "python3 ", "sed ", "cat ")  # with which commands begin
SOURCES = pathlib.Path(__file__).resolve().parent.parent / "examples"
INSTALLED = re.compile(r"/usr/share/nugget/examples/([\w./-]+)")
PICTURE = re.compile(r"!\[[^\]]*\]\(img/([\w-]+)/([^)\s]+)\)")
EXIT_CODE = re.compile(r"# exit code (\d+)$")
NEEDS_MODULE = re.compile(r"^\s*import nugget\b", re.M)


LEFT_OUT = 77  # exit code


@dataclasses.dataclass
class Command:
    line: int
    text: str
    page: str       # whose command it is: this page, or that of the picture above it
    printed: list   # (line, text) of the output that the page shows


def code_lines(text):
    """(number, line) of each line, the line as it stands in its code block, or None where it stands in none."""
    fenced = indented = False
    before = ""
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("```"):
            fenced = not fenced
            yield number, line, None
        elif fenced:
            yield number, line, line
        else:
            indented = line.startswith("    ") and (indented or not before.strip())
            yield number, line, line[4:] if indented else None
        before = line


def read(page):
    """What a page has: commands, pictures as (line, page, path), faults as (line, text)."""
    commands, pictures, faults = [], [], []
    owner = page.stem
    continued = False
    for number, line, code in code_lines(page.read_text(encoding="utf-8")):
        if code is None:
            if line.startswith("#"):
                owner = page.stem
            for picture in PICTURE.finditer(line):
                pictures.append((number, *picture.groups()))
                owner = picture[1]
        elif continued:
            commands[-1].text += "\n" + code
        elif code.startswith(WORDS):
            commands.append(Command(number, code, owner, []))
        elif code.strip():
            if commands:
                commands[-1].printed.append((number, code))
            else:
                faults.append((number, f"output without a command before it: {code.strip()}"))
        continued = code is not None and bool(commands) and not commands[-1].printed and commands[-1].text.endswith("\\")
    return commands, pictures, faults


def stands_in(shown, printed):
    """The first of the shown (line, text) that does not follow in the printed lines; None where all do."""
    lines = iter(printed.splitlines())
    for number, text in shown:
        pattern = re.compile(".*".join(re.escape(part) for part in text.rstrip().split("…")))
        if not any(pattern.fullmatch(line.rstrip()) for line in lines):
            return number, text
    return None


def where_example_is(nugget):
    """Of a path below the installed examples: in the build, where a deck was made there, else in the sources."""
    def replaced(match):
        built = nugget.parent / "examples" / match[1]
        return shlex.quote(str(built if built.exists() else SOURCES / match[1]))
    return replaced


def run(page, nugget, folder):
    """Runs the page's own commands in the folder; its faults as (line, text)."""
    commands, pictures, faults = read(page)
    environment = dict(os.environ, PATH=os.pathsep.join([str(nugget.parent), "/usr/bin", os.environ["PATH"]]),
                       PYTHONPATH=str(nugget.parent / "python"), PYTHONDONTWRITEBYTECODE="1")
    for command in commands:
        if command.page != page.stem:
            continue
        text = INSTALLED.sub(where_example_is(nugget), command.text)
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", text], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
        expected = EXIT_CODE.search(command.text)
        if done.returncode != (int(expected[1]) if expected else 0):
            return faults + [(command.line, f"exit code {done.returncode} of `{command.text}`:\n{done.stdout}")]
        missing = stands_in(command.printed, done.stdout)
        if missing:
            faults.append((missing[0], f"`{command.text}` does not print\n{missing[1]}\nbut\n{done.stdout}"))
    for line, of, path in pictures:
        if of == page.stem and not (folder / path).is_file():
            faults.append((line, f"no command makes the picture {path}"))
    return faults + quoted_faults(page, commands, pictures)


def quoted_faults(page, commands, pictures):
    """What this page says of others and they do not have."""
    faults = []
    for other in sorted({of for _, of, _ in pictures} - {page.stem}):
        path = page.with_name(f"{other}.md")
        theirs, shown, _ = read(path) if path.is_file() else ([], [], [])
        made = {(of, picture) for _, of, picture in shown}
        told = {command.text for command in theirs}
        faults += [(line, f"{path.name} has no picture {picture}") for line, of, picture in pictures
                   if of == other and (of, picture) not in made]
        faults += [(command.line, f"{path.name} has no command `{command.text}`") for command in commands
                   if command.page == other and command.text not in told]
    return faults


def lacks_module(page, nugget):
    """Whether the page imports the Python module, and it was not built."""
    scripts = [SOURCES / match[1] for match in INSTALLED.finditer(page.read_text(encoding="utf-8")) if match[1].endswith(".py")]
    needs = any(NEEDS_MODULE.search(script.read_text(encoding="utf-8")) for script in scripts if script.is_file())
    return needs and not any((nugget.parent / "python" / "nugget").glob("_nugget*.so"))


def main(arguments):
    if len(arguments) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    page, nugget, folder = (pathlib.Path(word).resolve() for word in arguments)
    if lacks_module(page, nugget):
        print(f"{page.name}: left out, the Python module was not built (./dev build python)")
        return LEFT_OUT
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    faults = run(page, nugget, folder)
    for line, text in faults:
        print(f"{page}:{line}: {text}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
