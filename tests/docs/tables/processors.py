"""Prices of operations on the processors included in csgsim, from their files, for docs/host.md."""

import re
import tomllib

from figures import row
from runs import ROOT


def instruction(figure):
    """The instruction with that price."""
    return figure["source"].partition(": ")[2]


def prices(figures):
    names = figures.names_of("processors")
    described = [tomllib.loads((ROOT / f"hw/processors/{name}.toml").read_text(encoding="utf-8")) for name in names]
    meanings = dict(re.findall(r'OperationRow\{"(\w+)", "([^"]+)"\}',
                               (ROOT / "hw/processors/operations.h").read_text(encoding="utf-8")))
    rows = [(f"`price.{kind}`", meanings[kind],
             *(cell for one in described for cell in (one["price"][kind]["value"], instruction(one["price"][kind]))))
            for kind in described[0]["price"]]
    head = [row("parameter", "operation", *(cell for name in names for cell in (f"`{name}`", "of"))), "|---|---|" + "--:|---|" * len(names)]
    return "\n".join(head + [row(*cells) for cells in rows])


def factors(figures):
    """Factors of each program, with their sources."""
    names = figures.names_of("processors")
    described = [tomllib.loads((ROOT / f"hw/processors/{name}.toml").read_text(encoding="utf-8")) for name in names]
    rows = [row(f"`compiler.{key}`", *(f"{one['compiler'][key]['value'] / 1000:.2f}" for one in described), described[0]["compiler"][key]["source"].partition(";")[0])
            for key in described[0]["compiler"]]
    return "\n".join([row("parameter", *(f"`{name}`" for name in names), "of `mc68000`"), "|---" + "|--:" * len(names) + "|---|", *rows])
