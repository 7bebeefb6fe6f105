#!/usr/bin/env python3
"""Refuses wording that an engineer has to decode: wording.py [FILES...]

Reads comments, messages, test names and pages of the named files, or of all files of the repository. The list is
wording.toml; places that have to stay, such as quotations, are in wording_exceptions.txt, one 'path: text' per line.
Test names have at most 80 characters, lines of pages at most 120 columns. Exit status 1 if something is found.
"""

import pathlib
import re
import subprocess
import sys
import tomllib

import coverage
import markdown

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent
CODE = {".h", ".cpp", ".in", ".v", ".vh", ".js"}
HASHED = {".py", ".sh", ".cmake", ".toml", ".txt"}
MAX_NAME = 80
MAX_COLUMNS = 120
NAME = re.compile(r'TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)')
GENERATED = re.compile(r"<!-- (?:made|measured).*?<!-- (?:end|/measured)", re.DOTALL)
UNBROKEN = re.compile(r"    |\s*(?:\||<|\[?!\[)")  # code, rows of tables, HTML, pictures
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')


def rules():
    """The list: (what finds it at the beginning of a text, what finds it anywhere), each with its advice."""
    rows = tomllib.loads((FOLDER / "wording.toml").read_text(encoding="utf-8"))
    words = [(re.compile(row["pattern"], re.IGNORECASE), row["instead"]) for row in rows["word"]]
    openings = [(re.compile(row["pattern"]), row["instead"]) for row in rows["opening"]]
    return openings, words


def exceptions():
    """Pairs of path and text that may stay."""
    lines = (FOLDER / "wording_exceptions.txt").read_text(encoding="utf-8").splitlines()
    return [tuple(line.split(": ", 1)) for line in lines if line and not line.startswith("#")]


def comment_of(line, mark):
    """The comment at the end of a line, or nothing."""
    found = re.search(rf"(?:^|\s){mark}\s?(.*)$", line)
    return found[1] if found else ""


def code_texts(text):
    """Rows (line number, text, whether it begins a comment) of source files: comments, and strings of several words."""
    before = False
    for number, line in enumerate(text.splitlines(), 1):
        comment = comment_of(line, r"//+<?")
        yield number, comment, bool(comment) and not before
        before = bool(comment) and line.lstrip().startswith("//")
        for literal in LITERAL.findall(line[: len(line) - len(comment)]):
            if literal.count(" ") > 1:
                yield number, literal, False


def hashed_texts(text):
    """The same of files with comments after a hash."""
    for number, line in enumerate(text.splitlines(), 1):
        yield number, comment_of(line, "#+"), False


def page_texts(text):
    """The same of pages in Markdown, without code and generated blocks."""
    for number, line in enumerate(coverage.unmade(None, text).splitlines(), 1):
        yield number, line, False


def texts(path, text):
    """What people read in a file."""
    if path.suffix == ".md":
        return page_texts(text)
    return code_texts(text) if path.suffix in CODE else hashed_texts(text)


def long_parts(path, text):
    """Names of tests, and lines of pages, that are too long."""
    if path.suffix == ".cpp":
        for match in NAME.finditer(text):
            name = "".join(LITERAL.findall(match[1]))
            if len(name) > MAX_NAME:
                yield text.count("\n", 0, match.start()) + 1, f"the test's name has {len(name)} characters; at most {MAX_NAME}"
    if path.suffix == ".md":
        for block in GENERATED.finditer(text):
            text = coverage.blank(text, *block.span())
        for number, line in markdown.prose(text):
            if len(line) > MAX_COLUMNS and " " in line[:MAX_COLUMNS].strip() and not UNBROKEN.match(line):
                yield number, f"the line has {len(line)} columns; at most {MAX_COLUMNS}"


def faults(path, text, openings, words):
    """Rows (line number, what is wrong) of a file."""
    for number, part, begins in texts(path, text):
        for pattern, instead in openings if begins else []:
            if pattern.match(part):
                yield number, f"a comment that begins '{part[:30]}'; {instead}"
        for pattern, instead in words:
            for match in pattern.finditer(part):
                yield number, f"'{match[0]}'; {instead}"
    yield from long_parts(path, text)


def files(arguments):
    """The files to read, relative to the repository."""
    listed = arguments or subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, text=True, capture_output=True).stdout.split("\n")
    for name in listed:
        path = pathlib.Path(name)
        if path.suffix in CODE | HASHED | {".md"} and not name.startswith("tests/docs/wording") and (ROOT / path).is_file():
            yield path


def main(arguments):
    """Prints what is found."""
    openings, words = rules()
    kept = exceptions()
    found = 0
    for path in files(arguments):
        text = (ROOT / path).read_text(encoding="utf-8", errors="replace")
        lines = text.splitlines()
        for number, fault in faults(path, text, openings, words):
            if any(path.as_posix() == place and part in lines[number - 1] for place, part in kept):
                continue
            found += 1
            print(f"{path}:{number}: {fault}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
