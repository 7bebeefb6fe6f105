"""Tables of docs/design-space.md: output of the commands shown there."""

PAGE = "docs/design-space.md"
RECOMMENDATION = "fewest bits"
LISTED = range(60, 65)  # bits of the vehicle's front to show


def asked(figures, model):
    """Runs the command that the page shows for a model; its exit code is 1 if not all wishes can be met."""
    command = figures.shown(PAGE, f"csgsim advise tests/models/{model}.csg")
    words, _, _ = command.rpartition(" -o ")
    return figures.runs.run(f"{words} --progress none -o $OUT/advice > $OUT/printed || [ $? = 1 ]; cp $OUT/advice/advise.svg $OUT/{model}.svg")


def answer(figures, model):
    return asked(figures, model).json("advice/advise.json")


def folder(figures, model):
    return asked(figures, model).folder


def printed(figures, model):
    """The output of the command: its front, and its recommendations."""
    text = (folder(figures, model) / "printed").read_text(encoding="utf-8")
    first = text.index(RECOMMENDATION)
    recommended = text[first:].splitlines()
    return text[:first].splitlines(), [line for line in recommended if not line.startswith("/")]


def fenced(lines):
    return "\n".join(["```", *"\n".join(line.rstrip() for line in lines).strip("\n").splitlines(), "```"])


def front(figures, model):
    """The heading, the lines of the front for some numbers of bits, and the text after the front."""
    lines, _ = printed(figures, model)
    rows = [n for n, line in enumerate(lines) if line.split() and line.split()[0].isdigit()]
    shown = [lines[n] for n in rows if int(lines[n].split()[0]) in LISTED]
    return fenced([*lines[: rows[0]], "...", *shown, "...", *lines[rows[-1] + 1:]])


def recommendations(figures, model):
    _, lines = printed(figures, model)
    return fenced(lines)
