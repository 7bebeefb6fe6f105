#!/usr/bin/env python3
"""Static checks of the pages: check.py
links|cells|numbers|pictures|blocks|glossary|lists|tasks|words|shells|machines"""

import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys

import coverage
import manifest
import markdown
import pages
from runs import ROOT

sys.path.insert(0, str(ROOT / "docs/book"))
import order  # pylint: disable=wrong-import-position

CONTENTS = "docs/README.md"  # table of contents and glossary
COMMANDS = "docs/command-line.md"  # table of commands
TASKS, TASKS_SECTION = "docs/view.md", "Three tasks"
KEYS = "docs/settings.md"  # keys of stats, and columns of studies
SHELLS = ("bash", "zsh", "dash", "fish")
NEEDS_BASH = "commands of this page need bash or zsh"
COMMAND = re.compile(r"csgsim |\./setup\.sh|export |[A-Z]+=|cmake |for |job=|printf |env |docs/cluster/")
MOST_COMMANDS = 3
MOST_WORDS = 25
MOST_WORDS_OF_A_TERM = 3  # longer ones are titles of books
MOST_NOT_COVERED = 25  # limit of measured-looking numbers with the reason 'not covered'; only to be lowered


def links():
    """Every relative link leads to an existing file and anchor."""
    for path in markdown.files():
        for number, target in markdown.links(markdown.read(path)):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            place = (ROOT / path).parent / name if name else ROOT / path
            if not place.exists():
                yield f"{path}:{number}: {target} does not exist"
            elif anchor and place.suffix == ".md" and anchor not in markdown.anchors(place.read_text(encoding="utf-8")):
                yield f"{path}:{number}: {target} has no such heading"


def tasks():
    """No task takes more than three commands."""
    section = markdown.read(TASKS).split(f"\n## {TASKS_SECTION}\n")[1].split("\n## ")[0]
    for part in section.split("\n### ")[1:]:
        title, _, body = part.partition("\n")
        commands = re.findall(r"^    csgsim .*", body, re.MULTILINE)
        if not 1 <= len(commands) <= MOST_COMMANDS:
            yield f"{TASKS}: '{title}' takes {len(commands)} commands"


def cells():
    """No cell of a table has too many words."""
    for path in markdown.pages():
        for number, row in markdown.rows(markdown.read(path)):
            for cell in row:
                if len(cell.split()) > MOST_WORDS:
                    yield f"{path}:{number}: a cell of {len(cell.split())} words, more than {MOST_WORDS}: {cell[:60]}..."


def numbers():
    """Every number that looks measured is generated, or allowed for a stated reason."""
    found, made = coverage.survey()
    for each in found:
        if not each.reason:
            yield f"{each.page}:{each.line}: {each.text} looks measured: let docs/manifest make it, or say there why it may stand"
    by_reason = collections.Counter(each.reason.split(":")[0] for each in found)
    print(f"{made} numbers are generated; others that look measured:", dict(by_reason))
    if by_reason["not covered"] > MOST_NOT_COVERED:
        yield f"{by_reason['not covered']} numbers are not covered, more than {MOST_NOT_COVERED}"


def pictures():
    """Every picture has an entry in the manifest, and is shown on a page."""
    listed = {path for page in manifest.read() for entry in page.entries for path in entry.keys.get("files", [])}
    there = {str(path.relative_to(ROOT)) for path in (ROOT / "docs/pictures").rglob("*.*")}
    shown = set()
    for path in markdown.files():
        for _, target in markdown.links(markdown.read(path)):
            shown.add(str(pathlib.Path(ROOT / path).parent.joinpath(target).resolve().relative_to(ROOT)) if "://" not in target else "")
    yield from (f"{path} is in no manifest" for path in sorted(there - listed))
    yield from (f"{path} is in the manifest and not there" for path in sorted(listed - there))
    yield from (f"{path} is shown on no page" for path in sorted(there - shown))


def blocks():
    """Every generated block has an entry in the manifest."""
    named = {(entry.page, entry.keys["name"]) for page in manifest.read() for entry in page.entries if entry.kind == "block"}
    there = {(path, name) for path in markdown.pages() for name in pages.block_names(markdown.read(path))}
    yield from (f"{path}: nothing makes the block '{name}'" for path, name in sorted(there - named))
    yield from (f"{path}: there is no block '{name}'" for path, name in sorted(named - there))


