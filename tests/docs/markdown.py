"""Parses the parts of Markdown used by the checks: prose, links, headings, tables."""

import os
import re

from runs import ROOT

LINK = re.compile(r"!?\[[^\]]*\]\((?P<to>[^)\s]+)\)|<img src=\"(?P<image>[^\"]+)\"")
FENCE = re.compile(r"^\s*```")
INDENTED = re.compile(r"^ {4,}(?![-*|\d])\S")


def files():
    """The pages of the repository: all Markdown outside of build and hidden folders."""
    found = []
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if not name.startswith((".", "build"))]
        found += [os.path.relpath(os.path.join(folder, name), ROOT) for name in names if name.endswith(".md")]
    return sorted(found)


def pages():
    return [path for path in files() if path == "README.md" or path.startswith("docs/")]


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def slug(heading):
    """The anchor that a forge generates for a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def prose(text):
    """(number, line) of all lines; code and listings are blank."""
    lines, fenced = [], False
    for number, line in enumerate(text.splitlines(), 1):
        if FENCE.match(line):
            fenced = not fenced
            line = ""
        lines.append((number, "" if fenced or INDENTED.match(line) else line))
    return lines


def anchors(text):
    found = {}
    for _, line in prose(text):
        heading = re.match(r"#+ (.*)", line)
        if heading:
            name = slug(heading[1])
            count = found.get(name, 0)
            found[name] = count + 1
            if count:
                found[f"{name}-{count}"] = 1
        for identity in re.findall(r"<a (?:id|name)=\"([^\"]+)\"", line):
            found[identity] = 1
    return set(found)


def links(text):
    """(number, target) of links in prose."""
    for number, line in prose(text):
        for match in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            yield number, match["to"] or match["image"]


def rows(text):
    """(number, cells) of the rows of tables."""
    for number, line in prose(text):
        if line.lstrip().startswith("|"):
            yield number, [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]
