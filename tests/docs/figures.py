"""Functions for the manifest's expressions and tables: commands of csgsim on the models of the pages."""

import tomllib

from runs import ROOT

MODELS = {
    "carburettor": "tests/models/carburettor.csg --camera 220,-255,135,2,0,5",
    "vehicle": "tests/models/terrain_vehicle.csg --camera 560,-590,420,-5,0,68",
    "house": "tests/models/rietveld_house.csg --camera 3430,-2900,1950,590,230,220",
    # A near camera: the share of rays that hit the model is that of the thesis's pictures (table 4.9).
    "carburettor, near": "tests/models/carburettor.csg --camera 115.6,-132.9,72.7,2,0,5",
    "vehicle, near": "tests/models/terrain_vehicle.csg --camera 267.3,-284.4,237.7,-5,0,68",
    "house, near": "tests/models/rietveld_house.csg --camera 1984.4,-1306.8,1069.4,590,230,220",
    "fig_2_3": "tests/models/thesis_fig_2_3.csg --camera 42,-38,41,10,5.5,2",
}
THESIS_MODELS = ("carburettor", "vehicle", "house")
PERSPECTIVE = " --projection perspective"


class Figures:
    """Names known to expressions, in addition to those defined by a page's manifest."""

    def __init__(self, runs):
        self.runs = runs

    def model(self, name):
        return MODELS.get(name, name)

    def render(self, model, options="", command="render"):
        """The stats of a frame."""
        return self.runs.run(f"csgsim {command} {self.model(model)} {options} --progress none --stats $OUT/stats.json"
                             ).json("stats.json")

    def clocks(self, model, options=""):
        return self.render(model, options).clocks

    def compare(self, model, options=""):
        """The points of csgsim compare."""
        return self.runs.run(f"csgsim compare {self.model(model)} {options} --no-plots --progress none -o $OUT/compare"
                             ).json("compare/compare.json").points

    def sweep(self, model, options=""):
        return self.runs.run(f"csgsim sweep {self.model(model)} {options} --no-plots --progress none -o $OUT/sweep"
                             ).json("sweep/sweep.json").points

    def accuracy(self, model, options=""):
        return self.runs.run(f"csgsim accuracy {self.model(model)} {options} --no-plots --progress none -o $OUT/accuracy"
                             ).json("accuracy/accuracy.json").points

    def explore(self, options):
        """Results of csgsim explore for the stand-ins of the thesis's models, each fitted to its picture."""
        models = " ".join(self.model(name).split(" ")[0] for name in THESIS_MODELS)
        return self.runs.run(f"csgsim explore {models} {options} --no-plots --progress none -o $OUT/explore").json("explore/explore.json")

    def subdivide(self, model, options=""):
        return self.runs.run(f"csgsim subdivide {self.model(model)} {options} --no-plots --progress none -o $OUT/subdivide"
                             ).json("subdivide/subdivide.json").points

    def classify(self, model, options="", processors="mc68000,i486dx2"):
        """The points of csgsim classify, in perspective unless the model's file defines a view."""
        view = PERSPECTIVE if model in MODELS else ""
        return self.runs.run(f"csgsim classify {self.model(model)}{view} --processors {processors} {options} --no-plots --progress none "
                             "-o $OUT/classify").json("classify/classify.json").points

    def mesh(self, model, options=""):
        return self.runs.run(f"csgsim mesh {self.model(model)} {options} --no-plots --progress none -o $OUT/mesh").json("mesh/mesh.json").points

    def display(self, model, options=""):
        """The points of csgsim display, in perspective; `cylinders` selects those of docs/software.md."""
        cylinders = "tests/models/crossing_cylinders.csg --camera 300,-380,260,0,0,5"
        of = cylinders if model == "cylinders" else self.model(model)
        return self.runs.run(f"csgsim display {of}{PERSPECTIVE} --processors mc68000,i486dx2 {options} --no-plots --progress none "
                             "-o $OUT/display").json("display/display.json").points

    def trace(self, model, options, processors="mc68000,i486dx2"):
        """The points of csgsim trace for a picture of 256 x 256, in perspective."""
        return self.runs.run(f"csgsim trace {self.model(model)}{PERSPECTIVE} --size 256x256 --processors {processors} {options} "
                             "--no-plots --progress none -o $OUT/trace").json("trace/trace.json").points

    def effects(self, model, options=""):
        return self.runs.run(f"csgsim effects {self.model(model)} {options} -o $OUT/effects").json("effects/effects.json")

    def shown(self, page, start):
        """The commands that a page shows, indented, starting at the line with that beginning."""
        lines = (ROOT / page).read_text(encoding="utf-8").splitlines()
        first = next(n for n, line in enumerate(lines) if line.startswith("    " + start))
        last = next(n for n in range(first, len(lines)) if not lines[n].startswith("    "))
        return "\n".join(line[4:] for line in lines[first:last])

    def division_reports(self):
        from tables import division  # pylint: disable=import-outside-toplevel

        return division.reports(self)

    def advise(self, model):
        """The answers of csgsim advise for the wishes shown on its page."""
        from tables import advise  # pylint: disable=import-outside-toplevel

        return advise.answer(self, model)

    def curved(self):
        """Results of csgsim accuracy for facets and for curved surfaces without them, by object."""
        from tables import accuracy  # pylint: disable=import-outside-toplevel

        return accuracy.curved(self)

    def examples(self):
        """Counts of csgsim corpus for OpenSCAD's own examples."""
        from tables import corpus  # pylint: disable=import-outside-toplevel

        return corpus.of_examples(self)

    def one_pixel(self):
        """Statements of docs/lessons.md about its pixel, computed independently and compared with csgsim debug."""
        from tables import one_pixel  # pylint: disable=import-outside-toplevel

        return one_pixel.followed(self)

    def one_instruction(self):
        """The signals of an instruction of One pixel, clock by clock."""
        from tables import one_instruction  # pylint: disable=import-outside-toplevel

        return one_instruction.said(self)

    def times_of_today(self):
        """Seconds of a frame on the machines of docs/machines/bit-serial-memory.md, by model and machine."""
        from tables import today  # pylint: disable=import-outside-toplevel

        return today.times(self)

    def names_of(self, topic):
        """The machines, processors or processes included in csgsim."""
        return [line.split()[0] for line in self.runs.run(f"csgsim manual {topic}").printed.partition("\n\n")[0].splitlines()]

    def machine_file(self, name):
        """The parameters of a machine's file, by name."""
        tables = tomllib.loads((ROOT / f"hw/machines/{name}.toml").read_text(encoding="utf-8"))
        return {f"{table}.{key}": figure["value"] for table, keys in tables.items() if isinstance(keys, dict) for key, figure in keys.items()}

    def one_seam(self):
        """The opening seam of docs/lessons.md."""
        from tables import one_seam  # pylint: disable=import-outside-toplevel

        return one_seam.seam(self)

    def names(self):
        """The names of expressions."""
        own = ("render", "clocks", "compare", "classify", "display", "trace", "sweep", "accuracy", "subdivide", "explore", "mesh", "effects", "shown", "advise", "curved", "examples", "one_pixel",
               "one_seam", "one_instruction", "times_of_today", "machine_file")
        return {"perspective": PERSPECTIVE, "models": THESIS_MODELS, "run": self.runs.run, "per_cent": per_cent, "point": point,
                "division_reports": self.division_reports, **{name: getattr(self, name) for name in own}}


def per_cent(part, whole):
    return 100 * part / whole


def point(points, **wanted):
    """The only point of a study with these values."""
    found = [each for each in points if all(each[key] == value for key, value in wanted.items())]
    if len(found) != 1:
        raise ValueError(f"{len(found)} points have {wanted}")
    return found[0]


def row(*cells):
    return "|" + "".join(f" {cell} |" if cell != "" else " |" for cell in cells)


def ruled(head, rows, numbers_from=1):
    """A table in Markdown; columns from numbers_from on are right-aligned, and so is the first if it holds numbers."""
    if numbers_from == 1 and all(str(cells[0]).isdigit() for cells in rows):
        numbers_from = 0
    rule = "|" + "|".join("--:" if n >= numbers_from else "---" for n in range(len(head))) + "|"
    return "\n".join([row(*head), rule, *(row(*cells) for cells in rows)])
