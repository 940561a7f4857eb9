# SPDX-License-Identifier: Apache-2.0
"""Whose work is in the program: the copyright file of the Debian package and a bill of materials (SPDX 2.3, JSON).

    python3 packaging/papers.py BUILD copyright | sbom | changelog MAINTAINER

Both are found out and not written down. BUILD (a Ninja build) says which headers each source of the program included, the
programs say which shared libraries they load, dpkg says from which packages these come and what their copyright files say,
and the viewer's bundle says which npm packages went into it. The changelog is Debian's form of "this is version ...". Printed to
standard output, with the time of SOURCE_DATE_EPOCH where it is set.
"""
import datetime
import email.utils
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ("nugget", "nugget-mpi", "nugget-avx512", "nugget-mpi-avx512")
TOOLCHAIN = {"gcc-12", "glibc", "linux", "gcc-defaults", "libxcrypt", "llvm-toolchain-14"}  # runtimes: linked, not carried
SPDX_NAMES = {"Expat": "MIT", "MIT": "MIT", "Apache": "Apache-2.0", "Apache-2": "Apache-2.0", "Apache-2.0": "Apache-2.0",
              "BSD-2-clause": "BSD-2-Clause", "BSD-3-clause": "BSD-3-Clause", "BSD-3-Clause": "BSD-3-Clause",
              "CeCILL-C-V1": "CECILL-C", "GPL-2+": "GPL-2.0-or-later", "GPL-2.0+": "GPL-2.0-or-later", "GPL-3+": "GPL-3.0-or-later",
              "LGPL-2+": "LGPL-2.0-or-later", "LGPL-2.0+": "LGPL-2.0-or-later",
              "LGPL-2.1+": "LGPL-2.1-or-later", "MPL-2": "MPL-2.0", "MPL-2.0": "MPL-2.0", "Zlib": "Zlib", "zlib": "Zlib"}


def run(*command, check=True):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          env=dict(os.environ, LC_ALL="C.UTF-8"))
    if check and done.returncode:
        raise SystemExit(f"papers.py: {' '.join(map(str, command))}: {done.stderr.strip()}")
    return done.stdout


def owners(paths):
    """{path: Debian package that it comes from}; what dpkg does not know (our own files) is left out."""
    found, asked = {}, sorted({name for path in paths for name in (path, path.removeprefix("/usr"))})  # /lib is /usr/lib
    for line in run("dpkg-query", "-S", *asked, check=False).splitlines():
        names, _, path = line.partition(": ")
        if not line.startswith("diversion "):
            found[path] = names.split(",")[0].split(":")[0]
    return found


def headers_of_programs(build):
    """Headers outside the sources that the objects of the programs included."""
    found, ours = set(), False
    for line in run("ninja", "-C", build, "-t", "deps").splitlines():
        if not line.startswith(" "):
            ours = re.match(r"CMakeFiles/nugget[^/]*\.dir/", line) is not None
        elif ours and line.strip().startswith("/usr/"):
            found.add(os.path.realpath(line.strip()))
    return found


