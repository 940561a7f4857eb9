# SPDX-License-Identifier: Apache-2.0
"""The Debian package: what it says of itself, that it runs from where it is unpacked, whose licences it carries."""
import gzip
import json
import os
import re
import shutil
import subprocess
import unittest

from installed import BUILD, CMAKE, SOURCE, InstallTest, call

CPACK = shutil.which("cpack", path=os.path.dirname(CMAKE)) or "cpack"
NEEDED = ("dpkg-deb", "dpkg-shlibdeps", "ninja")
MISSING = [name for name in NEEDED if not shutil.which(name)]


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Deb(InstallTest):
    @classmethod
    def setUpClass(cls):
        import tempfile
        cls.made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.made.cleanup)
        call(CPACK, "--config", BUILD / "CPackConfig.cmake", "-B", cls.made.name, env=dict(os.environ, SOURCE_DATE_EPOCH="1700000000"))

    def setUp(self):
        super().setUp()
        [self.deb] = [self.folder.__class__(self.made.name, name) for name in os.listdir(self.made.name) if name.endswith(".deb")]
        call("dpkg", "-x", self.deb, self.folder / "root")
        self.usr = self.folder / "root" / "usr"
        self.doc = self.usr / "share" / "doc" / "nugget"

    def field(self, name):
        return call("dpkg-deb", "-f", self.deb, name).stdout.strip()

    def test_control(self):
        version = re.search(r"VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text().split("project(nugget")[1])[1]
        self.assertEqual(self.deb.name, f"nugget_{version}_amd64.deb")
        self.assertEqual([self.field(name) for name in ("Package", "Version", "Architecture", "Section")], ["nugget", version, "amd64", "science"])
        self.assertRegex(self.field("Maintainer"), r"^.+ <.+@.+>$")
        depends = self.field("Depends")
        for library in ("libc6 (>= ", "libfmt9", "libtbb12", "libmumps-seq-5.5", "libmumps-5.5", "libopenblas0"):
            self.assertIn(library, depends)
        self.assertNotIn("-dev", depends)
        self.assertNotIn("python", depends)
        self.assertIn("openmpi-bin", self.field("Suggests"))
        self.assertIn("python3-numpy", self.field("Recommends"))
        for line in self.field("Description").splitlines():
            self.assertLess(len(line), 81)

    def test_runs_from_where_it_is_unpacked(self):
        self.looks_installed(self.usr)
        self.assertTrue((self.usr / "share/zsh/vendor-completions/_nugget").is_file())
        self.demo_runs(self.usr, "results")

    def test_import_nugget(self):
        self.module_runs(self.usr)

    def test_manual_page_is_found(self):
        man = shutil.which("man")
        if not man:
            self.skipTest("man is not installed")
        run = call(man, "-M", self.usr / "share/man", "nugget-welds", env=dict(os.environ, LC_ALL="C.UTF-8", MANPAGER="cat"))
        self.assertIn("rank the welds of a finished run", run.stdout)

    def test_nothing_of_the_build_is_in_it(self):
        for path in self.usr.rglob("*"):
            if path.is_file() and not path.is_symlink():
                self.assertNotIn(str(SOURCE).encode(), path.read_bytes(), path)

    def test_copyright_carries_what_is_compiled_in(self):
        text = (self.doc / "copyright").read_text(encoding="utf-8")
        for name in ("cli11", "nlohmann-json3", "fast-float"):
            self.assertRegex(text, rf"(?m)^Files: programs/{name}$")
        self.assertIn("University of Cincinnati", text)  # CLI11's licence asks for this line
        for name in ("gtest", "eigen3"):  # what only tests include
            self.assertNotIn(f"Files: programs/{name}", text)
        if (BUILD / "viewer.js").is_file():
            for name in ("three", "uplot"):
                licence = (SOURCE / "web" / "node_modules" / name / "LICENSE").read_text(encoding="utf-8")
                for line in filter(None, map(str.strip, licence.splitlines())):
                    self.assertIn(line, text)
            self.assertNotIn("esbuild", text)  # it bundles, and is not in the bundle
        log = gzip.decompress((self.doc / "changelog.gz").read_bytes()).decode()
        self.assertIn("Tue, 14 Nov 2023 22:13:20 +0000", log)  # SOURCE_DATE_EPOCH

    def test_bill_of_materials(self):
        bill = json.loads((self.doc / "nugget.spdx.json").read_text())
        self.assertEqual([bill["spdxVersion"], bill["SPDXID"], bill["dataLicense"]], ["SPDX-2.3", "SPDXRef-DOCUMENT", "CC0-1.0"])
        packages = {package["SPDXID"]: package for package in bill["packages"]}
        self.assertEqual(len(packages), len(bill["packages"]))
        how = {packages[r["relatedSpdxElement"]]["name"]: r["relationshipType"] for r in bill["relationships"]}
        self.assertEqual(set(how), {package["name"] for package in bill["packages"]})
        wanted = {"nugget": "DESCRIBES", "mumps": "DYNAMIC_LINK", "fmtlib": "DYNAMIC_LINK", "cli11": "STATIC_LINK", "nlohmann-json3": "STATIC_LINK"}
        if (BUILD / "viewer.js").is_file():
            wanted |= {"three": "CONTAINS", "uplot": "CONTAINS"}
        self.assertEqual({name: how.get(name) for name in wanted}, wanted)
        # Each library that the programs load belongs to a package of the bill.
        comments = " ".join(package.get("comment", "") for package in packages.values())
        for dependency in self.field("Depends").split(", "):
            self.assertIn(re.sub(r"-?\d*$", "", dependency.split()[0].split("-pthread")[0])[:8], comments)
        page = (SOURCE / "docs" / "manual" / "versions.md").read_text(encoding="utf-8")
        listed = {name for row in re.findall(r"^\| ([a-z][^|]*) \|", page.split("## Licences")[1], re.M) for name in row.split(", ")}
        self.assertLessEqual(set(how) - {"nugget"}, listed)
        licences = {package["name"]: package["licenseDeclared"] for package in packages.values()}
        self.assertEqual([licences[name] for name in ("nugget", "cli11", "mumps")], ["Apache-2.0", "BSD-3-Clause", "CECILL-C"])

    def test_the_same_twice(self):
        again = self.folder / "again"
        call(CPACK, "--config", BUILD / "CPackConfig.cmake", "-B", again, env=dict(os.environ, SOURCE_DATE_EPOCH="1700000000"))
        self.assertEqual((again / self.deb.name).read_bytes(), self.deb.read_bytes())

    def test_lintian_finds_no_error(self):
        if not shutil.which("lintian"):
            self.skipTest("lintian is not installed")
        run = subprocess.run(["lintian", "--fail-on", "error", str(self.deb)], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout)


if __name__ == "__main__":
    unittest.main()
