# SPDX-License-Identifier: Apache-2.0
"""The version is the same wherever it stands, and a tag on this commit says it, too (RELEASING.md)."""
import datetime
import os
import re
import subprocess
import unittest

from installed import SOURCE


def first(pattern, name):
    match = re.search(pattern, (SOURCE / name).read_text(encoding="utf-8"), re.M)
    return match[1] if match else None


class Release(unittest.TestCase):
    VERSION = first(r"^project\(nugget VERSION (\d+\.\d+\.\d+)", "CMakeLists.txt")

    def test_one_version(self):
        self.assertEqual(subprocess.run([os.environ["NUGGET"], "--version"], capture_output=True, text=True).stdout, f"nugget {self.VERSION}\n")
        self.assertEqual(first(r"^version: (.*)$", "CITATION.cff"), self.VERSION)
        self.assertEqual(first(r"^## (\d+\.\d+\.\d+)", "CHANGELOG.md"), self.VERSION)
        self.assertEqual(first(r"apt install \./nugget_(.*)_amd64\.deb", "README.md"), self.VERSION)
        self.assertEqual(first(r"apt install \./nugget_(.*)_amd64\.deb", "docs/manual/install.md"), self.VERSION)

    def test_a_tag_on_this_commit_is_that_version(self):
        tags = subprocess.run(["git", "-C", str(SOURCE), "tag", "--points-at", "HEAD", "v*"], capture_output=True, text=True).stdout.split()
        self.assertIn(tags, [[], [f"v{self.VERSION}"]])

    def test_citation_has_what_its_format_asks_for(self):
        for key in ("cff-version: 1.2.0", "message: .+", "title: .+", "authors:\n  - "):
            self.assertRegex((SOURCE / "CITATION.cff").read_text(encoding="utf-8"), rf"(?m)^{key}")
        self.assertIn(datetime.date.fromisoformat(first(r"^date-released: (.*)$", "CITATION.cff")).isoformat(),
                      first(r"^## \d\S+ \((.*)\)", "CHANGELOG.md"))


if __name__ == "__main__":
    unittest.main()
