"""Finds numbers on the pages that look measured but are not generated."""

import re
from dataclasses import dataclass

import manifest
import markdown
import pages

UNITS = (r"clocks?|ms|µs|ns|s|seconds|kB|MB|MiB|GB|fps|%|times|frames a second|transistors|half-spaces|pixels differ|"
         r"instructions|words of")
MEASURED = re.compile(rf"(?<![\w.,/^])(?:[0-9]{{1,3}}(?:,[0-9]{{3}})+(?:\.[0-9]+)?|[0-9]{{4,}}(?:\.[0-9]+)?|"
                      rf"[0-9]+(?:[.,][0-9]+)?(?=\s(?:{UNITS})(?!\w)))(?![\w])")
YEAR = re.compile(r"(1[5-9]|20)[0-9]{2}(\.[0-9]{2})?")  # years, and releases of OpenSCAD


@dataclass
class Number:
    """A number that looks measured; `reason` says why it is allowed, or is empty."""

    page: str
    line: int
    text: str
    reason: str = ""


def blank(text, begin, end):
    """The text with a span replaced by spaces, keeping the lines."""
    return text[:begin] + re.sub(r"[^\n]", " ", text[begin:end]) + text[end:]


def unmade(page, text):
    """The page without generated content, code, names in code, and addresses."""
    for match in reversed(list(pages.BLOCK.finditer(text))):
        text = blank(text, *match.span())
    made = []
    for entry in page.entries if page else ():
        if entry.kind == "sentence":
            for words in entry.keys.get("words", []):
                made += pages.places(text, words)
        elif entry.kind == "script":
            for begin in entry.keys["begin"]:
                made.append(pages.part_span(text, begin, entry.keys["end"]))
    for span in made:
        text = blank(text, *span)
    text = "\n".join(line for _, line in markdown.prose(text))
    return re.sub(r"`[^`\n]*`|\]\([^)]*\)|<!--.*?-->|<img[^>]*>", lambda match: " " * len(match[0]), text)


def reason_for(page, heading, line):
    for rule in page.allowed if page else ():
        if "section" in rule and rule["section"] in ("*", *heading):
            return rule["reason"]
        if "near" in rule and re.search(rule["near"], line):
            return rule["reason"]
    return ""


def numbers(path, page, text):
    """The numbers of a page that look measured but are not generated."""
    headings, original = [], text.splitlines()
    for number, line in enumerate(unmade(page, text).splitlines(), 1):
        heading = re.match(r"(#+) (.*)", line)
        if heading:
            headings = headings[: len(heading[1]) - 1] + [heading[2].strip()]
        for match in MEASURED.finditer(line):
            if not YEAR.fullmatch(match[0]):
                yield Number(path, number, match[0], reason_for(page, headings, original[number - 1]))


def made_count(page, text):
    """How many numbers the manifest generates: in blocks, and in sentences."""
    count = sum(len(re.findall(pages.NUMBER, match["body"])) for match in pages.BLOCK.finditer(text))
    for entry in page.entries if page else ():
        if entry.kind == "sentence":
            count += sum(len(pages.places(text, words)) for words in entry.keys.get("words", []))
        elif entry.kind == "script":
            for begin in entry.keys["begin"]:
                first, last = pages.part_span(text, begin, entry.keys["end"])
                count += len(re.findall(pages.NUMBER, text[first:last]))
    return count


def survey():
    """Numbers that are not generated, and the number of generated ones."""
    known = {page.path: page for page in manifest.read()}
    found, made = [], 0
    for path in markdown.pages():
        text, page = markdown.read(path), known.get(path)
        found += numbers(path, page, text)
        made += made_count(page, text)
    return found, made
