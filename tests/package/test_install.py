# SPDX-License-Identifier: Apache-2.0
"""`cmake --install build`: its files, its demo, and a project elsewhere that uses the deck reader and the model."""
import json
import os
import pathlib
import re
import shutil
import unittest

from installed import BUILD, CMAKE, SHELLS, SOURCE, InstallTest, call

PAGE = (SOURCE / "docs" / "manual" / "install.md").read_text(encoding="utf-8")
PROJECT = "cmake_minimum_required(VERSION 3.24)\nproject(consumer LANGUAGES CXX)\n" + re.search(r"```cmake\n(.*?)```", PAGE, re.S)[1]
COUNT = re.search(r"```cpp\n(.*?)```", PAGE, re.S)[1]
OURS = ("-Werror", "-Wall", "-Wconversion", "-fno-math-errno")
# What the headers need in order to mean the same as in the library: the vectors of the kernels and inline functions.
SHARED = ("-march=", "-mno-fma", "-ffp-contract=off", "++20")


class Install(InstallTest):
    def install(self, *components):
        prefix = self.folder / "prefix"
        for component in components:
            call(CMAKE, "--install", BUILD, "--prefix", prefix, "--component", component)
        return prefix

    def test_runtime(self):
        prefix = self.install("runtime")
        self.looks_installed(prefix)
        for name in ("share/zsh/site-functions/_nugget", "share/doc/nugget/LICENSE"):
            self.assertTrue((prefix / name).is_file(), name)
        self.assertLessEqual({path.name for path in (prefix / "lib").glob("*")}, {"python3"})  # the module of Python, no library
        moved = prefix.rename(self.folder / "moved")  # nothing in it knows where it was put
        self.demo_runs(moved, "results")

    def test_a_program_without_its_examples_says_so(self):
        alone = self.folder / "alone" / "bin"
        alone.mkdir(parents=True)
        shutil.copy(os.environ["NUGGET"], alone / "nugget")
        run = self.bare(alone / "nugget", "demo", expect=1)
        self.assertIn(f"neither in {self.folder}/alone/share/nugget/examples nor in {alone}/examples", run.stderr)
        self.assertIn("cmake --install", run.stderr)
        self.assertEqual(list((self.folder / "work").iterdir()), [])

    def test_demo_where_nothing_can_be_written(self):
        prefix = self.install("runtime")
        (self.folder / "work" / "file").write_text("")
        self.bare(prefix / "bin/nugget", "demo", "-o", "file/results", expect=4)

    def test_the_project_of_the_manual_page(self):
        prefix = self.install("devel")
        project, build = self.folder / "project", self.folder / "project_build"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(PROJECT)
        (project / "count.cpp").write_text(COUNT)
        call(CMAKE, "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release",
             f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
        call(CMAKE, "--build", build)
        [command] = [entry["command"] for entry in json.loads((build / "compile_commands.json").read_text())]
        for option in OURS:
            self.assertNotIn(option, command)
        for option in SHARED:
            self.assertIn(option, command)
        deck = self.folder / "model.k"
        deck.write_text(SHELLS)
        self.assertEqual(call(build / "count", deck).stdout, "3 shells, 0 errors, 0 warnings\n")
        deck.write_text(SHELLS.replace("*ELEMENT_SHELL\n", "*ELEMENT_SHELL\n       9       1       1       2       3      44\n"))
        self.assertRegex(call(build / "count", deck).stdout, r"^\d shells, 1 error")

    def test_its_headers_name_none_of_ours(self):
        """Every header of the prefix finds all that it includes there or in the system."""
        include = self.install("devel") / "include" / "nugget"
        headers = sorted(include.rglob("*.hpp"))
        self.assertGreater(len(headers), 100)
        for header in headers:
            for line in header.read_text().splitlines():
                if line.startswith('#include "'):
                    name = line.split('"')[1]
                    self.assertTrue((include / name).is_file() or (pathlib.Path(header.parent) / name).is_file(), f"{header}: {name}")


if __name__ == "__main__":
    unittest.main()
