# SPDX-License-Identifier: Apache-2.0
"""Tests of run.py: which patches are beyond their recipe, and that CONTRIBUTING.md quotes the patches of today."""
import unittest

import run

RECIPE = run.Recipe(new_files=1, changed_files=1, changed_lines=1, room="kernel", title="A law")


def patch(*files):
    """A patch that adds a file (`+name`) or one line to it (`name`)."""
    text = ""
    for name in files:
        bare = name.removeprefix("+")
        text += f"diff --git a/{bare} b/{bare}\n--- {'/dev/null' if name[0] == '+' else 'a/' + bare}\n+++ b/{bare}\n@@ -0,0 +1 @@\n+one\n"
    return text


def breaches(*files):
    return run.breaches(RECIPE, run.touched(patch(*files)))


class Recipes(unittest.TestCase):
    LAW = ("+src/kernel/law/voce.hpp", "src/kernel/law/list.hpp", "+tests/unit/kernel/test_voce.cpp", "docs/manual/laws.md")

    def test_one_file_one_line_a_test_and_a_page_are_a_recipe(self):
        self.assertEqual(breaches(*self.LAW), [])

    def test_a_second_file_is_a_breach(self):
        self.assertIn("2 new files", breaches(*self.LAW, "+src/kernel/law/more.hpp")[0])
        self.assertIn("2 changed files", breaches(*self.LAW, "src/kernel/law/more.hpp")[0])

    def test_a_second_line_is_a_breach(self):
        longer = patch(*self.LAW).replace("b/src/kernel/law/list.hpp\n@@ -0,0 +1 @@\n", "b/src/kernel/law/list.hpp\n@@ -0,0 +1,2 @@\n+zero\n")
        self.assertIn("2 lines changed", run.breaches(RECIPE, run.touched(longer))[0])

    def test_a_patch_without_a_test_is_a_breach(self):
        self.assertIn("no test", breaches(*[f for f in self.LAW if "tests" not in f])[0])

    def test_a_patch_that_edits_the_build_is_a_breach(self):
        self.assertIn("CMakeLists.txt", breaches(*self.LAW, "CMakeLists.txt")[0])

    def test_contributing_quotes_the_patches(self):
        page = (run.ROOT / "CONTRIBUTING.md").read_text()
        self.assertEqual(page, run.quoted(page), "python3 tests/recipes/run.py --quote writes it anew")


if __name__ == "__main__":
    unittest.main()
