# SPDX-License-Identifier: Apache-2.0
"""A processor that lacks what the programs are compiled for: a message that says so, and no illegal instruction."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

NUGGET = pathlib.Path(os.environ["NUGGET"])
QEMU = shutil.which("qemu-x86_64")
ARCH = re.search(r"^NUGGET_ARCH:STRING=(.*)$", pathlib.Path(os.environ["NUGGET_BUILD"], "CMakeCache.txt").read_text(), re.M)[1]


@unittest.skipUnless(QEMU, "qemu-x86_64 is not installed (Debian: qemu-user)")
@unittest.skipUnless(ARCH == "x86-64-v3", f"compiled for {ARCH}")
class Processor(unittest.TestCase):
    def on(self, processor, program="nugget"):
        return subprocess.run([QEMU, "-cpu", processor, NUGGET.with_name(program), "--version"], capture_output=True, text=True, timeout=120)

    def lacks(self, run, arch="x86-64-v3"):
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        message = next(line for line in run.stderr.splitlines() if line.startswith("nugget: "))
        self.assertIn(f"; the program is compiled for {arch}. ", message)
        return re.search(r"lacks (.*?);", message)[1].split(", ")

    def test_without_avx(self):
        for program in ("nugget", "nugget-mpi"):
            self.assertEqual(self.lacks(self.on("qemu64", program)), ["SSE4.2", "AVX", "AVX2", "F16C", "BMI1", "BMI2", "LZCNT", "MOVBE"])
        self.assertEqual(self.lacks(self.on("Nehalem"))[:2], ["AVX", "AVX2"])

    def test_without_one_of_them(self):
        for name, option in (("BMI2", "-bmi2"), ("AVX2", "-avx2"), ("LZCNT", "-abm"), ("MOVBE", "-movbe"), ("F16C", "-f16c")):
            with self.subTest(lacks=name):
                self.assertEqual(self.lacks(self.on(f"max,{option}")), [name])

    def test_program_with_eight_lanes(self):
        if not NUGGET.with_name("nugget-avx512").exists():
            self.skipTest("nugget-avx512 was not built")
        for program in ("nugget-avx512", "nugget-mpi-avx512"):
            self.assertEqual(self.lacks(self.on("Haswell", program), "x86-64-v4"), [f"AVX512{part}" for part in ("F", "DQ", "CD", "BW", "VL")])

    def import_on(self, processor):
        package = pathlib.Path(os.environ["NUGGET_BUILD"], "python")
        if not (package / "nugget").is_dir():
            self.skipTest("no module of Python was built: no pybind11 or no headers of Python")
        return subprocess.run([QEMU, "-cpu", processor, "/usr/bin/python3", "-c", "import nugget; print(nugget.__version__)"], capture_output=True,
                              text=True, timeout=240, env=dict(os.environ, PYTHONPATH=str(package), PYTHONDONTWRITEBYTECODE="1"))

    def test_import_without_avx(self):
        """An ImportError with the same words. Sabotage: the compiled half imported first (signal 4)."""
        run = self.import_on("qemu64")
        self.assertEqual((run.returncode, run.stdout), (1, ""), run.stderr)
        self.assertIn("ImportError: nugget: this processor, or the machine that shows it to us, lacks SSE4.2, AVX, AVX2", run.stderr)
        self.assertIn("the program is compiled for x86-64-v3. Take a newer", run.stderr)

    def test_import_with_all(self):
        run = self.import_on("Haswell")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stdout, r"^\d")

    def test_with_all(self):
        run = self.on("Haswell")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stdout, r"^nugget \d")


if __name__ == "__main__":
    unittest.main()
