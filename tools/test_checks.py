# SPDX-License-Identifier: Apache-2.0
"""Breaks a small tree in each way that the checks must catch, and sees that they do."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).parent
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"


class CheckCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def run_check(self, script):
        run = subprocess.run([sys.executable, str(TOOLS / script), str(self.root)], capture_output=True, text=True)
        return run.returncode, run.stdout


class Layers(CheckCase):
    def include(self, room, line):
        self.write(f"src/{room}/a.cpp", LICENCE + "#include <vector>\n" + line + "\n")
        return self.run_check("check_layers.py")

    def test_the_order_of_the_house_passes(self):
        for room, line in [
            ("base", '#include "base/vec3.hpp"'),
            ("deck", '#include "base/card.hpp"'),
            ("kernel", '#include "kernel/law/j2.hpp"'),
            ("reading", '#include "deck/deck.hpp"'),
            ("nvh/eigen", '#include "nvh/matrices/sparse.hpp"'),
            ("reading", '#include "reading/cards/families.hpp"'),
            ("app", '#include "reading/build.hpp"'),
            ("weld", '#include "model/model.hpp"'),
            ("impact", '#include "contact/contact.hpp"'),
            ("impact", '#include "output/recorder.hpp"'),
            ("app", '#include "report/report.hpp"'),
            ("output", "#include <fstream>"),
        ]:
            with self.subTest(room=room, line=line):
                self.assertEqual(self.include(room, line), (0, ""))

    def test_a_breach_is_named_with_file_and_line(self):
        for room, line in [
            ("base", '#include "deck/deck.hpp"'),
            ("deck", '#include "kernel/real.hpp"'),
            ("kernel", '#include "deck/deck.hpp"'),
            ("contact", '#include "output/recorder.hpp"'),
            ("output", '#include "contact/contact.hpp"'),
            ("impact", '#include "nvh/modes.hpp"'),
            ("model", '#include "deck/deck.hpp"'),
            ("impact", '#include "reading/build.hpp"'),
            ("nvh/matrices", '#include "nvh/eigen/modes.hpp"'),
            ("reading/cards", '#include "reading/keywords.hpp"'),
            ("nvh/other", "#include <vector>"),
            ("model", "#include <system/system.hpp>"),
            ("weld", '  #  include "app/main.hpp"'),
            ("system", '#include "../contact/contact.hpp"'),
            ("deck", '#include "deck.hpp"'),
            ("kernel", "#include <iostream>"),
            ("manager", "#include <vector>"),
        ]:
            with self.subTest(room=room, line=line):
                code, output = self.include(room, line)
                self.assertEqual(code, 1, output)
                self.assertRegex(output, rf"^src/{room}/a\.cpp:[13]: ")
                (self.root / f"src/{room}/a.cpp").unlink()

    def test_a_room_that_is_linked_otherwise(self):
        self.write("CMakeLists.txt", "nugget_room(model nugget_deck nugget_kernel)\n")
        code, output = self.run_check("check_layers.py")
        self.assertEqual((code, output.split(": ")[0]), (1, "CMakeLists.txt:1"))

    def test_a_picture_that_is_not_that_of_today(self):
        self.write("CONTRIBUTING.md", "<!-- house: begin (tools/check_layers.py --draw) -->\n<!-- house: end -->\n")
        code, output = self.run_check("check_layers.py")
        self.assertEqual((code, output.split(": ")[0]), (1, "CONTRIBUTING.md:1"))
        drawing = [sys.executable, str(TOOLS / "check_layers.py"), "--draw", str(self.root)]
        subprocess.run(drawing, check=True)
        self.assertEqual(self.run_check("check_layers.py"), (0, ""))


class Sources(CheckCase):
    def test_a_good_tree_passes(self):
        self.write("src/base/a.hpp", LICENCE + "#pragma once\n")
        self.write("src/base/a.cpp", LICENCE + '// see examples/tmp/readme\nauto f = "/dev/full";\n')
        self.write("dev", "#!/usr/bin/env bash\n# SPDX-License-Identifier: Apache-2.0\npython=/usr/bin/python3\n")
        self.assertEqual(self.run_check("check_sources.py"), (0, ""))

    def assert_breach(self, name, text, where):
        self.write(name, text)
        code, output = self.run_check("check_sources.py")
        self.assertEqual(code, 1, output)
        self.assertTrue(output.startswith(where), output)

    def test_a_missing_licence(self):
        self.assert_breach("src/base/a.cpp", "int a;\n", "src/base/a.cpp:1: ")

    def test_a_missing_licence_behind_a_shebang(self):
        self.assert_breach("tools/a.py", "#!/usr/bin/env python3\nimport sys\n", "tools/a.py:2: ")

    def test_an_empty_file(self):
        self.assert_breach("src/base/a.cpp", "", "src/base/a.cpp:1: ")

    def test_a_header_without_pragma_once(self):
        self.assert_breach("src/base/a.hpp", LICENCE + "int a();\n", "src/base/a.hpp:1: ")

    def test_a_path_of_one_machine(self):
        folder = "/" + "home"  # in two pieces, or the check would find it here
        self.assert_breach("tests/a.cpp", LICENCE + f'auto f = "{folder}/me/a.k";\n', "tests/a.cpp:2: ")

    def test_two_types_of_one_name(self):
        """Not specializations, forward declarations, types inside of others, or those that one source has for itself."""
        self.write("src/base/a.hpp", LICENCE + "#pragma once\nnamespace n {\nstruct A;\ntemplate <class T>\nstruct B {};\nclass C {\n  struct D {};\n};\n}\n")
        self.write("src/base/b.cpp", LICENCE + "namespace n {\nnamespace {\nstruct C {};\n}\ntemplate <>\nstruct B<int> {};\nstruct A {};\n"
                                               "struct C::D {};\n}  // struct E {}\nnamespace m { struct C {}; }\n")
        self.assertEqual(self.run_check("check_sources.py"), (0, ""))
        self.assert_breach("src/deck/c.hpp", LICENCE + "#pragma once\nnamespace n {\nenum class C : char {\n  one,\n};\n}\n",
                           "src/deck/c.hpp:4: n::C is another type at src/base/a.hpp:7")

    def test_a_long_file_is_only_named(self):
        self.write("src/base/a.cpp", LICENCE + "\n" * 700)
        code, output = self.run_check("check_sources.py")
        self.assertEqual(code, 0)
        self.assertIn("701 lines", output)

    def test_a_generated_file(self):
        self.write("src/base/a.cpp", LICENCE)
        subprocess.run(["git", "init", "-q", str(self.root)], check=True)
        for name, text in (("--help/tube.k", "*KEYWORD\n"), ("docs/large.svg", "x" * 500_001)):
            with self.subTest(name=name):
                self.write(name, text)
                self.assertEqual(self.run_check("check_sources.py"), (0, ""))  # only what git keeps counts
                subprocess.run(["git", "-C", str(self.root), "add", "--", f"./{name}"], check=True)
                code, output = self.run_check("check_sources.py")
                self.assertEqual(code, 1)
                self.assertIn(f"{name}:1: ", output)
                (self.root / name).unlink()


class Citations(CheckCase):
    def setUp(self):
        super().setUp()
        self.write("docs/theory/shell.md", "# Shells\n\n## C0 triangle: `ELFORM` 4\n\n```\n# no heading\n```\n")
        self.write("docs/decisions/0017-stiffness.md", "# 0017\n")

    def cite(self, name, text):
        self.write(name, text)
        return self.run_check("check_citations.py")

    def test_what_exists_passes(self):
        for name, text in [
            ("src/kernel/a.hpp", LICENCE + "/// See docs/theory/shell.md#c0-triangle-elform-4, docs/decisions/0017.\n"),
            ("tests/unit/a.cpp", LICENCE + "// docs/theory/shell.md. Decks: ../shared/decks\n"),
            ("docs/evidence/a.md", "by `docs/theory/shell.md` and docs/decisions/0017-stiffness.md\n"),
            ("docs/theory/beam.md", "[Shells](shell.md#shells), [here](#beams)\n\n# Beams\n"),
            ("docs/manual/keywords.md", "[Each](keywords/index.md)\n"),
            ("docs/decisions/0018-b.md", "Measured beside ../shared/reference/ecosystem.md.\n"),
        ]:
            with self.subTest(name=name):
                self.assertEqual(self.cite(name, text), (0, ""))

    def test_a_breach_is_named_with_file_and_line(self):
        for name, text in [
            ("src/kernel/a.hpp", LICENCE + "/// See docs/theory/brick.md.\n"),
            ("src/kernel/a.hpp", LICENCE + "/// See docs/theory/shell.md#frame.\n"),
            ("src/kernel/a.hpp", LICENCE + "/// See docs/theory/shell.md#no-heading.\n"),
            ("src/kernel/a.hpp", LICENCE + "/// See docs/decisions/0016.\n"),
            ("src/kernel/a.hpp", LICENCE + "/// ../shared/reference/element-theory.md 3.4\n"),
            ("tests/verify/a.cpp", LICENCE + "// spotweld-theory 4.5\n"),
            ("docs/manual/a.md", "\nas docs/theory/beam.md has it\n"),
            ("docs/theory/a.md", "\n[Frame](shell.md#frame)\n"),
            ("docs/evidence/a.md", "\n[Frame](../theory/shell.md#frame)\n"),
        ]:
            with self.subTest(text=text):
                code, output = self.cite(name, text)
                self.assertEqual(code, 1, output)
                self.assertTrue(output.startswith(f"{name}:2: "), output)
                (self.root / name).unlink()


class Archives(CheckCase):
    """A class that forgets a member, a derived one that forgets all, a pointer that would be kept as bytes."""

    CLASS = """\
