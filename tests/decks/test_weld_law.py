# SPDX-License-Identifier: Apache-2.0
"""Failure functions of the user's own: *DEFINE_FUNCTION and shared libraries (--weld-law), on the lap joint.

Sabotage that this catches: arguments in another order; FVAL read and not obeyed; values of USRV one place off; a memory that restart
files lack; a library of another version taken.
"""
import csv
import io
import math
import subprocess
import unittest

from lap_joint import deck
from nugget_command import SOURCE, CommandTest

PLAIN = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
         "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
LAW = SOURCE / "src" / "model"


def fields(*values):
    return "".join(f"{v:>10}" for v in values) + "\n"


def weld(second, option, fval="", more="", functions=""):
    """The lap joint, pulled hard, with these cards of its weld."""
    cards = ("*MAT_SPOTWELD_DAMAGE-FAILURE\n         3  7.85e-09  210000.0       0.3   50000.0    1000.0\n" + second
             + fields("", option, fval) + more + functions)
    return deck((PLAIN, cards), ("             1.0e-05               500.0\n             1.0e-01               500.0\n",
                                 "             1.0e-06             20000.0\n             1.0e-01             20000.0\n"))


class WeldLaw(CommandTest):
    def run_with(self, *arguments, **options):
        self.write(weld(*arguments, **options))
        return self.result("run", "model.k", "--quiet")

    def result(self, *command):
        self.nugget(*command)
        (row,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        return row

    def library(self, source, name=None):
        path = self.folder / (name or source.stem + ".so")
        compiler = ["cc"] if source.suffix == ".c" else ["c++", "-std=c++17"]
        subprocess.run([*compiler, "-O1", "-shared", "-fPIC", "-I", str(LAW), str(source), "-o", str(path), "-lm"], check=True)
        return path

    def example(self, name):
        return self.library(SOURCE / "examples" / "weld_law" / name)

    RESULTANTS = fields(0.0, 800.0, 600.0, 600.0, 9000.0, 7000.0, 7000.0)
    NO_STRENGTH = fields(0.0)

    def same(self, a, b):
        for column in ("failed", "failure_time", "last_axial", "last_shear", "last_torsion"):
            self.assertEqual(a[column], b[column], column)
        self.assertAlmostEqual(float(a["last_failure"]) / float(b["last_failure"]), 1.0, delta=1e-12)

    def test_a_function_of_the_deck_in_both_manners(self):
        """That of OPT 0, written out, fails the weld in the same cycle; FVAL of OPT 0, 2, 12 and 22."""
        expected = self.run_with(self.RESULTANTS, 0)
        self.assertEqual(expected["failed"], "yes")
        formula = ("f(nrr,nrs,nrt,mrr,mss,mtt)=pow(max(nrr,0.0)/800.0,2)+pow(nrs/600.0,2)+pow(nrt/600.0,2)\n"
                   "  +pow(mrr/9000.0,2)+pow(mss/7000.0,2)+pow(mtt/7000.0,2)\n")
        body = ("float f(float nrr, float nrs, float nrt, float mrr, float mss, float mtt) {\n  float sum = 0.0; /* of squares */\n"
                "  if (nrr > 0.0) sum = nrr*nrr/&nrr2;\n  sum += (nrs*nrs + nrt*nrt)/360000.0;\n"
                "  return sum + mrr*mrr/81000000.0 + (mss*mss + mtt*mtt)/49000000.0;\n}\n")
        parameter = f"*PARAMETER\nR{'nrr2':<9}{640000.0:>10}\n"
        for option, text in ((0, formula), (2, body), (12, formula), (22, body)):
            with self.subTest(option=option):
                found = self.run_with(self.NO_STRENGTH, option, 77, functions=parameter + "*DEFINE_FUNCTION\n" + fields(77) + text)
                self.assertEqual(found["failure_mode"], "user's function")
                self.same(found, expected)

    def test_a_function_that_only_gives_the_value(self):
        found = self.run_with(self.NO_STRENGTH, -1, 77, functions="*DEFINE_FUNCTION\n" + fields(77) + "f(n,s,t)=sqrt(s*s+t*t)/100.0\n")
        self.assertEqual(found["failed"], "no")
        self.assertAlmostEqual(float(found["last_failure"]) / (float(found["last_shear"]) / 100.0), 1.0, delta=1e-9)
        self.assertGreater(float(found["last_failure"]), 1.0)

    def test_all_that_a_function_may_ask_for(self):
        """Rate, diameter, thicknesses, plastic strain, time and USRV behind the resultants; f tells them one by one."""
        names = "a,b,c,d,e,f,rate,dia,t1,t2,strain,time," + ",".join(f"u{i}" for i in range(1, 23))
        second = fields(0.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0)
        more = fields(*(float(i) for i in range(17, 25))) + fields(*(float(i) for i in range(25, 33)))
        for name, value in (("dia", 6.0), ("t1", 1.2), ("t2", 1.2), ("strain", 0.0), ("u1", 11.0), ("u6", 16.0), ("u7", 17.0), ("u22", 32.0)):
            found = self.run_with(second, 22, 77, more=more, functions="*DEFINE_FUNCTION\n" + fields(77) + f"g({names})={name}*1e-3\n")
            self.assertAlmostEqual(float(found["last_failure"]), 1e-3 * value, delta=1e-12, msg=name)
        found = self.run_with(second, 22, 77, more=more, functions="*DEFINE_FUNCTION\n" + fields(77) + f"g({names})=time/1.3e-5\n")
        self.assertEqual(found["failed"], "yes")
        self.assertAlmostEqual(float(found["failure_time"]) / 1.3e-5, 1.0, delta=0.05)

    def test_what_is_wrong_with_a_function_is_told_with_its_place(self):
        for text, told in (("f(a,b)=a+c\n", "'c' is no argument"), ("f(a)={return a;}\n", "a number, a name or '('"),
                           ("float f(float a) {\n  if (a > 1.0) return 2.0;\n}\n", "not every way"), ("f(a)=a**2\n", "write pow(a, b)"),
                           ("f(a)=1/2*a\n", "whole numbers are divided")):
            with self.subTest(text):
                self.write(weld(self.NO_STRENGTH, 2, 77, functions="*DEFINE_FUNCTION\n" + fields(77) + text))
                run = self.nugget("check", "model.k", "-o", "audit", expect=1)
                self.assertIn(told, run.stderr)
                self.assertIn("error: *DEFINE_FUNCTION: function 77 at '", run.stderr)
        for fval, told in ((78, "*DEFINE_FUNCTION 78 is not in the deck"), ("", "OPT 2 is a failure function of the user's own, and none is given")):
            self.write(weld(self.NO_STRENGTH, 2, fval, functions="*DEFINE_FUNCTION\n" + fields(77) + "f(a)=a\n"))
            self.assertIn(told, self.nugget("check", "model.k", "-o", "audit", expect=1).stderr)

    def test_a_library_in_c(self):
        """The ellipse of exponent 2 is OPT 0 without moments."""
        law = self.example("ellipse.c")
        expected = self.run_with(fields(0.0, 800.0, 600.0, 600.0), 0)
        self.write(weld(fields(0.0, 800.0, 600.0, 2.0), 2))
        found = self.result("run", "model.k", "--quiet", "--weld-law", law.name)
        self.assertEqual(found["failure_mode"], "user's function")
        self.same(found, expected)
        self.nugget("check", "model.k", "-o", "audit", "--weld-law", law)

    def test_a_library_in_cpp_that_remembers_goes_on_after_a_restart(self):
        """The integral over the force that welds.csv and swforc tell of; a resumed run has the same bits."""
        law = self.example("duration.cpp")

        def duration(limit):
            self.write(weld(fields(0.0, 300.0, limit), 12).replace("*DATABASE_SWFORC\n  1.00e-06", "*DATABASE_SWFORC\n  1.00e-12"))
            return self.result("run", "model.k", "--quiet", "--weld-law", law)

        found = duration(1.0)
        self.assertEqual(found["failed"], "no")
        total, before = 0.0, 0.0
        for line in self.read("swforc").splitlines():
            if "spotweld beam" in line:
                _, axial, shear, time, *_ = line.split()
                total += max(math.hypot(float(axial), float(shear)) / 300.0 - 1.0, 0.0) * (float(time) - before)
                before = float(time)
        self.assertGreater(total, 0.0)
        self.assertAlmostEqual(float(found["last_failure"]) / total, 1.0, delta=2e-3)
        self.assertEqual(duration(f"{0.5 * total:.3e}")["failure_mode"], "user's function")
        duration(1.0)
        whole = self.read("welds.csv")
        self.nugget("run", "model.k", "--quiet", "--weld-law", law, "-o", "parts", "--max-cycles", 40, "--checkpoint", "30cycles")
        self.nugget("run", "--resume", "parts", "--quiet", "--max-cycles", 100000)
        self.assertEqual(self.read("parts/welds.csv"), whole)

    def test_libraries_that_are_refused(self):
        self.write(weld(fields(0.0, 800.0, 600.0, 2.0), 2))
        source = self.write("int nugget_weld_law_version(void) { return 99; }\ndouble nugget_weld_law(void* a, void* b, double* c) { return 0.0; }\n", "new.c")
        other = self.write("int something(void) { return 1; }\n", "other.c")
        for law, told in ((self.library(source), "version 99 of the interface, expected 1"),
                          (self.library(other), "no function nugget_weld_law_version"), ("absent.so", "the library cannot be opened")):
            run = self.nugget("run", "model.k", "--weld-law", law, expect=1)
            self.assertIn(told, run.stderr)
        self.write(deck())
        self.assertIn("no weld of the deck asks for the library",
                      self.nugget("check", "model.k", "-o", "audit", "--weld-law", self.example("ellipse.c")).stderr)

    def test_opt_9_is_refused_with_the_reason(self):
        for option in (9, -9):
            self.write(weld(self.NO_STRENGTH, option))
            self.assertIn("the formula of its constants is not public", self.nugget("check", "model.k", "-o", "audit", expect=1).stderr)


if __name__ == "__main__":
    unittest.main()
