# SPDX-License-Identifier: Apache-2.0
"""Proves the recipes of CONTRIBUTING.md: applies a patch that adds something to a copy of the sources, counts what it
touches, builds what that needs and runs the tests that it adds.

    tests/recipes/run.py NAME ... --build BUILD
    tests/recipes/run.py --room ROOM --build BUILD
    tests/recipes/run.py --quote            writes what the patches do to src into CONTRIBUTING.md

NAME is that of a patch beside this file; `RECIPES` says how little of `src` it may touch. Recipes whose tests are in one
room are proved together, in one copy and one build; `--room` takes all of that room. BUILD is a build folder of these
sources (Ninja, tests on) that is up to date. Only what the patch changes, and what includes it, is compiled, with
little optimization; everything else is taken from there. Exits with 0 where the recipe holds, else with 1 and the reason.
"""
import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


@dataclasses.dataclass(frozen=True)
class Recipe:
    """How much of src a patch may touch, and where its tests go."""
    new_files: int      # at most
    changed_files: int  # at most, besides the new ones
    changed_lines: int  # of the changed files together: lines added or removed, at most
    room: str           # tests/unit/<room>
    title: str          # what CONTRIBUTING.md calls it


RECIPES = {
    "keyword_known_data": Recipe(new_files=0, changed_files=1, changed_lines=60, room="reading",
                                 title="A keyword onto data that the model has: one file"),
    "keyword_new_data": Recipe(new_files=0, changed_files=3, changed_lines=60, room="impact",
                               title="A keyword with new data: its card, the data, and what obeys it"),
    "load": Recipe(new_files=1, changed_files=3, changed_lines=60, room="impact",
                   title="A load: its data and its list, one file for how it acts and its include, its card"),
    "history": Recipe(new_files=1, changed_files=1, changed_lines=1, room="impact",
                      title="A history file: one file and one line"),
    "law": Recipe(new_files=1, changed_files=1, changed_lines=2, room="kernel",
                  title="A law, with its card: one file, and its include and its name in the list of laws"),
    "failure_rule": Recipe(new_files=1, changed_files=1, changed_lines=2, room="kernel",
                           title="A failure rule for points of all elements, with its card: the same in the list of rules"),
}


BEGIN, END = "<!-- recipes: begin (tests/recipes/run.py --quote) -->", "<!-- recipes: end -->"


def of_sources(patch: str) -> str:
    """The part of a patch that changes src."""
    pieces = re.split(r"^(?=diff --git )", patch, flags=re.MULTILINE)
    return "".join(p for p in pieces if p.startswith("diff --git a/src/"))


def quotation() -> str:
    """What CONTRIBUTING.md says of all recipes: each patch, as far as it changes src, under its name."""
    text = [BEGIN]
    for name, recipe in RECIPES.items():
        patch = (HERE / f"{name}.patch").read_text()
        lines = [l for l in of_sources(patch).splitlines() if not l.startswith(("diff ", "index ", "new file"))]
        text += ["", f"**{recipe.title}** ([whole patch](tests/recipes/{name}.patch), with its test):", "", "```diff", *lines, "```"]
    return "\n".join([*text, END])


def quoted(page: str) -> str:
    """The page with the quotation of today in its place."""
    before, rest = page.split(BEGIN)
    return before + quotation() + rest.split(END)[1]


def touched(patch: str) -> dict[str, list]:
    """Of each file of a patch: whether it is new, and how many lines are added or removed."""
    files: dict[str, list] = {}
    name = None
    for line in patch.splitlines():
        if line.startswith("--- "):
            is_new = line[4:].strip() == "/dev/null"
        elif line.startswith("+++ "):
            name = line[4:].strip().removeprefix("b/")
            files[name] = [is_new, 0]
        elif name and line[:1] in "+-":
            files[name][1] += 1
    return files


def breaches(recipe: Recipe, files: dict[str, list]) -> list[str]:
    """What a patch does beyond its recipe, and what it lacks."""
    new = [f for f, (is_new, _) in files.items() if f.startswith("src/") and is_new]
    changed = {f: lines for f, (is_new, lines) in files.items() if f.startswith("src/") and not is_new}
    found = []
    if len(new) > recipe.new_files:
        found.append(f"{len(new)} new files in src, the recipe says {recipe.new_files}: {', '.join(new)}")
    if len(changed) > recipe.changed_files:
        found.append(f"{len(changed)} changed files in src, the recipe says {recipe.changed_files}: {', '.join(changed)}")
    if sum(changed.values()) > recipe.changed_lines:
        found.append(f"{sum(changed.values())} lines changed in src, the recipe says {recipe.changed_lines}")
    if not any(f.startswith(f"tests/unit/{recipe.room}/") for f in files):
        found.append(f"no test in tests/unit/{recipe.room}")
    if others := [f for f in files if not f.startswith(("src/", "tests/unit/", "docs/"))]:
        found.append("besides src, tests and docs it touches " + ", ".join(others))
    return found


