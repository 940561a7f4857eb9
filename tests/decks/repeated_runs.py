# SPDX-License-Identifier: Apache-2.0
"""Runs that must leave the same bytes: with any number of threads and lanes, and cut short and gone on with."""
import json
import os
import pathlib
import re

from nugget_command import NUGGET, CommandTest

DATE = re.compile(rb"date \d\d/\d\d/\d{4}")
FOREVER = ("--max-cycles", 10**9)


def lanes_here():
    """Numbers of lanes for which there is a program that runs on this machine."""
    flags = re.search(r"^flags\s*:(.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="ascii"), re.M)[1].split()
    can = all(f"avx512{part}" in flags for part in ("f", "dq", "bw", "cd", "vl"))
    return (4, 8) if can and pathlib.Path(NUGGET).with_name("nugget-avx512").exists() else (4,)


LANES = lanes_here()


def with_lanes(count):
    return {**os.environ, "NUGGET_LANES": str(count)}


class RepeatedRuns(CommandTest):
    def bits(self, folder):
        """{name: bytes} of the results; the only thing that two runs may differ by is the day, if midnight was between."""
        names = [n for n in self.files(folder) if n not in ("run.log", "summary.json", "report.html")]
        return {name: DATE.sub(b"date", (self.folder / folder / name).read_bytes()) for name in names}

    def compare(self, model, *options):
        """The same bits with one, two and three threads, and with every number of lanes that this machine can run."""
        reference = None
        for threads, lanes in ((1, 4), (2, 4), (3, 4), *((2, more) for more in LANES[1:])):
            folder = f"t{threads}" if lanes == 4 else f"t{threads}_{lanes}"
            self.nugget("run", model, "-o", folder, "-j", threads, "--quiet", *options, env=with_lanes(lanes))
            summary = self.json(f"{folder}/summary.json")
            self.assertEqual((summary["threads"], summary["lanes"]), (threads, lanes))
            bits = self.bits(folder)
            reference = reference or bits
            self.assertEqual(sorted(bits), sorted(reference))
            for name, content in bits.items():
                self.assertTrue(content == reference[name], f"{name} differs with {threads} threads and {lanes} lanes")
        return reference

    def results(self, folder):
        """{name: bytes} of all results, without the day and what the clock has measured."""
        found = {}
        for name in self.files(folder):
            if name in ("run.log", "report.html") or name.startswith("restart"):
                continue
            found[name] = DATE.sub(b"date", (self.folder / folder / name).read_bytes())
        summary = json.loads(found["summary.json"])
        for key in ("seconds", "ns_per_element_cycle", "peak_memory_mb", "threads", "lanes"):
            summary.pop(key)
        found["summary.json"] = json.dumps(summary).encode()
        return found

    def same(self, folder, reference):
        ours, theirs = self.results(folder), self.results(reference)
        self.assertEqual(sorted(ours), sorted(theirs))
        for name, content in ours.items():
            if content != theirs[name]:
                at = next((i for i, (a, b) in enumerate(zip(content, theirs[name])) if a != b), len(content))
                self.fail(f"{folder}/{name} differs from byte {at} on:\n{content[max(0, at - 60):at + 60]}\n"
                          f"{theirs[name][max(0, at - 60):at + 60]}")

    def resumed(self, text, *options, shares=(0.1, 0.5, 0.9), until=()):
        """Runs a deck whole, and cut short at shares of its cycles; then goes on, once or twice, with other lanes each time."""
        model = self.write(text) if isinstance(text, str) else text
        self.nugget("run", model, "-o", "whole", "-j", 1, "--quiet", *options)
        cycles = self.json("whole/summary.json")["cycles"]
        self.assertGreater(cycles, 12, "long enough to be cut")
        for share in shares:
            at = max(1, int(share * cycles))
            beyond = at + max(1, (cycles - at) // 3)
            with self.subTest(cycle=at):
                self.nugget("run", model, "-o", "cut", "-j", 1, "--quiet", "--checkpoint", f"{at}cycles",
                            "--max-cycles", min(beyond, 2 * at - 1), *options)
                self.nugget("run", "--resume", "cut", "-j", 2, "--quiet", *FOREVER, env=with_lanes(LANES[0]))
                self.same("cut", "whole")
        at = cycles // 3
        with self.subTest("twice"):
            self.nugget("run", model, "-o", "cut", "-j", 2, "--quiet", "--checkpoint", f"{at}cycles", "--max-cycles",
                        at + 2, *options, env=with_lanes(LANES[0]))
            self.nugget("run", "--resume", "cut", "-j", 1, "--quiet", "--max-cycles", 2 * at + 1)
            self.nugget("run", "--resume", "cut", "-j", 1, "--quiet", *FOREVER, env=with_lanes(LANES[0]))
            self.same("cut", "whole")
            self.assertEqual(self.read("cut/run.log").count("Resumed from a restart file"), 2)
        return self.json("whole/summary.json")
