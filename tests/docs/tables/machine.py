"""The parameters of a machine, from its file, for docs/machines/NAME.md."""

import re
import tomllib

from figures import ruled
from runs import ROOT

MOST_WORDS = 25
PREFIXES = {1_000_000: "M", 1_000: "k"}


def value_of(figure):
    value, unit = figure["value"], figure.get("unit", "")
    if unit == "Hz":
        for step, prefix in PREFIXES.items():
            if value >= step:
                return f"{value / step:g} {prefix}Hz"
    text = f"{value:,}" if isinstance(value, int) else str(value)
    if value == 1 and not unit.startswith("a "):
        unit = unit.removesuffix("s")
    return f"{text} {unit}".strip()


def in_words_of_pages(source):
    """The source in the form of the pages: Jansen 1987 becomes the thesis, or `thesis` before the number of a section,
    figure or table, without a comma after it. An x between numbers becomes a times sign."""
    source = re.sub(r"(?<!as in )(Jansen 1987, section [\d.]+\d), (?=[a-z])", r"\1 ", source)
    source = re.sub(r"Jansen 1987, (?:sections? (?=\d)|(?=fig|table))", "thesis ", source)
    return re.sub(r"(?<=\d) x (?=\d)", " × ", re.sub(r"Jansen 1987", "the thesis", source))


def shortened(source):
    """The first clauses of the source, as far as they fit into a cell."""
    source = in_words_of_pages(source)
    clauses = re.split(r"(?<=[;:,])\s", source)
    text = clauses[0]
    for clause in clauses[1:]:
        if len(f"{text} {clause}".split()) > MOST_WORDS:
            break
        text += " " + clause
    return text.rstrip(";:,")


def priced(pages, name):
    """The parameters that the file leaves to a processor, as csgsim computes them."""
    lines = pages.runs.run(f"csgsim manual machines {name}").printed.splitlines()
    return {words[0]: int(words[1]) for words in map(str.split, lines) if len(words) > 2 and words[1].isdigit()}


def used(pages, name, key, figure):
    return {**figure, "value": priced(pages, name)[key]} if figure["value"] == "processor" and pages else figure


def provenance_of(figure):
    """`published`, or `assumed` with the plausible range of a number."""
    if "low" not in figure or figure["low"] == figure["high"]:
        return figure["provenance"]
    low, high = (value_of({**figure, "value": figure[limit]}) for limit in ("low", "high"))
    return f"{figure['provenance']}, {low.split()[0]} to {high}"


def figures(pages, name):
    machine = tomllib.loads((ROOT / f"hw/machines/{name}.toml").read_text(encoding="utf-8"))
    rows = [(f"`{table}.{key}`", value_of(used(pages, name, f"{table}.{key}", figure)), provenance_of(figure), shortened(figure["source"]))
            for table, keys in machine.items() if isinstance(keys, dict) for key, figure in keys.items()]
    return ruled(("parameter", "value", "provenance, range", "source or reason"), rows, numbers_from=9)