class Build:
    """The build folder that the recipe starts from, and the copy of the sources that it is tried in."""

    def __init__(self, folder: pathlib.Path, copy: pathlib.Path):
        self.folder, self.copy = folder, copy
        commands = json.loads((folder / "compile_commands.json").read_text())
        self.command_of = {}  # by object, relative to the build folder
        for entry in commands:
            words = shlex.split(entry["command"])
            made = words[words.index("-o") + 1]
            if made.endswith(".o"):  # not what CMake parses once for all
                self.command_of[made] = words

    def sources_of(self) -> dict[str, set[str]]:
        """By object: the files of the sources that it was made from, relative to the root."""
        text = subprocess.run(["ninja", "-C", str(self.folder), "-t", "deps"], capture_output=True, text=True, check=True).stdout
        made_from: dict[str, set[str]] = {}
        for line in text.splitlines():
            if line and not line[0].isspace() and ": #deps" in line:
                current = made_from.setdefault(line.split(": #deps")[0], set())
            elif line.startswith("    "):
                path = pathlib.Path(os.path.normpath(self.folder / line.strip()))
                if path.is_relative_to(ROOT):
                    current.add(str(path.relative_to(ROOT)))
        for made, words in self.command_of.items():  # what an object takes from a precompiled header, it is made from too
            for word, following in zip(words, words[1:]):
                if word == "-include" and made in made_from:
                    header = os.path.relpath(self.folder / f"{following}.gch", self.folder)
                    made_from[made] |= made_from.get(header, set())
        return made_from

    def options_of(self, like: str) -> list[str]:
        """The compiler and the options of an object, for the copy and with little optimization (Eigen needs some)."""
        words = self.command_of[like]
        options, skip = [], 0
        for word, following in zip(words, words[1:] + [""]):
            if skip:
                skip -= 1
            elif word in ("-o", "-c", "-MF", "-MT", "-MQ"):
                skip = 1
            elif word == "-include" and "cmake_pch" in following:
                skip = 1
                options += ["-include", str(self.header_in_copy(following))]
            elif word != "-MD":
                options.append(word.replace(f"-I{ROOT}/", f"-I{self.copy}/"))
        return [*options, "-O1"]

    def source_in_copy(self, made: str) -> pathlib.Path:
        """The source of an object in the copy; of one that CMake makes from several sources, a file that includes them there."""
        source = self.copy / re.sub(r"^.*?\.dir/", "", made).removesuffix(".o")
        if source.parent.name == "Unity":
            together = self.folder / made.removesuffix(".o")
            source = self.copy / made.removesuffix(".o")
            source.parent.mkdir(parents=True, exist_ok=True)
            source.write_text(together.read_text().replace(f"{ROOT}/", f"{self.copy}/"))
        return source

    def header_in_copy(self, header: str) -> pathlib.Path:
        """Where what CMake parses once for all of a target stands for the copy."""
        return self.copy / "parsed" / (self.folder / header).relative_to(self.folder)

    def parse_headers(self, objects: set[str]) -> None:
        """Makes the precompiled headers of these objects from the copy."""
        like = {}  # by header, an object that takes it
        for made in objects:
            words = self.command_of[made]
            like |= {w: made for v, w in zip(words, words[1:]) if v == "-include" and "cmake_pch" in w}

        def parse(header: str) -> None:
            target = self.header_in_copy(header)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text((self.folder / header).read_text().replace(f"{ROOT}/", f"{self.copy}/"))
            empty = target.with_name("empty.cxx")
            empty.write_text("")
            subprocess.run([*self.options_of(like[header]), "-x", "c++-header", "-o", f"{target}.gch", str(empty)],
                           cwd=self.folder, check=True)

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(parse, like))

    def compile(self, like: str, source: pathlib.Path, target: pathlib.Path) -> None:
        """Compiles a source of the copy with the options of the object `like`."""
        target.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(self.options_of(like) + ["-o", str(target), "-c", str(source)], cwd=self.folder, check=True)

    def link(self, program: str, objects: list[pathlib.Path], target: pathlib.Path) -> None:
        """Links `objects` with the libraries of a test program; what they define comes before what the libraries hold."""
        text = subprocess.run(["ninja", "-C", str(self.folder), "-t", "commands", program],
                              capture_output=True, text=True, check=True).stdout
        line = next(l for l in reversed(text.splitlines()) if f"-o tests/{program} " in l)
        words = shlex.split(line.split("&&")[1])
        own = [w for w in words if not w.endswith(".o")]
        where = own.index("-o")
        own[where + 1] = str(target)
        # A function that is inlined here and not there makes the linker take the library's object of the same sources, too.
        subprocess.run(own[:where] + ["-Wl,--allow-multiple-definition"] + [str(o) for o in objects] + own[where:],
                       cwd=self.folder, check=True)

    def rooms_of(self, program: str) -> set[str]:
        """Rooms whose libraries a test program is linked with."""
        text = subprocess.run(["ninja", "-C", str(self.folder), "-t", "commands", program],
                              capture_output=True, text=True, check=True).stdout
        line = next(l for l in reversed(text.splitlines()) if f"-o tests/{program} " in l)
        return set(re.findall(r"libnugget_(\w+)\.a", line))


