"""Pages in Markdown: their generated blocks, and sentences with measured numbers."""

import re
import string

NUMBER = r"[-+−]?[0-9]+(?:[,.][0-9]+)*"
BLOCK = re.compile(r"<!-- made: (?P<name>[^\n]*?) -->\n(?P<body>.*?)\n?<!-- end -->", re.DOTALL)


class Missing(Exception):
    """Raised if the page does not contain something named by the manifest exactly once."""


def block_names(text):
    return [match["name"] for match in BLOCK.finditer(text)]


def with_block(text, name, body):
    """The page with a new body for a block."""
    found = [match for match in BLOCK.finditer(text) if match["name"] == name]
    if len(found) != 1:
        raise Missing(f"block '{name}' occurs {len(found)} times; write it once: <!-- made: {name} --> ... <!-- end -->")
    return text[: found[0].start("body")] + body.strip("\n") + "\n" + text[found[0].end("body"):].lstrip("\n")


def expressions(words):
    """The parts of a sentence: (words, expression, format); the last two are None at its end."""
    return [(literal, expression, spec) for literal, expression, spec, _ in string.Formatter().parse(words)]


def pattern(words):
    """A pattern that finds the sentence in a page, with any line breaks and a group per number."""
    made = ""
    for literal, expression, _ in expressions(words):
        made += re.sub(r"(?:\\?\s)+", r"\\s+", re.escape(literal))
        made += f"({NUMBER})" if expression is not None else ""
    return re.compile(made)


def places(text, words):
    """The spans of the sentence's numbers in the page, in order."""
    found = list(pattern(words).finditer(text))
    if len(found) != 1:
        raise Missing(f"the sentence occurs {len(found)} times, not once: {words}")
    return [found[0].span(n + 1) for n in range(len(found[0].groups()))]


def with_numbers(text, words, names):
    """The page with the sentence's numbers replaced by the current values of its expressions."""
    spans = places(text, words)
    values = [format(eval(expression, names, names), spec)  # pylint: disable=eval-used
              for _, expression, spec in expressions(words) if expression is not None]
    for (begin, end), value in reversed(list(zip(spans, values))):
        text = text[:begin] + value + text[end:]
    return text


def part_span(text, begin, end):
    """The text between two marks."""
    if text.count(begin) != 1:
        raise Missing(f"the mark {begin} occurs {text.count(begin)} times, not once")
    first = text.index(begin) + len(begin)
    last = text.find(end, first)
    if last < 0:
        raise Missing(f"the mark {end} does not follow {begin}")
    return first, last


def with_part(text, begin, end, body):
    first, last = part_span(text, begin, end)
    return text[:first] + body + text[last:]
