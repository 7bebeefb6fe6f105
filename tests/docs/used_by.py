#!/usr/bin/env python3
"""Compares the "Used by" line of each header with the files that include it.

    tests/docs/used_by.py            prints each wrong line; exit status 1 if there is one
    tests/docs/used_by.py --write    rewrites the wrong lines

The line must name every other folder (hw/isa, sim/story) that includes the header, or hw, host or sim as a whole, and
every folder and file that it names must include it.
"""

import collections
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.MULTILINE)
USED_BY = re.compile(r"Used by (.*?)\.(?= [A-Z]|$)")
FILE = re.compile(r"[\w/-]+\.(?:cpp|h)(?:\.in)?")
FOLDER = re.compile(r"(?:hw|host|sim)(?:/\w+)*|tests")
LIST = re.compile(r", and |, | and ")
MOST_FOLDERS = 5  # of hw, host or sim; more are named as a whole


def includers():
    """The files that include each header of the repository."""
    listed = subprocess.run(["git", "ls-files", "*.h", "*.cpp", "*.in"], cwd=ROOT, check=True, text=True, capture_output=True)
    users = collections.defaultdict(set)
    for name in listed.stdout.split():
        if (ROOT / name).is_file():
            for header in INCLUDE.findall((ROOT / name).read_text(encoding="utf-8", errors="replace")):
                users[header].add(name)
    return users


def first_comment(text):
    """The lines of the comment that begins a header, without `//`."""
    comment = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        comment.append(line.lstrip("/ "))
    return comment


def used_by(text):
    """The names after "Used by" in the comment that begins a header; None if it has no such line."""
    found = USED_BY.search(" ".join(first_comment(text)))
    return LIST.split(found[1]) if found else None


def named(name, users):
    """The users that a name stands for; None if it is neither a folder nor a file."""
    if FOLDER.fullmatch(name):
        return {user for user in users if user.startswith(name + "/")}
    if FILE.fullmatch(name):
        return {user for user in users if ("/" + user).endswith("/" + name)}
    return None


def folder_of(file):
    return "/".join(file.split("/")[:2])


def other_folders(header, users):
    """The folders of hw, host and sim that include a header, apart from its own."""
    return {folder_of(user) for user in users if not user.startswith("tests/")} - {folder_of(header)}


def faults(header, names, users):
    """What is wrong with the names in the line of a header."""
    seen = set()
    for name in names:
        files = named(name, users)
        if files is not None and not files:
            yield f"{name} does not include it"
        seen |= {folder_of(user) for user in files or ()}
    for missing in sorted(other_folders(header, users) - seen):
        yield f"{missing} includes it"


def names_of(header, users):
    """The names for a header's line: its users in other folders, or in its own if there are no others."""
    folders = other_folders(header, users)
    names = []
    for top in ("hw", "host", "sim"):
        inside = sorted(folder for folder in folders if folder.startswith(top + "/"))
        names += [top] if len(inside) > MOST_FOLDERS else inside
    return names or [folder_of(header) if any(not user.startswith("tests/") for user in users) else "tests"]


def rewritten(text, names):
    """The header with these names in its line."""
    old = first_comment(text)
    first = next(i for i, line in enumerate(old) if "Used by" in line)
    last = next((i for i in range(first, len(old)) if not old[i]), len(old))
    listed = names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]
    paragraph = USED_BY.sub(lambda _: f"Used by {listed}.", " ".join(old[first:last]), count=1)
    lines = textwrap.wrap(paragraph, 117, break_long_words=False, break_on_hyphens=False)
    rest = text.splitlines()
    return "\n".join(rest[:first] + [f"// {line}" for line in lines] + rest[last:]) + "\n"


def main():
    users = includers()
    wrong = 0
    for header in sorted(users):
        path = ROOT / header
        names = used_by(path.read_text(encoding="utf-8")) if path.is_file() else None
        found = list(faults(header, names, users[header])) if names else []
        if found and "--write" in sys.argv[1:]:
            path.write_text(rewritten(path.read_text(encoding="utf-8"), names_of(header, users[header])), encoding="utf-8")
            continue
        for fault in found:
            wrong += 1
            print(f"{header}: Used by: {fault}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