class Contact : public Base {
 public:
  explicit Contact(std::vector<int> nodes = {}) : nodes_(std::move(nodes)) {}
  double energy() const { return energy_; }
  void archive(Archive& a);

 private:
  struct Pair {
    int segment = 0;
    Vec3d force;
  };
  struct Block {
    int begin = 0, end = 0;  // of the nodes
    std::vector<Pair> pairs;
    void archive(Archive& a) {
      a(pairs);
      a.built(begin, end);
    }
  };
  static constexpr double margin = 0.25;
  std::vector<int> nodes_;
  const Model& model_;
  std::vector<Block> blocks_;
  std::array<double, 2> energy_{}, work_{};
  unsigned sides_ = 0;
};
"""
    FUNCTION = """\
void Contact::archive(Archive& a) {
  a(blocks_, energy_, work_);
  a.built(nodes_, model_, sides_);
}
"""

    def archives(self, *changes, function=FUNCTION, file="contact.cpp"):
        text = self.CLASS
        for old, new in changes:
            self.assertEqual(text.count(old), 1)
            text = text.replace(old, new)
        self.write("src/contact/contact.hpp", text)
        self.write(f"src/contact/{file}", function)
        return self.run_check("check_archives.py")

    def test_all_members_named(self):
        self.assertEqual(self.archives(), (0, ""))

    def test_a_member_that_is_forgotten(self):
        model = "  const Model& model_;\n"
        for old, new, name in (("  unsigned sides_ = 0;\n", "  unsigned sides_ = 0, count_ = 0;\n", "Contact::count_"),
                               ("    std::vector<Pair> pairs;\n", "    std::vector<Pair> pairs, old;\n", "Contact::Block::old"),
                               (model, model + "  std::map<int, Pair> more_;\n", "Contact::more_"),
                               (model, model + "  double depth_[2] = {0.0, 1.0};\n", "Contact::depth_")):
            with self.subTest(name):
                code, output = self.archives((old, new))
                self.assertEqual(code, 1)
                self.assertIn(f"{name} is not in archive()", output)

    def test_a_function_that_is_only_declared(self):
        code, output = self.archives(function="")
        self.assertEqual(code, 1)
        self.assertIn("Contact::archive is not defined", output)

    def test_a_function_away_from_its_class(self):
        code, output = self.archives(file="archive.cpp")
        self.assertEqual(code, 1)
        self.assertIn("src/contact/archive.cpp:1: Contact::archive is not with its class: it belongs in "
                      "src/contact/contact.cpp", output)

    LIST = """\
