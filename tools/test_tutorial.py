# SPDX-License-Identifier: Apache-2.0
"""Pages that say what does not happen, and a program that prints a few lines: tools/tutorial.py must see each fault."""
import pathlib
import tempfile
import unittest

import tutorial

PROGRAM = """#!/usr/bin/env bash
case $1 in
  run) echo "  weld  50001 failed at 0.00412"; echo "  peak force    8.02 kN" >&2; echo "  took 3.71 s"; mkdir -p out ;;
  picture) echo drawn >"$2" ;;
  fail) echo "the deck is refused"; exit 1 ;;
esac
"""
PAGE = """# A weld

![a picture](img/page/weld.svg)

    nugget run
      weld  50001 failed at 0.00412
      took … s

Then

    nugget picture weld.svg
"""


class Tutorial(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.nugget = self.folder / "nugget"
        self.nugget.write_text(PROGRAM, encoding="utf-8")
        self.nugget.chmod(0o755)

    def faults(self, text, name="page"):
        page = self.folder / f"{name}.md"
        page.write_text(text, encoding="utf-8")
        work = self.folder / "work"
        work.mkdir(exist_ok=True)
        return tutorial.run(page, self.nugget, work)

    def fault(self, text, name="page"):
        faults = self.faults(text, name)
        self.assertEqual(len(faults), 1, faults)
        return faults[0]

    def test_a_page_that_says_what_happens_passes(self):
        self.assertEqual(self.faults(PAGE), [])
        self.assertTrue((self.folder / "work" / "weld.svg").is_file())

    def test_a_wrong_number_fails(self):
        line, text = self.fault(PAGE.replace("0.00412", "0.00413"))
        self.assertEqual(line, 6)
        self.assertIn("failed at 0.00413\nbut\n", text)

    def test_part_of_a_line_and_lines_out_of_order_fail(self):
        self.assertEqual(self.fault(PAGE.replace("  weld  50001", "weld  50001"))[0], 6)
        swapped = PAGE.replace("      took … s\n", "").replace("    nugget run\n", "    nugget run\n      took … s\n")
        self.assertEqual(self.fault(swapped)[0], 7)

    def test_what_goes_to_standard_error_counts(self):
        self.assertEqual(self.faults(PAGE.replace("      took", "      peak force    8.02 kN\n      took")), [])

    def test_a_missing_picture_fails(self):
        self.assertEqual(self.fault(PAGE.replace("picture weld.svg", "picture other.svg")), (3, "no command makes the picture weld.svg"))

    def test_a_failing_command_ends_it(self):
        line, text = self.fault(PAGE.replace("nugget run", "nugget fail"))
        self.assertEqual(line, 5)
        self.assertIn("exit code 1 of `nugget fail`:\nthe deck is refused", text)
        self.assertFalse((self.folder / "work" / "weld.svg").exists())

    def test_a_command_that_is_meant_to_fail_says_its_exit_code(self):
        self.assertEqual(self.faults("# A\n\n    nugget fail  # exit code 1\n    the deck is refused\n"), [])
        self.assertIn("exit code 1 of", self.fault("# A\n\n    nugget fail  # exit code 3\n")[1])
        self.assertIn("exit code 0 of", self.fault("# A\n\n    nugget run  # exit code 1\n")[1])

    def test_output_needs_a_command(self):
        self.assertEqual(self.fault("# A\n\n    echo hello\n"), (3, "output without a command before it: echo hello"))

    def test_a_fenced_block_and_a_continued_command(self):
        self.assertEqual(self.faults(PAGE.replace("    nugget run\n      weld  50001 failed at 0.00412\n      took … s\n",
                                                  "```\nnugget run \\\n    model.k\n  weld …\n```\n")), [])

    def test_examples_of_the_build_go_before_those_of_the_sources(self):
        deck = self.folder / "examples" / "double_hat" / "double_hat.k"
        deck.parent.mkdir(parents=True)
        deck.write_text("the deck of the build\n", encoding="utf-8")
        self.assertEqual(self.faults("# A\n\n    cat /usr/share/nugget/examples/double_hat/double_hat.k\n    the deck of the build\n"
                                     "    cat /usr/share/nugget/examples/writer.py\n    def field(value, width=10):\n"), [])

    def test_a_gallery_quotes_pictures_and_commands_of_pages(self):
        self.assertEqual(self.faults(PAGE), [])
        gallery = "# Gallery\n\n## Weld\n\n![a weld](img/page/weld.svg)\n\n    nugget picture weld.svg\n"
        self.assertEqual(self.faults(gallery, "gallery"), [])
        self.assertEqual(self.fault(gallery.replace("picture weld", "picture a"), "gallery"), (7, "page.md has no command `nugget picture a.svg`"))
        self.assertEqual(self.fault(gallery.replace("(img/page/weld", "(img/page/a"), "gallery"), (5, "page.md has no picture a.svg"))
        self.assertEqual(len(self.faults(gallery.replace("img/page", "img/nothing"), "gallery")), 2)
        own = gallery + "\n## Own\n\n    nugget fail\n"
        self.assertEqual(self.fault(own, "gallery")[0], 11)

    def test_a_page_of_the_python_module_is_left_out_where_there_is_none(self):
        page = self.folder / "page.md"
        page.write_text("# A\n\n    python3 /usr/share/nugget/examples/double_hat/make.py .\n", encoding="utf-8")
        self.assertFalse(tutorial.lacks_module(page, self.nugget))
        page.write_text("# A\n\n    python3 /usr/share/nugget/examples/python/forces.py model.k .\n", encoding="utf-8")
        package = self.folder / "python" / "nugget"
        package.mkdir(parents=True)
        self.assertTrue(tutorial.lacks_module(page, self.nugget))
        (package / "_nugget.so").touch()
        self.assertFalse(tutorial.lacks_module(page, self.nugget))


if __name__ == "__main__":
    unittest.main()
