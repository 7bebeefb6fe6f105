"""The processes included in csgsim, from their files, for docs/design-space.md."""

import tomllib

from figures import row
from runs import ROOT

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