class Run {
 public:
  void archive(Archive& a) { each([&](auto& one) { a(one); }); }

 private:
  template <class Visit>
  void each(Visit visit) {
    visit(loads_), visit(walls_);
  }
  std::vector<double> loads_, walls_;
};
"""

    def test_members_that_a_function_lists(self):
        self.write("src/impact/run.hpp", self.LIST)
        self.assertEqual(self.run_check("check_archives.py"), (0, ""))
        self.write("src/impact/run.hpp", self.LIST.replace(", visit(walls_)", ""))
        code, output = self.run_check("check_archives.py")
        self.assertEqual(code, 1)
        self.assertIn("Run::walls_ is not in archive()", output)

    def test_a_derived_class_without_one(self):
        code, output = self.archives(("class Contact :", "class Glue : public Contact {\n  double limit_;\n};\nclass Contact :"))
        self.assertEqual(code, 1)
        self.assertIn("Glue has members, and no archive(Archive&) besides that of Contact", output)

    def test_a_pointer_kept_as_bytes(self):
        for pointer in ("const Segment* on = nullptr;", "std::span<const Row> x;", "Model& model;"):
            with self.subTest(pointer):
                code, output = self.archives(("    Vec3d force;\n", f"    Vec3d force;\n    {pointer}\n"))
                self.assertEqual(code, 1)
                self.assertIn("is kept with Contact::Block::pairs, but is no plain value", output)


class Decisions(CheckCase):
    PAGE = ("# 0001 Title\n\nStatus: accepted · Date: 2026-11-21\n\n## Context\n\na\n\n## Decision\n\nb\n\n"
            "## Not taken\n\nc\n\n## Consequences\n\nd\n")
    INDEX = "# Decisions\n\n| number | title | status | date | what follows |\n|---|---|---|---|---|\n"
    ROW = "| [0001](0001-title.md) | Title | accepted | 2026-11-21 | e |\n"

    def decisions(self, page=PAGE, index=INDEX + ROW, name="0001-title.md"):
        self.write(f"docs/decisions/{name}", page)
        self.write("docs/decisions/README.md", index)
        return self.run_check("check_decisions.py")

    def test_the_form_passes(self):
        self.write("src/base/a.cpp", "// decision 0001\n")
        self.assertEqual(self.decisions(), (0, ""))

    def test_a_page_out_of_form(self):
        for old, new, text in [
            ("# 0001 Title", "# 0001: Title", ":1: expected `# 0001 Title`"),
            ("# 0001 Title", "# 0002 Title", ":1: expected `# 0001 Title`"),
            ("accepted · Date", "taken · Date", ":3: expected `Status: accepted"),
            ("2026-11-21", "21.11.2026", ":3: expected `Status: accepted"),
            ("accepted", "superseded by 0007", ":3: there is no decision 0007"),
            ("## Decision", "## Choice", ":9: expected one of the headings"),
            ("## Decision", "**Decision.**", ":1: has no ## Decision"),
            ("## Not taken", "## Context", ":13: ## Context does not come after ## Decision"),
            ("\nb\n", "\n" + 121 * "b" + "\n", ":11: 121 columns, at most 120"),
            ("\nb\n", "\nDesign decision 6 says so\n", ":11: cites what is not in the repository"),
        ]:
            with self.subTest(new):
                code, output = self.decisions(self.PAGE.replace(old, new, 1))
                self.assertEqual(code, 1)
                self.assertIn(f"docs/decisions/0001-title.md{text}", output)

    def test_an_index_that_does_not_agree(self):
        for old, new, text in [
            (self.ROW, "", ":1: 0001-title.md is missing"),
            (self.ROW, self.ROW + self.ROW, ":6: 0001 stands here twice"),
            (self.ROW, self.ROW + self.ROW.replace("0001", "0002"), ":6: 0002 has no page"),
            ("| Title |", "| Titel |", ":5: title of 0001 is Title"),
            ("| accepted |", "| superseded by 0002 |", ":5: status of 0001 is accepted"),
            ("2026-11-21", "2026-11-22", ":5: date of 0001 is 2026-11-21"),
            ("0001-title.md", "0001-name.md", ":5: file of 0001 is 0001-title.md"),
            (" | e |", "", ":5: expected | [NNNN](file) |"),
        ]:
            with self.subTest(text):
                code, output = self.decisions(index=(self.INDEX + self.ROW).replace(old, new))
                self.assertEqual(code, 1)
                self.assertIn(f"docs/decisions/README.md{text}", output)

    def test_names_numbers_and_mentions(self):
        self.write("tests/a.py", "# docs/decisions/0003\n")
        self.write("docs/decisions/0001-again.md", self.PAGE)
        self.write("docs/decisions/second.md", self.PAGE)
        code, output = self.decisions()
        self.assertEqual(code, 1)
        for text in ("tests/a.py:1: there is no decision 0003", "0001-title.md:1: 0001 is the number of 0001-again.md",
                     "second.md:1: expected a name like"):
            self.assertIn(text, output)


class VerificationTable(CheckCase):
    ROW = "rod on a rigid wall\trod | wall: force [N]\t32481.4\t32494.1\t0.000392\t0.01\n"
    PAGE = "# Page\n<!-- sources: waves -->\n<!-- table: begin -->\nold\n<!-- table: end -->\nafter\n"
    OTHERS = PAGE.replace("waves", "*")

    def fill(self, rows, page=PAGE, others=OTHERS):
        self.write("rows.tsv", rows)
        self.write("pages/page.md", page)
        self.write("pages/others.md", others)
        self.write("pages/cases.md", "# Cases\n### mass scaling of a weld\n### rod on a rigid wall\n")
        self.write("tests/test_waves.cpp", '"rod on a rigid wall" "mass scaling of a weld" "speed"')
        run = subprocess.run([sys.executable, str(TOOLS / "verification_table.py"), str(self.root / "rows.tsv"),
                              str(self.root / "pages"), str(self.root / "tests")], capture_output=True, text=True)
        pages = [(self.root / "pages" / name).read_text(encoding="utf-8") for name in ("page.md", "others.md")]
        return run.returncode, pages, run.stderr

    def test_rows_replace_what_stands_between_the_marks_in_the_order_of_the_cases(self):
        code, (page, _), _ = self.fill("speed\tb\t1\t1\t0\t0.1\n" + self.ROW + "mass scaling of a weld\ta\t1\t1.2\t0.2\t0.1\n")
        self.assertEqual(code, 0)
        self.assertNotIn("old", page)
        self.assertTrue(page.endswith("after\n"))
        self.assertIn("| mass scaling of a weld | a | 1 | 1.2 | **20 %** | 10 % |\n"
                      "| rod on a rigid wall | rod \\| wall: force [N] | 32481.4 | 32494.1 | 0.039 % | 1 % |\n"
                      "| speed | b |", page)

    def test_a_case_that_no_page_names_a_source_of_goes_to_the_page_of_the_others(self):
        code, (page, others), _ = self.fill(self.ROW + "new\tx\t1\t1\t0\t0.1\n")
        self.assertEqual(code, 0)
        self.assertNotIn("| new |", page)
        self.assertIn("| new | x |", others)
        self.assertNotIn("rod on a rigid wall", others)

    def test_broken_input_changes_nothing(self):
        for rows, page, others in [("", self.PAGE, self.OTHERS), ("A-1\ta\t1\n", self.PAGE, self.OTHERS),
                                   ("A-1\ta\tx\t1\t0\t1\n", self.PAGE, self.OTHERS),
                                   (self.ROW, "old <!-- sources: waves -->", self.OTHERS),
                                   (self.ROW, self.PAGE.replace("waves", "gone"), self.OTHERS),
                                   (self.ROW, self.PAGE.replace("<!-- sources: waves -->", ""), self.OTHERS),
                                   (self.ROW, self.PAGE, self.PAGE), (self.ROW, self.OTHERS, self.OTHERS)]:
            code, pages, error = self.fill(rows, page, others)
            self.assertEqual(code, 1, (rows, page))
            self.assertEqual(pages, [page, others])
            self.assertIn("rows.tsv: ", error)


class Talk(CheckCase):
    def setUp(self):
        super().setUp()
        rows = [f"| {n} | words | held | `verify.Weld.Breaks` |" for n in self.numbers()]
        rows[0] = "| 1 | words | background | |"
        self.page = "Of 89 statements: 88 held, 0 partly, 0 open, 1 background.\n\n" + "\n".join(rows) + "\n"
        self.write("tests/verify/test_weld.cpp", "TEST(Weld, Breaks) {}\n")
        self.write("tests/unit/weld/test_tie.cpp", "TEST_F(Tie, Holds) {}\n")
        self.write("tests/decks/test_a.py", "class A:\n    def test_b(self):\n        pass\n")

    @staticmethod
    def numbers():
        extra = {57: ["57b", "57c"], 76: ["76b"], 84: ["84b"]}
        return [n for i in range(1, 87) for n in [str(i), *extra.get(i, [])]] + ["ex"]

    def check(self, *changes):
        text = self.page
        for old, new in changes:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        self.write("docs/verification/talk.md", text)
        return self.run_check("check_talk.py")[1]

    def test_tests_of_all_kinds_are_found(self):
        names = "`verify.Weld.Breaks`, `unit.weld.Tie.Holds` (both), `tests/decks/test_a.py::test_b`"
        self.assertEqual(self.check(("| 2 | words | held | `verify.Weld.Breaks` |", f"| 2 | words | held | {names} |")), "")

    def test_each_breach_is_told_with_its_line(self):
        row, counts = "| 3 | words | held | `verify.Weld.Breaks` |", ("88 held, 0 partly, 0 open", "87 held, 0 partly, 1 open")
        for name in ("verify.Weld.Bends", "unit.tie.Tie.Holds", "tests/decks/test_a.py::test_c"):
            self.assertEqual(self.check((row, f"| 3 | words | held | `{name}` |")),
                             f"docs/verification/talk.md:5: 3: there is no test {name}\n")
        self.assertIn(":5: 3 is held, but by no test", self.check((row, "| 3 | words | held | |")))
        self.assertIn(":5: 3: the verdict is held, partly", self.check((row, row.replace("held", "fine"))))
        self.assertIn(":6: 3 stands here twice", self.check((row, row + "\n" + row)))
        self.assertIn("no row for 3", self.check((row + "\n", "")))
        self.assertIn("expected the sentence `Of 89 statements: 87 held, 0 partly, 1 open", self.check((row, "| 3 | words | open | |")))
        self.assertEqual(self.check((row, "| 3 | words | open | none |"), counts), "")


class Site(CheckCase):
    def tool(self):
        spec = importlib.util.spec_from_file_location("nugget_site", TOOLS / "site.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def test_keywords_become_tables(self):
        site = self.tool()
        listing = ("keyword    verdict  options  note\n"
                   "*ALE_*     refused           not built\n"
                   "*MAT_024   used     _TITLE   \n")
        self.assertEqual(list(site.read_keywords(listing)), [("*ALE_*", "refused", "", "not built"),
                                                             ("*MAT_024", "used", "_TITLE", "")])
        text = ("*MAT_024: used\noptions: _TITLE\n\ncard 1\n"
                "  columns field  kind  default   meaning\n"
                "    1-10  mid    id    required  material | id\n")
        section = site.keyword_section("*MAT_024", text)
        self.assertIn("## `*MAT_024` {: #mat_024 }", section)
        self.assertIn("| columns | field | kind | default | meaning |\n|---|---|---|---|---|\n"
                      "| 1-10 | **MID** | id | required | material \\| id |", section)
        history = site.keyword_section("*DATABASE_DEFORC", "*DATABASE_DEFORC: used\n\ndeforc in binout0000\n"
                                       "  branch  column            dimension  meaning\n"
                                       "  deforc  x_force, y_force  M L T^-2   of a spring\n")
        self.assertIn("deforc in binout0000\n\n| branch | column | dimension | meaning |\n|---|---|---|---|\n"
                      "| deforc | **x\\_force, y\\_force** | M L T^-2 | of a spring |", history)

    def test_a_script_stands_where_its_link_is(self):
        self.write("examples/a.py", '# SPDX-License-Identifier: Apache-2.0\n"""Says hello."""\nprint("hello")\n')
        text = "See [a.py](../../examples/a.py) and\n\n[examples/a.py](../../examples/a.py)\n\nend\n"
        self.assertEqual(self.tool().with_scripts(text, self.root),
                         "See [a.py](../../examples/a.py) and\n\n```python\n\"\"\"Says hello.\"\"\"\nprint(\"hello\")\n```\n\nend\n")

    def test_a_package_is_shown_by_its_docstrings(self):
        self.write("src/p/__init__.py", '__all__ = ["A", "f"]\n')
        self.write("src/p/_p.py", 'class A:\n    """A *thing*, `*PART`."""\n\n    size: int  #: how <large>\n\n'
                   '    @property\n    def name(self) -> str:\n        """Its name."""\n\n'
                   '    def hidden(self): ...\n\n\ndef f(a: int, *, b: str = "") -> None:\n    """Does it."""\n\n\n'
                   'def g():\n    """Not shown."""\n')
        self.assertEqual(self.tool().with_scripts("[p](../src/p)\n", self.root),
                         "### nugget.f {: #f }\n\n    f(a: int, *, b: str='') -> None\n\nDoes it.\n\n"
                         "### nugget.A {: #a }\n\nA \\*thing\\*, `*PART`.\n\n- `size`: how &lt;large>\n\n- `name`: Its name.\n")

    def test_a_folder_in_the_navigation_stands_for_its_pages(self):
        for name, text in [("b/z.md", "# Z\n"), ("b/a.md", "# A\n"), ("b/index.md", "# First\n")]:
            self.write(name, text)
        self.assertEqual(self.tool().with_folders([{"Home": "i.md"}, {"B": "b/"}], self.root),
                         [{"Home": "i.md"}, {"B": [{"First": "b/index.md"}, {"A": "b/a.md"}, {"Z": "b/z.md"}]}])

    def test_links_that_lead_nowhere(self):
        self.write("a.html", '<h2 id="x"></h2><a href="#x"></a><a href="b/c.html#y"></a><a href="https://example.org/#q">')
        self.write("b/c.html", '<h2 id="y"></h2><a href="../a.html#z"></a><a href="gone.html"></a>')
        self.assertEqual(list(self.tool().broken_links(self.root)), ["b/c.html: ../a.html#z", "b/c.html: gone.html"])


if __name__ == "__main__":
    unittest.main()
