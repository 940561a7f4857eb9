# SPDX-License-Identifier: Apache-2.0
"""The package itself: the names that docs/reference/contract.md promises, docstrings, types."""
import inspect
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import nugget
from nugget_command import SOURCE

PACKAGE = pathlib.Path(nugget.__file__).parent


class Package(unittest.TestCase):
    def test_names_of_the_contract(self):
        text = (SOURCE / "docs" / "reference" / "contract.md").read_text(encoding="utf-8")
        promised = re.findall(r"(?m)^    nugget\.([\w.]+)\(([^)]*)\)$", text)
        self.assertGreater(len(promised), 15)
        for name, arguments in promised:
            with self.subTest(name):
                function = nugget
                for part in name.split("."):
                    function = getattr(function, part)
                has = [p for p in inspect.signature(function).parameters if p != "self"]
                self.assertEqual(sorted(has), sorted(a for a in arguments.split(", ") if a))
        functions = {n for n in nugget.__all__ if inspect.isfunction(getattr(nugget, n))}
        self.assertEqual(functions, {name for name, _ in promised if "." not in name})

    def test_all_has_docstrings(self):
        for name in nugget.__all__:
            shown = getattr(nugget, name)
            self.assertTrue(shown.__doc__, name)
            for member, value in vars(shown).items() if inspect.isclass(shown) else ():
                if inspect.isfunction(value) and not member.startswith("_") and not value.__doc__:
                    self.fail(f"{name}.{member} has no docstring")

    def test_types_name_what_is_compiled(self):
        text = (PACKAGE / "_nugget.pyi").read_text(encoding="utf-8")
        told = set(re.findall(r"(?m)^(?:def|class) (\w+)", text)) | set(re.findall(r"(?m)^(\w+): ", text))
        there = {name for name in dir(nugget._nugget) if not name.startswith("__")}
        self.assertEqual(told, there)
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_types_are_sound(self):
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not there")
        ran = subprocess.run(["mypy", "--strict", "--cache-dir=/dev/null", str(PACKAGE)], capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stdout)

    def test_restart_files_are_of_the_program_beside_it(self):
        self.assertTrue((PACKAGE / "_program").exists())
        self.assertNotIn("nugget.plot", sys.modules, "functions are not hidden by modules of their names")


if __name__ == "__main__":
    unittest.main()
