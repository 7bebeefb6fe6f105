"""Tables of docs/design-space.md: the processes included in csgsim, from their files, and the output of csgsim explore."""

import tomllib

from figures import row
from runs import ROOT

PAGE = "docs/design-space.md"
AGAINST = "alu.bits=1, evaluator.bits=1"
MEANINGS = {
    "gate.delay": "of a gate with some load",
    "gate.fan_in": "of a gate at most",
    "gate.static_power": "that a gate draws whatever it does",
    "register.delay": "setting up, and until its output is there",
    "register.energy": "clocked",
    "adder.energy": "added",
    "memory.access": "bit lines and sensing",
    "memory.read_energy": "read",
    "memory.read_bits": "of the memory that this is of",
    "memory.transistor_area": "one of a memory cell",
    "transistor.area": "one of logic, with its share of wires",
    "wire.delay": "with what drives it",
    "wire.energy": "carried",
}


def figure(described, key):
    table, _, name = key.partition(".")
    return described[table][name]


def processes(figures):
    names = figures.names_of("processes")
    all_described = [tomllib.loads((ROOT / f"hw/process/{name}.toml").read_text(encoding="utf-8")) for name in names]
    rows = []
    for key, meaning in MEANINGS.items():
        values = [figure(one, key) for one in all_described]
        rows.append((f"`{key}`", f"{values[0]['unit']}, {meaning}",
                     *(cell for one in values for cell in (f"{one['value']:,}", one["provenance"][0]))))
    head = [row("parameter", "unit", *(cell for name in names for cell in (f"`{name}`", ""))), "|---|---|" + "--:|---|" * len(names)]
    return "\n".join(head + [row(*cells) for cells in rows])


def assumed(figures):
    """Runs the command that the page shows for the ranges of the assumed figures."""
    words, _, _ = figures.shown(PAGE, "csgsim explore tests/models/carburettor.csg").rpartition(" -o ")
    return figures.runs.run(f"{words} --progress none -o $OUT/assumed > $OUT/printed; cp $OUT/assumed/tornado_* $OUT")


def assumed_folder(figures):
    return assumed(figures).folder


def sensitivity(figures):
    """The comparisons of equal widths of trees and ALU."""
    text = (assumed_folder(figures) / "printed").read_text(encoding="utf-8")
    parts = [part for part in text.split("\n\n") if any(f"alu.bits={n}, evaluator.bits={n} against {AGAINST}" in part for n in (2, 4))]
    return "\n".join(["```", "\n\n".join("\n".join(line.rstrip() for line in part.splitlines()) for part in parts), "```"])