def shared_libraries(program):
    """(those that the program itself asks for, all that are loaded with them)"""
    asked = set(re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", program)))
    where = {name: os.path.realpath(path) for name, path in re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", program), re.M)}
    # Those that the program loads by name when it needs them (report/loaded_library.hpp).
    known = dict(re.findall(r"^\s*(\S+) \(libc6,x86-64.*\) => (/\S+)", run("/sbin/ldconfig", "-p"), re.M))
    for source in sorted((ROOT / "src" / "report").glob("*.cpp")):
        for name in re.findall(r'LoadedLibrary library\{"([^"]+)"', source.read_text(encoding="utf-8")):
            asked.add(name)
            where[name] = os.path.realpath(known[name])
            for needed, path in re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", known[name]), re.M):
                where.setdefault(needed, os.path.realpath(path))
    return {where[name] for name in asked if name in where}, set(where.values())


def bundled(build):
    """npm packages of the viewer in report.html, by what esbuild put into it; none where the page is the plain one."""
    listed = build / "viewer.js.inputs.json"
    if not listed.is_file():
        return []
    names = {match[1] for path in json.loads(listed.read_text(encoding="utf-8"))
             if (match := re.search(r"node_modules/((?:@[^/]+/)?[^/]+)/", path))}
    packages = []
    for name in sorted(names):
        folder = ROOT / "web" / "node_modules" / name
        described = json.loads((folder / "package.json").read_text(encoding="utf-8"))
        text = next(path for path in sorted(folder.iterdir()) if re.match(r"licen[cs]e", path.name, re.I))
        packages.append({"name": name, "version": described["version"], "licence": described["license"],
                         "text": text.read_text(encoding="utf-8").strip(), "how": "bundled", "from": "npm"})
    return packages


def licence_of(text):
    """Licence of `Files: *` in a machine-readable copyright file, as SPDX spells it; nothing where it is in words."""
    for stanza in re.split(r"\n\s*\n", text):
        if re.search(r"^Files:\s*\*\s*$", stanza, re.M) and (match := re.search(r"^License:\s*(\S.*)$", stanza, re.M)):
            parts = re.split(r" (or|and) ", match[1].strip().replace(",", ""))
            names = [{"or": "OR", "and": "AND"}.get(part, SPDX_NAMES.get(part)) for part in parts]
            return " ".join(names) if all(names) else None
    return None


def source_of(package):
    """(source package, its version, its home page)"""
    form = "${source:Package}\t${source:Version}\t${Homepage}\n"
    return run("dpkg-query", "-W", f"-f={form}", package).split("\n")[0].split("\t")


def debian_packages(build):
    """A row per Debian source package: linked (a shared library of it is loaded) or compiled in (only its headers are)."""
    asked, loaded = (set().union(*each) for each in zip(*(shared_libraries(build / program) for program in PROGRAMS if (build / program).exists())))
    libraries = owners(asked)
    beside = {source_of(name)[0] for name in owners(loaded).values()} | TOOLCHAIN  # their headers only declare
    headers = owners(headers_of_programs(build))
    site = {"libjs-katex", "mkdocs", "mkdocs-material"} if (build / "site").is_dir() else set()  # of the manual as a web site
    rows = {}
    for how, names in (("linked", set(libraries.values())), ("compiled in", set(headers.values())), ("bundled", site)):
        for name in sorted(names):
            source, version, home = source_of(name)
            if how == "compiled in" and source in beside:
                continue
            row = rows.setdefault(source, {"name": source, "version": version, "home": home, "how": how, "from": "deb",
                                           "packages": []})
            if row["how"] == how:
                row["packages"].append(name)
                text = pathlib.Path("/usr/share/doc", name, "copyright").read_text(encoding="utf-8", errors="replace")
                row["text"], row["licence"] = text.strip(), licence_of(text)
    return [rows[name] for name in sorted(rows)]


def version():
    return re.search(r"project\(nugget VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def indented(text):
    """A text as a field of a copyright file: a space before each line, a point where it is empty."""
    return "\n".join(f" {line}" if line.strip() else " ." for line in text.expandtabs().splitlines())


def copyright_file(build):
    parts = ["Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: nugget\n"
             "Comment:\n"
             " Nugget is distributed under the Apache License 2.0. What is compiled into its programs from the headers of\n"
             " others, or bundled into the page that it writes (report.html), is listed below with its licence. Shared\n"
             " libraries are in packages of their own and have their copyright files there.",
             "Files: *\nCopyright: 2026 the Nugget authors\nLicense: Apache-2.0\n"
             " On Debian systems, the full text of the Apache License version 2.0 can be found in the file\n"
             " /usr/share/common-licenses/Apache-2.0."]
    carried = bundled(build) + [row for row in debian_packages(build) if row["how"] != "linked"]
    for row in carried:
        if row["text"].startswith("Format:"):  # has its own stanzas: it stays whole, as a comment
            owner = sorted(set(re.findall(r"^Copyright:\s*(\S.*)$", row["text"], re.M)))
        else:
            owner = re.findall(r"^\s*(?:Copyright\b.*|\(c\).*)$", row["text"], re.M | re.I)
        owner = [line.strip() for line in owner] or ["see below"]
        what = "report.html" if row["from"] == "npm" else "html" if row["how"] == "bundled" else "programs"
        parts.append(f"Files: {what}/{row['name']}\nCopyright:\n" + "\n".join(f" {line}" for line in owner[:20]) +
                     f"\nLicense: {row['name']}\n" +
                     f" {row['name']} {row['version']}, {row['how']}. Its licence reads:\n .\n" + indented(row["text"]))
    return "\n\n".join(parts) + "\n"


def time_of_package():
    given = os.environ.get("SOURCE_DATE_EPOCH")
    zone = datetime.timezone.utc
    return datetime.datetime.fromtimestamp(int(given), zone) if given else datetime.datetime.now(zone)


def changelog(maintainer):
    return (f"nugget ({version()}) unstable; urgency=medium\n\n  * What is new is told in CHANGELOG.md of the sources.\n\n"
            f" -- {maintainer}  {email.utils.format_datetime(time_of_package())}\n")


def spdx_id(*words):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]+", "-", "-".join(words))


def sbom(build):
    now, release = time_of_package(), version()
    me = spdx_id("Package", "nugget")
    packages = [{"SPDXID": me, "name": "nugget", "versionInfo": release, "downloadLocation": "NOASSERTION",
                 "filesAnalyzed": False, "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0",
                 "copyrightText": "2026 the Nugget authors", "primaryPackagePurpose": "APPLICATION"}]
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": me}]
    for row in bundled(build) + debian_packages(build):
        name = spdx_id("Package", row["from"], row["name"])
        locator = (f"pkg:npm/{row['name'].replace('@', '%40')}@{row['version']}" if row["from"] == "npm" else
                   f"pkg:deb/debian/{row['name']}@{row['version'].replace('+', '%2B').replace(':', '%3A')}?arch=source")
        package = {"SPDXID": name, "name": row["name"], "versionInfo": row["version"],
                   "downloadLocation": row.get("home") or "NOASSERTION", "filesAnalyzed": False,
                   "licenseConcluded": "NOASSERTION", "licenseDeclared": row["licence"] or "NOASSERTION",
                   "copyrightText": "NOASSERTION",
                   "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": locator}]}
        if row.get("packages"):
            package["comment"] = "Debian packages: " + ", ".join(row["packages"])
        packages.append(package)
        relations.append({"spdxElementId": me, "relatedSpdxElement": name,
                          "relationshipType": {"linked": "DYNAMIC_LINK", "compiled in": "STATIC_LINK", "bundled": "CONTAINS"}[row["how"]]})
    return json.dumps({"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"nugget-{release}",
                       "documentNamespace": f"https://nugget.invalid/spdx/nugget-{release}-{now:%Y%m%dT%H%M%SZ}",
                       "creationInfo": {"created": f"{now:%Y-%m-%dT%H:%M:%SZ}", "creators": ["Tool: packaging/papers.py"]},
                       "packages": packages, "relationships": relations}, indent=1) + "\n"


def main(arguments):
    kinds = {"copyright": copyright_file, "sbom": sbom}
    if len(arguments) == 2 and arguments[1] in kinds:
        sys.stdout.write(kinds[arguments[1]](pathlib.Path(arguments[0])))
    elif len(arguments) == 3 and arguments[1] == "changelog":
        sys.stdout.write(changelog(arguments[2]))
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
