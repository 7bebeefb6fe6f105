"""Tables of docs/install.md: the packages of each system, from cmake/packages.txt."""

from runs import ROOT

STATES = {"tested": "tested", "untested": "not tested", "unsupported": "csgsim does not run there: {}"}
WORDS = {"build": "csgsim", "pictures": "`CSGSIM_PICTURES`", "convert": "`CSGSIM_CONVERT`", "text": "`CSGSIM_TEXT`",
         "python": "`CSGSIM_PYTHON`"}


def rows():
    words = [line.split() for line in (ROOT / "cmake/packages.txt").read_text().splitlines() if line and not line.startswith("#")]
    return [row for row in words if row[0] == "system"], [row for row in words if row[0] != "system"]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def plain(text):
    return text.replace("_", " ")


def cell(packages):
    return "–" if packages == "-" else ", ".join(f"`{name}`" for name in packages.split(","))


def systems(figures):
    """Which systems are tested."""
    lines = [line(["system", "package manager", "state"]), "|---|---|---|"]
    for _, manager, state, names, _, reason in rows()[0]:
        lines.append(line([plain(names), f"`{manager}`", STATES[state].format(plain(reason))]))
    return "\n".join(lines) + "\n"


def packages(figures):
    """The packages of each need of the program and the Python module."""
    systems, needs = rows()
    heads = [f"{plain(row[3])} (`{row[1]}`)" for row in systems]
    lines = [line(["for", "needed", *heads]), "|---" * (2 + len(heads)) + "|"]
    for group, need, *names in needs:
        if group in WORDS:
            lines.append(line([WORDS[group], plain(need), *map(cell, names)]))
    return "\n".join(lines) + "\n"
