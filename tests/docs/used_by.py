#!/usr/bin/env python3
"""Compares the "Used by" line of each header with the files that include it.

Every folder, .h or .cpp file that the line names, and `tests`, must include the header. Exit status 1 if a line is wrong.
"""

import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.MULTILINE)
USED_BY = re.compile(r"Used by (.*?)\.(?= [A-Z]|$)")
FILE = re.compile(r"[\w/-]+\.(?:cpp|h)(?:\.in)?")
FOLDER = re.compile(r"(?:hw|host|sim)(?:/\w+)*|tests")
LIST = re.compile(r", | and ")


def includers():
    """The files that include each header of the repository."""
    listed = subprocess.run(["git", "ls-files", "*.h", "*.cpp", "*.in"], cwd=ROOT, check=True, text=True, capture_output=True)
    users = collections.defaultdict(set)
    for name in listed.stdout.split():
        if (ROOT / name).is_file():
            for header in INCLUDE.findall((ROOT / name).read_text(encoding="utf-8", errors="replace")):
                users[header].add(name)
    return users


def used_by(text):
    """The names after "Used by" in the comment that begins a header."""
    comment = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        comment.append(line.lstrip("/ "))
    found = USED_BY.search(" ".join(comment))
    return LIST.split(found[1]) if found else []


def named(name, users):
    """The users that a name stands for; None if it is neither a folder nor a file."""
    if FOLDER.fullmatch(name):
        return {user for user in users if user.startswith(name + "/")}
    if FILE.fullmatch(name):
        return {user for user in users if ("/" + user).endswith("/" + name)}
    return None


def faults(text, users):
    """What is wrong with the line of a header."""
    for name in used_by(text):
        files = named(name, users)
        if files is not None and not files:
            yield f"{name} does not include it"


def main():
    """Prints each wrong line."""
    users = includers()
    wrong = 0
    for header in sorted(users):
        if (ROOT / header).is_file():
            for fault in faults((ROOT / header).read_text(encoding="utf-8"), users[header]):
                wrong += 1
                print(f"{header}: Used by: {fault}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
