# SPDX-License-Identifier: Apache-2.0
"""Checks that no member is forgotten in the functions that write and read restart files.

    python3 tools/check_archives.py [ROOT]

A class with a function `archive(Archive&)` must name each of its data members in it: handed to the archive where it changes
while the model moves, to `built` where it follows from the deck (src/base/archive.hpp). So must a class derived from one that
has such a function. Members that a function of the class lists for archive() are named too. The function stands with its
class: in the same file, or for NAME.hpp in NAME.cpp beside it. And what goes into the archive byte by byte must not hold a
pointer, a reference or a span.

Prints `file:line: what is wrong` for each breach and exits with 1, or with 0 where there is none. It reads the sources as the
house writes them (clang-format), a declaration a line or more; it is no C++ parser.
"""
import pathlib
import re
import sys

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
CLASS = re.compile(r"\b(?:class|struct)\s+([\w:]+)(?:\s+final)?\s*(?::\s*((?:public\s+)?[\w:<>, ]+))?\s*\{")
ARCHIVE = re.compile(r"\bvoid\s+(?:([\w:]+)(?:<\w+>)?::)?archive\s*\(\s*Archive\s*&\s*\w*\s*\)([^;{]*)(;|\{)")
NOT_DATA = re.compile(r"^\s*(?:using|typedef|friend|static|enum|class|struct|union|template|public|private|protected|"
                      r"namespace|explicit|virtual|constexpr|return|requires|operator|\[\[)\b|^\s*~")


def blanked(text):
    """The text without comments and strings, every line where it was."""
    keep_lines = lambda match: re.sub(r"[^\n]", " ", match[0])
    return STRING.sub(keep_lines, COMMENT.sub(keep_lines, text))


def closing(text, opening):
    """Position behind the brace that closes the one at `opening`."""
    depth = 0
    for i in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i + 1
    return len(text)


class Class:
    def __init__(self, name, bases, place, line, body, scope):
        self.name, self.bases, self.place, self.line, self.scope = name, bases, place, line, scope
        self.whole = body
        self.members = []  # (name, declaration)
        self.archive = None  # text of its function; "" where it is only declared


def members_of(body):
    """(name, declaration) of the data members that the body of a class declares."""
    # Bodies of functions and nested classes are of no interest; initializers in braces stay as `{}`.
    flat, i = [], 0
    while i < len(body):
        if body[i] != "{":
            flat.append(body[i])
            i += 1
            continue
        end = closing(body, i)
        before = "".join(flat).rstrip()
        statement = re.split(r"[;}]|(?:public|private|protected):", before)[-1]
        is_code = re.search(r"\)\s*(?:const|noexcept|override|final|->[^;]*|:[^;]*)*\s*$", statement) or NOT_DATA.match(statement)
        flat.append("};" if is_code else "{}")
        i = end
    members = []
    for statement in re.sub(r"(?:public|private|protected):", ";", "".join(flat)).split(";"):
        statement = statement.replace("}", " ") if statement.strip().startswith("}") else statement
        if not statement.strip() or NOT_DATA.match(statement):
            continue
        # What is in angle brackets or behind `=` declares nothing.
        bare = statement
        while re.search(r"<[^<>]*>", bare):
            bare = re.sub(r"<[^<>]*>", "", bare)
        if re.search(r"\boperator\b", bare) or "(" in re.sub(r"\{\}|=.*", "", bare, flags=re.S):
            continue
        head = re.match(r"\s*((?:const\s+|mutable\s+|(?:un)?signed\s+(?=char|short|int|long))*[\w:]+(?:\s*(?:const|[*&]))*)\s+?(.*)$",
                        re.sub(r"([*&])(?=\w)", r"\1 ", bare), re.S)
        if not head:
            continue
        for one in head[2].split(","):
            name = re.match(r"\s*[*&]?\s*(\w+)\s*(?:=.*|\{\}|\[.*)?\s*$", one, re.S)
            if name:
                members.append((name[1], statement))
    return members


def classes_of(path, place):
    """All classes of a file, nested ones too, by their full name within the file."""
    text = blanked(path.read_text(encoding="utf-8"))
    found = {}

    def look(begin, end, scope):
        at = begin
        while True:
            match = CLASS.search(text, at, end)
            if not match:
                return
            stop = closing(text, match.end() - 1)
            if re.search(r"\benum\s+$", text[:match.start()]):
                at = stop
                continue
            name = "::".join(scope + [match[1]])
            bases = re.findall(r"(\w+)\s*(?:,|$)", (match[2] or "").strip())
            found[name] = Class(name, bases, place, text.count("\n", 0, match.start()) + 1, text[match.end():stop - 1], scope)
            look(match.end(), stop - 1, scope + [match[1]])
            at = stop

    look(0, len(text), [])
    for c in found.values():
        c.members = members_of(c.whole)
        outside = c.whole
        for nested in re.finditer(CLASS, c.whole):  # functions of nested classes are theirs
            outside = outside.replace(c.whole[nested.end():closing(c.whole, nested.end() - 1)], " " * 3)
        inline = ARCHIVE.search(outside)
        if inline:
            c.archive = outside[inline.end():closing(outside, inline.end() - 1)] if inline[3] == "{" else ""
            if "= 0" in inline[2]:
                c.archive, c.members = "pure", []
    return text, found


