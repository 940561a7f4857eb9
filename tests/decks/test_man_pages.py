# SPDX-License-Identifier: Apache-2.0
"""Manual pages that the program writes of itself: as many as commands, with every option of --help, and sound to man and mandoc."""
import os
import re
import shutil
import subprocess
import unittest

from nugget_command import SOURCE, CommandTest
from test_completion import option_names


class ManPages(CommandTest):
    def setUp(self):
        super().setUp()
        self.nugget("--man", "man1", env=dict(os.environ, SOURCE_DATE_EPOCH="1700000000"))
        commands = re.findall(r"^  ([a-z]+) ", self.nugget("--help").stdout.split("Subcommands:")[1], re.M)
        self.pages = {"": "man1/nugget.1", **{name: f"man1/nugget-{name}.1" for name in commands}}

    def rendered(self, page):
        run = subprocess.run(["man", "--warnings", "-l", str(self.folder / page)], capture_output=True, text=True,
                             env=dict(os.environ, LC_ALL="C.UTF-8", MANWIDTH="200", MAN_KEEP_FORMATTING="", MANROFFOPT=""))
        self.assertEqual((run.returncode, run.stderr), (0, ""), page)
        return re.sub(r".\x08", "", run.stdout)

    def test_one_for_each_command(self):
        self.assertEqual(self.files("man1"), sorted(page.split("/")[1] for page in self.pages.values()))
        self.assertIn(" 2023-11-14 ", self.read("man1/nugget.1"))  # SOURCE_DATE_EPOCH

    @unittest.skipUnless(shutil.which("man"), "man is not installed")
    def test_options_choices_and_exit_codes(self):
        codes = re.findall(r"^\| (\d+) \|", (SOURCE / "docs/reference/contract.md").read_text(encoding="utf-8"), re.M)
        self.assertEqual(len(codes), 6)
        for command, page in self.pages.items():
            with self.subTest(page=page):
                text = self.rendered(page)
                names = option_names(self.nugget(*[command] * bool(command), "--help").stdout)
                for name in names:
                    self.assertRegex(text, rf"(?<![\w-]){name}(?![\w-])")
                self.assertEqual(re.findall(r"^ +(\d+) ", text.split("EXIT STATUS")[1], re.M), codes)
        self.assertRegex(self.rendered("man1/nugget-welds.1"), "One of: energy; margin; failure")
        self.assertRegex(self.rendered("man1/nugget-run.1"), r"-o, --output FOLDER")

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_mandoc_has_nothing_to_say(self):
        pages = [str(self.folder / page) for page in self.pages.values()]
        run = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", *pages], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (0, ""))

    def test_a_folder_that_cannot_be_written(self):
        self.write("", "file")
        self.nugget("--man", "file/man1", expect=4)


if __name__ == "__main__":
    unittest.main()
