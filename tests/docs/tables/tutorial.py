"""docs/tutorial.md: all of its commands are run, one after the other, as they stand there; what they print is shown."""

from runs import ROOT

PAGE = "docs/tutorial.md"
NOT_RUN = ("./setup.sh", "export PATH")  # of whoever reads it; a test has a build already
MOST_LINES = 12
VARIES = ("simulated in",)


def steps():
    """The indented code of the page, a text for each stretch of lines."""
    found, lines = [], []
    for line in (ROOT / PAGE).read_text(encoding="utf-8").splitlines() + [""]:
        if line.startswith("    "):
            lines.append(line[4:])
        elif lines:
            found.append("\n".join(each for each in lines if not each.startswith(NOT_RUN)))
            lines = []
    return [step for step in found if step]


def script():
    """A command for bash: what step N prints goes to $OUT/N.txt."""
    root = "cd $OUT; ln -s {0}/hw hw\n".format(ROOT)
    return root + "\n".join(f"{{\n{step}\n}} > {n}.txt" for n, step in enumerate(steps()))


def printed(figures, number, most=MOST_LINES):
    """What a step prints: its first lines, without what depends on the machine's speed."""
    text = (figures.runs.run(script()).folder / f"{number}.txt").read_text(encoding="utf-8")
    lines = [line.rstrip() for line in text.splitlines() if not line.startswith(VARIES)]
    return "\n".join(["```", *"\n".join(lines[: int(most)]).rstrip().splitlines(), "```"])


def folder(figures):
    """Where the files are that the commands make."""
    return figures.runs.run(script()).folder
