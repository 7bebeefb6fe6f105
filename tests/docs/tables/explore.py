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
    "logic.family": "circuits of the logic",
    "logic.utilization": "of the area of logic, the rest is wires",
    "supply.voltage": "",
    "register.delay": "setting up, and until its output is there",
    "register.energy": "clocked",
    "adder.energy": "added",
    "clock.lines": "of the clock over each pixel",
    "memory.access": "bit lines and sensing",
    "memory.read_energy": "read",
    "memory.read_bits": "of the memory that this is of",
    "memory.cell_transistors": "of a memory cell",
    "memory.cell_area": "of a memory cell",
    "memory.periphery": "of the cells: decoders, drivers and sense amplifiers",
    "memory.refresh_time": "0: static cells",
    "transistor.area": "one of logic",
    "wire.delay": "with what drives it",
    "wire.capacitance": "with what drives it",
}


def figure(described, key):
    table, _, name = key.partition(".")
    return described[table][name]


def shown(value):
    return value if isinstance(value, str) else f"{value:,}"


def processes(figures):
    names = figures.names_of("processes")
    all_described = [tomllib.loads((ROOT / f"hw/process/{name}.toml").read_text(encoding="utf-8")) for name in names]
    rows = []
    for key, meaning in MEANINGS.items():
        values = [figure(one, key) for one in all_described]
        rows.append((f"`{key}`", ", ".join(filter(None, (values[0].get("unit"), meaning))),
                     *(cell for one in values for cell in (shown(one["value"]), one["provenance"][0]))))
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
