"""Results of calls."""

from . import _csgsim
from ._machine import Machine


class Program:
    """A compiled model: the instructions that the machine's host broadcasts.

    >>> program = csgsim.compile("part.csg", z_bits=16)
    >>> program.instructions[0]["text"]
    'enable_all'
    >>> program.save("part.csgt")
    """

    def __init__(self, native):
        self._native = native

    @classmethod
    def load(cls, file):
        """Reads a Program file, .csgt or its text form.

        >>> csgsim.Program.load("traces/carburettor.csgt").size
        (512, 512)
        """
        from ._calls import warned

        return cls(warned(*_csgsim.load(str(file))))

    def save(self, file, *, text=False):
        """Writes the Program in binary or text form. An interrupted write leaves an existing file unchanged.

        >>> program.save("part.txt", text=True)
        """
        self._native.save(str(file), text)

    def text(self):
        """Returns the text form, as printed by `csgsim disasm`.

        >>> print(program.text()[:16])
        # csgsim program
        """
        return self._native.text()

    @property
    def instructions(self):
        """A dictionary per instruction: `instruction`, its number in the whole Program; `segment`; `name`; `text`;
        `clocks` of the machine at the pixels; its `purpose`; the label of its `primitive`, and that of the primitive
        `against` which that one is compared; and its `effect`. Missing values are None."""
        return self._native.instructions()

    @property
    def memory(self):
        """A dictionary per field of pixel memory: `name`, first bit `base`, `width` in bits, and `role`."""
        return self._native.fields()

    @property
    def primitives(self):
        """Names of primitives, by the index used in `owner`: `cube@3:5` is in line 3, column 5 of the model."""
        return self._native.primitives()

    @property
    def size(self):
        """Width and height of the picture in pixels."""
        return self._native.size()

    @property
    def memory_bits(self):
        """Memory bits per pixel."""
        return self._native.memory_bits()

    @property
    def machine(self):
        """The machine that the Program was compiled for."""
        return Machine._described(self._native.machine())

    def __len__(self):
        return len(self._native)

    def __repr__(self):
        width, height = self.size
        return f"<csgsim.Program: {len(self)} instructions for {width} x {height} pixels of {self.machine.name}>"


class Drawing:
    """A picture drawn by a machine. Jupyter displays it.

    >>> drawing = csgsim.render("part.csg")
    >>> drawing.picture.shape, drawing.stats["clocks"]

    `picture`  rows x columns x 3, 8 bits each of red, green and blue
    `depth`    rows x columns, distance from the eye along the view axis in model units, inf where nothing is visible
    `owner`    rows x columns, index of the visible primitive, -1 where nothing is visible
    `stats`    all counts, with the keys of `csgsim render --stats`: clocks, seconds, bits (docs/settings.md)
    `program`  the Program that was sent to the machine
    """

    def __init__(self, parts):
        self.picture = parts["picture"]
        self.depth = parts["depth"]
        self.owner = parts["owner"]
        self.stats = parts["stats"]
        self.program = Program(parts["program"])

    def png(self):
        """Returns the picture as a PNG file, byte for byte as written by `csgsim render -o`.

        >>> pathlib.Path("part.png").write_bytes(drawing.png())
        """
        return _csgsim.png(self.picture)

    def _repr_png_(self):
        return self.png()

    def __repr__(self):
        height, width = self.owner.shape
        machine = self.stats["machine"]["name"]
        return f"<csgsim.Drawing: {width} x {height} pixels, {self.stats['clocks']} clocks of {machine}>"


class Story(dict):
    """The explanation of a pixel, with the keys of `csgsim explain --json`; its attribute `text` is the explanation as
    text. Depths are in depth steps, places in pixels from the upper left.

    >>> print(csgsim.explain("part.csg", pixel=(256, 256)).text)
    """

    def __init__(self, keys, text):
        super().__init__(keys)
        self.text = text


Program.__module__ = Drawing.__module__ = Story.__module__ = "csgsim"
