"""Types of csgsim: docs/python.md. Options are those of the command line, whose help says what each means; so does
`csgsim.options(call)`."""

import os
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, TypedDict, Unpack

from numpy import float64, int32, uint8
from numpy.typing import NDArray

__version__: str

_One = str | int | float | os.PathLike[str] | Machine
Text = _One | Iterable[_One] | None
Texts = Mapping[str, _One | Iterable[_One]] | Iterable[_One] | None

class Error(Exception):
    @property
    def file(self) -> str | None: ...
    @property
    def line(self) -> int | None: ...
    @property
    def column(self) -> int | None: ...

class UsageError(Error): ...
class CsgsimWarning(UserWarning): ...

class Figure(NamedTuple):
    key: str
    value: int | str
    unit: str
    provenance: str
    source: str

class Machine:
    name: str
    description: str
    kind: str
    figures: dict[str, Figure]
    spelt: str
    def __init__(self, name: str | os.PathLike[str], **figures: int | str) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    def __repr__(self) -> str: ...

class Program:
    def __init__(self, native: Any) -> None: ...
    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> Program: ...
    def save(self, file: str | os.PathLike[str], *, text: bool = False) -> None: ...
    def text(self) -> str: ...
    @property
    def instructions(self) -> list[dict[str, Any]]: ...
    @property
    def memory(self) -> list[dict[str, Any]]: ...
    @property
    def primitives(self) -> list[str]: ...
    @property
    def size(self) -> tuple[int, int]: ...
    @property
    def memory_bits(self) -> int: ...
    @property
    def machine(self) -> Machine: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

class Drawing:
    picture: NDArray[uint8]
    depth: NDArray[float64]
    owner: NDArray[int32]
    stats: dict[str, Any]
    program: Program
    def __init__(self, parts: dict[str, Any]) -> None: ...
    def png(self) -> bytes: ...
    def __repr__(self) -> str: ...

class Story(dict[str, Any]):
    text: str
    def __init__(self, keys: dict[str, Any], text: str) -> None: ...

class ModelOptions(TypedDict, total=False):
    machine: Text
    memory_bits: int
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    tolerance: Text
    curves: Text
    colour_bits: int
    z_bits: int
    strategy: Text
    stack_bits: int
    colouring: Text
    pruning: Text

class RenderOptions(TypedDict, total=False):
    machine: Text
    memory_bits: int
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    tolerance: Text
    curves: Text
    colour_bits: int
    z_bits: int
    strategy: Text
    stack_bits: int
    colouring: Text
    pruning: Text
    output: Text
    depth: Text
    owner: Text
    stats: Text
    surface: Text
    level: Text
    evaluator: Text
    threads: int
    advice: bool
    progress: Text
    report: Text
    check: bool
    max_wrong_pixels: int

class RunOptions(TypedDict, total=False):
    machine: Text
    set: Texts
    output: Text
    depth: Text
    owner: Text
    stats: Text
    surface: Text
    level: Text
    evaluator: Text
    threads: int
    advice: bool
    progress: Text
    checkpoint: Text
    checkpoint_every: int
    resume: Text

class ExplainOptions(TypedDict, total=False):
    machine: Text
    memory_bits: int
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    tolerance: Text
    curves: Text
    colour_bits: int
    z_bits: int
    strategy: Text
    stack_bits: int
    colouring: Text
    pruning: Text
    pixel: Text
    point: Text
    why_not: Text

class SweepOptions(TypedDict, total=False):
    strategy: Text
    stack_bits: Text
    z_bits: Text
    colouring: Text
    pruning: Text
    machines: Text
    memory_bits: Text
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    tolerance: Text
    colour_bits: int
    curves: Text
    no_draw: bool
    output: Text
    threads: int
    no_plots: bool
    report: Text
    progress: Text

class CompareOptions(TypedDict, total=False):
    memory_bits: int
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    colour_bits: int
    z_bits: int
    strategy: Text
    stack_bits: int
    colouring: Text
    pruning: Text
    machines: Text
    fragments: Text
    sides: Text
    ideal: bool
    with_: Text
    output: Text
    threads: int
    no_plots: bool
    report: Text
    progress: Text

class AccuracyOptions(TypedDict, total=False):
    machine: Text
    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    tolerance: Text
    curves: Text
    colour_bits: int
    z_bits: int
    strategy: Text
    stack_bits: int
    colouring: Text
    pruning: Text
    views: int
    knobs: Text
    tolerances: Text
    output: Text
    no_plots: bool
    report: Text
    progress: Text

def render(
    model: str | os.PathLike[str] | None = None, /, *, text: str | None = None, **options: Unpack[RenderOptions]
) -> Drawing: ...
def compile(
    model: str | os.PathLike[str] | None = None, /, *, text: str | None = None, **options: Unpack[ModelOptions]
) -> Program: ...
def run(program: Program | str | os.PathLike[str], /, **options: Unpack[RunOptions]) -> Drawing: ...
def explain(
    subject: Program | str | os.PathLike[str] | None = None,
    /,
    *,
    text: str | None = None,
    **options: Unpack[ExplainOptions],
) -> Story: ...
def study(name: str, /, *operands: str | os.PathLike[str], **options: Text | Texts) -> dict[str, Any]: ...
def sweep(*models: str | os.PathLike[str], **options: Unpack[SweepOptions]) -> list[dict[str, Any]]: ...
def compare(model: str | os.PathLike[str], /, **options: Unpack[CompareOptions]) -> list[dict[str, Any]]: ...
def accuracy(model: str | os.PathLike[str], /, **options: Unpack[AccuracyOptions]) -> list[dict[str, Any]]: ...
def studies() -> list[str]: ...
def machines() -> list[Machine]: ...
def options(command: str, /) -> list[dict[str, Any]]: ...
