"""docs/processors.md: what operations cost on the processors that come with csgsim, from their files."""

import re
import tomllib

from figures import row
from runs import ROOT

NAMES = ("mc68000", "i486dx2", "i860")


def instruction(figure):
    """Of which instruction the price is."""
    return figure["source"].partition(": ")[2]


def prices(_):
    described = [tomllib.loads((ROOT / f"hw/processors/{name}.toml").read_text(encoding="utf-8")) for name in NAMES]
    meanings = dict(re.findall(r'OperationRow\{"(\w+)", "([^"]+)"\}',
                               (ROOT / "hw/processors/operations.h").read_text(encoding="utf-8")))
    rows = [(f"`price.{kind}`", meanings[kind],
             *(cell for one in described for cell in (one["price"][kind]["value"], instruction(one["price"][kind]))))
            for kind in described[0]["price"]]
    head = [row("figure", "an operation", *(cell for name in NAMES for cell in (f"`{name}`", "of"))), "|---|---|" + "--:|---|" * len(NAMES)]
    return "\n".join(head + [row(*cells) for cells in rows])


def factors(_):
    """Of each program, and where the figure is from."""
    described = [tomllib.loads((ROOT / f"hw/processors/{name}.toml").read_text(encoding="utf-8")) for name in NAMES]
    rows = [row(f"`compiler.{key}`", *(f"{one['compiler'][key]['value'] / 1000:.2f}" for one in described), described[0]["compiler"][key]["source"].partition(";")[0])
            for key in described[0]["compiler"]]
    return "\n".join([row("figure", *(f"`{name}`" for name in NAMES), "of `mc68000`"), "|---" + "|--:" * len(NAMES) + "|---|", *rows])
