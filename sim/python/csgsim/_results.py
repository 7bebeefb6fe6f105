"""What calls return."""

from . import _csgsim
from ._machine import Machine


class Program:
    """A compiled model: what the host of the machine broadcasts.

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
        """Writes it, in the binary form, or as text. An interrupted write leaves what was there.

        >>> program.save("part.txt", text=True)
        """
        self._native.save(str(file), text)

    def text(self):
        """The text form, as `csgsim disasm` shows it.

        >>> print(program.text()[:16])
        # csgsim program
        """
        return self._native.text()

    @property
    def instructions(self):
        """A dictionary an instruction: `instruction`, its number in the whole Program; `segment`; `name`; `text`;
        `clocks` at the pixels; its `purpose`; the labels of the `primitive` that it serves and of the one that this is
        compared `against`; and the `effect` that calls for it. None where there is none."""
        return self._native.instructions()

    @property
    def memory(self):
        """A dictionary a field of pixel memory: `name`, first bit `base`, `width` in bits, and `role`."""
        return self._native.fields()

    @property
    def primitives(self):
        """Names by index, as owners of pixels are numbered: `cube@3:5` stands in line 3, column 5 of the model."""
        return self._native.primitives()

    @property
    def size(self):
        """Width and height of the picture, pixels."""
        return self._native.size()

    @property
    def memory_bits(self):
        """Bits of memory that a pixel has."""
        return self._native.memory_bits()

    @property
    def machine(self):
        """The machine that it is for."""
        return Machine._described(self._native.machine())

    def __len__(self):
        return len(self._native)

    def __repr__(self):
        width, height = self.size
        return f"<csgsim.Program: {len(self)} instructions for {width} x {height} pixels of {self.machine.name}>"


class Drawing:
    """A picture that a machine drew. Jupyter shows it.

    >>> drawing = csgsim.render("part.csg")
    >>> drawing.picture.shape, drawing.stats["clocks"]

    `picture`  rows x columns x 3, 8 bits each of red, green and blue
    `depth`    rows x columns, distance from the eye along the view axis in model units, inf where nothing is seen
    `owner`    rows x columns, index of the primitive that is seen, -1 where nothing is
    `stats`    all counts: the keys are those of `csgsim render --stats`, docs/settings.md
    `program`  what the machine was sent, a Program
    """

    def __init__(self, parts):
        self.picture = parts["picture"]
        self.depth = parts["depth"]
        self.owner = parts["owner"]
        self.stats = parts["stats"]
        self.program = Program(parts["program"])

    def png(self):
        """The picture's PNG file, byte for byte what `csgsim render -o` writes.

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
    """Why a pixel shows what it shows: the keys are those of `csgsim explain --json`; `text` says it in words.

    >>> print(csgsim.explain("part.csg", pixel=(256, 256)).text)
    """

    def __init__(self, keys, text):
        super().__init__(keys)
        self.text = text


Program.__module__ = Drawing.__module__ = Story.__module__ = "csgsim"