def listed_by(body, whole):
    """The bodies of those functions in the body `whole` of a class that the text `body` calls, and of those that they call."""
    text, called, new = body, set(), {""}
    while new:
        new = set(re.findall(r"\b(\w+)\s*\(", text)) - called - {"archive", "built", "section"}
        called |= new
        for name in sorted(new):
            for match in re.finditer(rf"\b{name}\s*\([^;{{}}]*\)[^;{{}}()]*\{{", whole):
                text += whole[match.end():closing(whole, match.end() - 1)]
    return text


def pointers(declaration, room, place, scope, classes, seen=()):
    """Members that are no plain values in the classes that a declaration names, as `file:line: Class::member`."""
    found = []
    for part in re.findall(r"\b[A-Z]\w+", declaration):
        plain, around = None, scope.split("::")
        while plain is None and around:
            plain = classes.get((room, place, "::".join(around + [part])))
            around.pop()
        if plain is None:
            named = [c for (r, _, n), c in classes.items() if n == part and r in (room, "kernel", "base")]
            plain = classes.get((room, place, part)) or (named[0] if len(named) == 1 else None)
        if plain is None or plain.archive is not None or plain in seen:
            continue
        for member, how in plain.members:
            if re.search(r"[*&]|\bspan<|unique_ptr|shared_ptr|std::function", how.split("=")[0]):
                found.append(f"{plain.place}:{plain.line}: {part}::{member}")
            else:
                inside = "::".join(plain.scope + [part])
                found += pointers(how.split("=")[0], room, plain.place, inside, classes, (*seen, plain))
    return found


def breaches(root):
    texts, classes = [], {}
    for path in sorted((root / "src").rglob("*")):
        if path.suffix in (".hpp", ".cpp"):
            place = path.relative_to(root).as_posix()
            text, found = classes_of(path, place)
            room = path.relative_to(root / "src").parts[0]
            texts.append((room, place, text))
            for name, c in found.items():
                classes[room, place, name] = c
    if (root / "src/base/archive.hpp").exists():
        classes = {key: c for key, c in classes.items() if key[1] != "src/base/archive.hpp"}

    bodies, places = {}, {}  # (room, class) -> text of its function, and where it is
    for room, place, text in texts:
        for match in ARCHIVE.finditer(text):
            if match[1] and match[3] == "{":
                bodies[room, match[1]] = text[match.end():closing(text, match.end() - 1)]
                places[room, match[1]] = (place, text.count("\n", 0, match.start()) + 1)

    found = []
    bases = {c.name.split("::")[-1] for c in classes.values() if c.archive is not None}
    for (room, place, name), c in classes.items():
        where = f"{place}:{c.line}: {name}"
        derived = [b for b in c.bases if b in bases]
        if c.archive is None:
            # Reading is over before a run begins; its cards share names with what acts in one.
            if derived and c.members and room != "reading":
                found.append(f"{where} has members, and no archive(Archive&) besides that of {derived[0]}")
            continue
        body = c.archive or bodies.get((room, name), "")
        if not body:
            found.append(f"{where}::archive is not defined in src/{room}")
            continue
        if not c.archive and pathlib.PurePath(places[room, name][0]).with_suffix("") != pathlib.PurePath(place).with_suffix(""):
            found.append("{}:{}: ".format(*places[room, name]) + f"{name}::archive is not with its class: "
                         f"it belongs in {pathlib.PurePath(place).with_suffix('.cpp')}")
        body = listed_by(body, c.whole)
        for member, declaration in c.members:
            if not re.search(rf"\b{member}\b", body):
                found.append(f"{where}::{member} is not in archive(): hand it over if it changes while the model moves, "
                             f"else name it in built()")
        kept = re.sub(r"\.built\([^;]*;", "", body)
        for member, declaration in c.members:
            if re.search(rf"\b{member}\b", kept):
                found += [f"{at} is kept with {name}::{member}, but is no plain value: give its class an archive(Archive&)"
                          for at in pointers(declaration, room, place, name, classes)]
    return found


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    found = breaches(root)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