def prove(names: list[str], folder: pathlib.Path) -> list[str]:
    """Proves recipes of one room together: one copy, one build."""
    recipe, patches = RECIPES[names[0]], [HERE / f"{name}.patch" for name in names]
    files = {}
    for name, patch in zip(names, patches):
        own = touched(patch.read_text())
        if wrong := breaches(RECIPES[name], own):
            return [f"{name}: {w}" for w in wrong]
        files |= own
    whole = "".join(patch.read_text() for patch in patches)
    with tempfile.TemporaryDirectory(prefix="nugget_recipe_") as scratch:
        copy = pathlib.Path(scratch) / "tree"
        for part in ("src", "tests", "docs"):
            shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
        for patch in patches:  # with one line of context: another patch may have written beside it
            applied = subprocess.run(["git", "apply", "-C1", "--whitespace=nowarn", str(patch)], cwd=copy, capture_output=True,
                                     text=True, env={**os.environ, "GIT_CEILING_DIRECTORIES": scratch})
            if applied.returncode:
                return [f"{patch.name} does not fit these sources any more: {applied.stderr.strip()}",
                        "apply it by hand, and put what `git diff` then says into its place"]
        build = Build(folder, copy)
        program = f"test_{recipe.room}"
        rooms = build.rooms_of(program)
        jobs = []  # object to take the options from, source, new object
        for made, sources in build.sources_of().items():
            if sources & files.keys() and made in build.command_of and (m := re.match(r"CMakeFiles/nugget_(\w+)\.dir/", made)):
                if m[1] in rooms:
                    jobs.append((made, build.source_in_copy(made)))
        for file, (is_new, _) in files.items():
            if not file.endswith(".cpp"):
                continue
            if file.startswith("tests/unit/"):
                prefix = f"tests/CMakeFiles/{program}.dir/"
            elif is_new:
                prefix = f"CMakeFiles/nugget_{file.split('/')[1]}.dir/"
            else:
                continue
            jobs.append((next(o for o in build.command_of if o.startswith(prefix)), copy / file))
        objects = [pathlib.Path(scratch) / "objects" / f"{i}.o" for i in range(len(jobs))]
        build.parse_headers({like for like, _ in jobs})
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda i: build.compile(*jobs[i], objects[i]), range(len(jobs))))
        runner = pathlib.Path(scratch) / program
        build.link(program, objects, runner)
        added = re.findall(r"^\+TEST(?:_F|_P)?\((\w+), (\w+)\)", whole, re.MULTILINE)
        if not added:
            return ["the patch adds no test"]
        chosen = ":".join(f"{suite}.{case}" for suite, case in added)
        ran = subprocess.run([str(runner), f"--gtest_filter={chosen}", "--gtest_brief=1"], cwd=scratch)
        print(f"{', '.join(names)}: {len(jobs)} sources compiled, {len(added)} tests run")
        return [] if ran.returncode == 0 else [f"a test of the recipe failed: {chosen}"]


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("names", nargs="*", metavar="NAME", help=", ".join(RECIPES))
    arguments.add_argument("--room")
    arguments.add_argument("--build", type=pathlib.Path)
    arguments.add_argument("--quote", action="store_true")
    given = arguments.parse_args()
    if given.quote:
        page = ROOT / "CONTRIBUTING.md"
        page.write_text(quoted(page.read_text()))
        return 0
    given.names += [name for name, recipe in RECIPES.items() if recipe.room == given.room]
    if not given.names or not given.build:
        arguments.error("give recipes or a room that has some, and --build; or --quote")
    if unknown := [name for name in given.names if name not in RECIPES]:
        arguments.error(f"no such recipe: {', '.join(unknown)}")
    if len({RECIPES[name].room for name in given.names}) > 1:
        arguments.error("recipes of different rooms are proved one by one")
    try:
        wrong = prove(given.names, given.build.resolve())
    except subprocess.CalledProcessError as error:
        wrong = [f"{shlex.join(map(str, error.cmd[-4:]))} ended with {error.returncode}"]
    for line in wrong:
        print(f"recipe {' '.join(given.names)}: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