def glossary():
    """Every term in italics in README and the tutorial is in the glossary, which is sorted and links to pages."""
    text = markdown.read(CONTENTS)
    rows = [row for _, row in markdown.rows(text.split("\n## Glossary\n")[1])][2:]
    terms = [row[0] for row in rows]
    known = {name.strip().lower().removesuffix("s") for term in terms for name in term.split(",")}
    if terms != sorted(terms, key=str.lower):
        yield f"{CONTENTS}: the terms are not in order"
    for path in ("README.md", "docs/tutorial.md"):
        for number, line in markdown.prose(markdown.read(path)):
            for term in re.findall(r"(?<!\*)\*([a-zA-Z][\w -]*)\*(?!\*)", line):
                if len(term.split()) <= MOST_WORDS_OF_A_TERM and term.lower().removesuffix("s") not in known:
                    yield f"{path}:{number}: '{term}' is not in the glossary of {CONTENTS}"
    for row in rows:
        if "](" not in row[-1]:
            yield f"{CONTENTS}: '{row[0]}' links to no page"


def command_names():
    def listed(folder, name):
        text = (ROOT / "sim" / folder / "CMakeLists.txt").read_text(encoding="utf-8")
        return re.search(rf"set\({name} ([\w ]+)\)", text)[1].replace("_", "-").split()

    return listed("app", "commands") + listed("studies", "studies") + ["gather"]


def lists():
    """The table of contents follows the order of the book, which lists each page of docs once; the table of commands
    lists each command once."""
    rows = [row for _, row in markdown.rows(markdown.read(CONTENTS).split("\n## All pages\n")[1].split("\n## ")[0])]
    linked = [CONTENTS] + ["docs/" + to for row in rows for to in re.findall(r"\]\(([^)#]*)\)", " ".join(row))]
    listed = [path for _, rows_of_part in order.parts() for path, _, _ in rows_of_part]
    counted = collections.Counter(listed)
    for path in sorted({str(page.relative_to(ROOT)) for page in (ROOT / "docs").rglob("*.md")} | set(listed)):
        if counted[path] != 1 or not (ROOT / path).exists():
            yield f"docs/book/order.toml lists {path} {counted[path]} times, and the page {'exists' if (ROOT / path).exists() else 'does not exist'}"
    if linked != listed:
        yield f"{CONTENTS}: its table of pages differs from docs/book/order.toml; run tests/docs/make.py build/release --page {CONTENTS}"
    commands = markdown.read(COMMANDS).split("\n## Commands\n")[1].split("\n## ")[0]
    named = collections.Counter(name for _, row in markdown.rows(commands) for name in re.findall(r"`([a-z-]+)`", row[0]))
    for name in command_names():
        if named[name] != 1:
            yield f"{COMMANDS}: its table of commands has {name} {named[name]} times"


def keys(value):
    """All keys of a JSON value except names of instructions, purposes, effects, parts and activities."""
    if isinstance(value, list):
        for each in value:
            yield from keys(each)
    elif isinstance(value, dict):
        for key, below in value.items():
            yield key
            if key in ("by_name", "by_purpose", "by_effect"):
                yield from keys(list(below.values()))
            elif key != "parts":
                yield from keys(below)


