# SPDX-License-Identifier: Apache-2.0
"""Tests of build_progress.py."""
import io
import unittest

import build_progress


def shown(text: str, terminal: bool = False) -> str:
    out = io.StringIO()
    build_progress.main(io.StringIO(text), out, terminal)
    return out.getvalue()


class BuildProgress(unittest.TestCase):
    def test_time_left_is_that_of_the_steps_left_at_the_pace_so_far(self):
        self.assertEqual(build_progress.progress(25, 100, 60.0),
                         "building: 25 of 100 steps, 1 min 0 s so far, about 3 min 0 s left")

    def test_a_log_gets_a_line_every_thirty_seconds(self):
        steps = "".join(f"[{n}/100 {n}.0] Building {n}.o\n" for n in range(1, 101))
        self.assertEqual(shown(steps).splitlines(),
                         ["building: 30 of 100 steps, 30 s so far, about 1 min 10 s left",
                          "building: 60 of 100 steps, 1 min 0 s so far, about 40 s left",
                          "building: 90 of 100 steps, 1 min 30 s so far, about 10 s left"])

    def test_errors_go_through_whole(self):
        error = "FAILED: a.o\ng++ -c a.cpp\na.cpp:3:1: error: expected ';'\n"
        self.assertEqual(shown("[1/2 0.5] Building a.o\n" + error), error)
        self.assertTrue(shown("[1/2 0.5] Building a.o\n" + error, terminal=True).endswith(error))

    def test_the_terminal_is_left_clean(self):
        self.assertTrue(shown("[1/1 0.5] Linking nugget\n", terminal=True).endswith("\r\x1b[K"))


if __name__ == "__main__":
    unittest.main()
