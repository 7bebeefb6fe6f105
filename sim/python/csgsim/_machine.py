"""Machines and their parameters."""

from typing import NamedTuple

from . import _csgsim


class Figure(NamedTuple):
    """A parameter of a machine: its value, a whole number or a word, in `unit` (bits, pixels, Hz, clocks), and its
    source. `provenance` is "published" or "assumed". `range` is the lowest and the highest plausible value of an
    assumed number, and the reason; None for other parameters.

    >>> csgsim.Machine("pixel-planes-4").figures["alu.bits"].provenance
    'published'
    """

    key: str
    value: object
    unit: str
    provenance: str
    source: str
    range: tuple[int, int, str] | None = None


def _figure(row):
    value = row["value"]
    return Figure(**{**row, "value": int(value) if value.lstrip("-").isdigit() else value})


class Machine:
    """A machine by its name or .toml file, with changed parameters.

    >>> wide = csgsim.Machine("pixel-planes-4", **{"alu.bits": 2})
    >>> csgsim.render("part.csg", machine=wide).stats["clocks"]

    `name`, `description` and `kind` are texts; `figures` maps keys to parameters; `spelt` is the machine's
    name in options, including changes.
    """

    def __init__(self, name, **figures):
        changes = [f"{key}={value}" for key, value in figures.items()]
        self._take(_csgsim.machine(str(name), changes))
        self.spelt = "+".join([str(name), *changes])

    def _take(self, description):
        self.name = description["name"]
        self.description = description["description"]
        self.kind = description["kind"]
        self.figures = {row["key"]: _figure(row) for row in description["figures"]}

    @classmethod
    def _described(cls, description):
        machine = cls.__new__(cls)
        machine._take(description)
        machine.spelt = machine.name
        return machine

    def __repr__(self):
        return f"csgsim.Machine({self.spelt!r})"

    def __eq__(self, other):
        return isinstance(other, Machine) and (self.name, self.figures) == (other.name, other.figures)

    def __hash__(self):
        return hash(self.name)


def machines():
    """Returns the built-in machines.

    >>> [machine.name for machine in csgsim.machines()]
    ['pixel-planes-4', 'scan-line', 'pixel-square', 'pixel-planes-5', 'multi-processor', 'pixel-powers']
    """
    return [Machine(name) for name in _csgsim.machines()]


Figure.__module__ = Machine.__module__ = "csgsim"