def words():
    """The table of columns lists each column of a study once, and no other. Each key of stats is in it, elsewhere on
    that page or on a machine's page. No key or option is a spelling variant of a column."""
    section = markdown.read(KEYS).split("\n## Columns of studies\n")[1].split("\n## ")[0]
    described = collections.Counter(name for _, row in markdown.rows(section) for name in re.findall(r"^`(\w+)`$", row[0]))
    studies = (path.read_text(encoding="utf-8") for end in ("h", "cpp") for path in (ROOT / "sim/studies").rglob(f"*.{end}"))
    columns = {name for text in studies for name in re.findall(r'visit\("(\w+)"', text)}
    for name in sorted(columns | set(described)):
        if described[name] != (name in columns):
            yield f"{KEYS}: its table of columns has {name} {described[name]} times, studies {'have' if name in columns else 'lack'} it"

    stats = {key for path in (ROOT / "traces").glob("*.json") for key in keys(json.loads(path.read_text(encoding="utf-8")))}
    texts = "".join(markdown.read(path) for path in markdown.pages() if path == KEYS or "/machines/" in path)
    known = set(re.findall(r"\w+", texts))
    yield from (f"the key {key} of stats is neither in {KEYS} nor on a machine's page" for key in sorted(stats)
                if re.fullmatch(r"\w+", key) and key not in columns | known)
    sources = (path.read_text(encoding="utf-8") for room in ("app", "session", "shell", "studies") for path in (ROOT / "sim" / room).rglob("*.cpp"))
    options = {name for text in sources for name in re.findall(r'option\(\s*"--([a-z-]+[a-z])', text)}
    spelt = {re.sub("[-_]", "", word).removesuffix("s"): word for word in columns}
    for name in sorted(stats | options):
        word = spelt.get(re.sub("[-_]", "", name).removesuffix("s"))
        if word and name.replace("-", "_").removesuffix("s") != word.removesuffix("s"):
            yield f"{name} is a spelling variant of the column {word}"


def command_blocks(text):
    """(line number, text) of indented blocks with commands."""
    lines, found = text.splitlines() + [""], []
    is_code = {number: line.startswith("    ") for number, line in enumerate(lines)}
    for fence in re.finditer(r"^```.*?^```", text, re.MULTILINE | re.DOTALL):
        first = text[: fence.start()].count("\n")
        is_code.update((first + number, False) for number in range(fence[0].count("\n") + 1))
    for number, line in enumerate(lines):
        if is_code[number]:
            if not is_code.get(number - 1):
                found.append((number + 1, []))
            found[-1][1].append(line[4:])
    return [(number, "\n".join(block) + "\n") for number, block in found if any(COMMAND.match(line) for line in block)]


def unread(shell, block):
    """Why a shell cannot read a block; empty if it can, or if the shell is not installed."""
    if not shutil.which(shell):
        return ""
    done = subprocess.run([shell, "--no-execute" if shell == "fish" else "-n"], input=block, text=True, capture_output=True, check=False)
    return done.stderr.strip().splitlines()[0] if done.stderr.strip() else ""


def shells():
    """Commands can be read by bash, zsh, dash and fish, unless the page says that they need bash or zsh. They work
    equally in bash and zsh, which does not split $NAME: lists are arrays. Their scene files exist."""
    for path in markdown.pages():
        text = markdown.read(path)
        names = SHELLS[:2] if NEEDS_BASH in " ".join(text.split()) else SHELLS
        for number, block in command_blocks(text):
            yield from (f"{path}:{number}: {why}" for shell in names if (why := unread(shell, block)))
        lists = set(re.findall(r"""^    ([A-Z]+)=["'][^"'\n]* [^"'\n]*["']$""", text, re.MULTILINE))
        arrays = set(re.findall(r"^    ([A-Z]+)=\(", text, re.MULTILINE))
        for name in re.findall(r"(?<!\")\$([A-Z]+)\b", text):
            if name in lists | arrays:
                yield f'{path}: ${name} is not split in zsh: write {name}=(...), and "${{{name}[@]}}"'
        for scene in re.findall(r"^    csgsim .*--scene (\S+)", text, re.MULTILINE):
            if not (ROOT / scene).exists():
                yield f"{path}: a command names the scene {scene}, which is not there"


def machines():
    """Every stated number of machines equals that of hw/machines, except for those of the eighties, used in studies."""
    count = len(list((ROOT / "hw/machines").glob("*.toml")))
    words_of = "one two three four five six seven eight nine ten eleven twelve".split()
    for path in markdown.pages():
        for number in re.findall(r"\b(?:the|all|on|why) \[?(\w+) machines\b(?! of the (?:eighties|1980s))", " ".join(markdown.read(path).split())):
            if number in words_of and number != words_of[count - 1]:
                yield f"{path}: '{number} machines', and {count} come with csgsim"


CHECKS = {check.__name__: check for check in (links, cells, numbers, pictures, blocks, glossary, lists, tasks, words, shells, machines)}


def main():
    names = sys.argv[1:] or list(CHECKS)
    if any(name not in CHECKS for name in names):
        sys.exit(__doc__)
    wrong = [line for name in names for line in CHECKS[name]()]
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
