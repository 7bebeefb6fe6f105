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
    first, others = described[0], described[1:]
    rows = [row(f"`price.{kind}`", meanings[kind], first["price"][kind]["value"], instruction(first["price"][kind]),
                *(one["price"][kind]["value"] for one in others))
            for kind in first["price"]]
    head = [row("parameter", "operation", f"`{names[0]}`", "of", *(f"`{name}`" for name in names[1:])),
            "|---|---|--:|---|" + "--:|" * len(others)]
    return "\n".join(head + rows)


def factors(figures):
    """Factors of each program, with their sources."""
    names = figures.names_of("processors")
    described = [tomllib.loads((ROOT / f"hw/processors/{name}.toml").read_text(encoding="utf-8")) for name in names]
    rows = [row(f"`compiler.{key}`", *(f"{one['compiler'][key]['value'] / 1000:.2f}" for one in described), described[0]["compiler"][key]["source"].partition(";")[0])
            for key in described[0]["compiler"]]
    return "\n".join([row("parameter", *(f"`{name}`" for name in names), "of `mc68000`"), "|---" + "|--:" * len(names) + "|---|", *rows])
