"""Pages with typed commands: all of their commands are run in order as they stand, and their output is shown."""

from runs import ROOT

NOT_RUN = ("./setup.sh", "export PATH", "cd build/try")  # commands for the reader; the test already has a build
MOST_LINES = 12
STAND_IN = ROOT / "tests/docs/stand_in"  # used if OpenSCAD is not installed
VARIES = ("simulated in",)


class Steps:
    """The indented code of a page, or of a section of it, one text per stretch of lines, run in a folder with `links`
    to the repository."""

    def __init__(self, page, links, not_run=(), section=None):
        self.page = page
        self.section = section
        self.links = links
        self.not_run = NOT_RUN + tuple(not_run)

    def texts(self):
        found, lines, is_printed = [], [], False
        text = (ROOT / self.page).read_text(encoding="utf-8")
        if self.section:
            text = text.split(f"\n## {self.section}\n")[1].split("\n## ")[0]
        for line in text.splitlines() + [""]:
            is_printed ^= line.startswith("```")
            if line.startswith("    ") and not is_printed:
                lines.append(line[4:])
            elif lines:
                found.append("\n".join(each for each in lines if not each.startswith(self.not_run)))
                lines = []
        return [text for text in found if text]

    def script(self):
        """A bash command that writes the output of step N to $OUT/N.txt."""
        links = "".join(f"ln -s {ROOT}/{link} {link}\n" for link in self.links)
        return f"cd $OUT; PATH=$PATH:{STAND_IN}\n{links}" + "\n".join(f"{{\n{text}\n}} > {n}.txt" for n, text in enumerate(self.texts()))

    def printed(self, figures, number, most=MOST_LINES):
        """The first lines of a step's output, without parts that depend on the computer's speed."""
        return self.lines(figures, number, 0, most)

    def lines(self, figures, number, first, most=MOST_LINES):
        """`most` lines of a step's output, from a line given by its number, counted from 0, or by its beginning."""
        text = (self.folder(figures) / f"{number}.txt").read_text(encoding="utf-8")
        lines = [line.rstrip() for line in text.splitlines() if not line.startswith(VARIES)]
        begin = int(first) if str(first).isdigit() else next((i for i, line in enumerate(lines) if line.startswith(first)), None)
        if begin is None:
            raise ValueError(f"step {number} prints no line that begins with '{first}'")
        return "\n".join(["```", *"\n".join(lines[begin : begin + int(most)]).rstrip().splitlines(), "```"])

    def folder(self, figures, below="."):
        """The folder with the files written by the commands."""
        return figures.runs.run(self.script()).folder / below
