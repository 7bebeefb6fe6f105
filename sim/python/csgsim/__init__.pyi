"""Types of csgsim: docs/python.md. Options are those of the command line; its help and `csgsim.options(call)` explain
them."""

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
    range: tuple[int, int, str] | None

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

class _ModelOptions(TypedDict, total=False):
    """Options of every call that takes a model."""

    size: Text
    camera: Text
    projection: Text
    scene: Text
    colour_scheme: Text
    set: Texts
    imports_from: Text
    openscad_time: int
    define: Texts
    parameters: Text
    parameter_set: Text
    snap: bool
    limit: int
    view_all: bool
    near: float
    fraction_bits: int
    edge_on: float
    colour_bits: int
    strategy: Text
    colouring: Text
    pruning: Text

class _RunOptions(TypedDict, total=False):
    """Options of every call that draws a picture."""

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

class _StudyOptions(TypedDict, total=False):
    """Options of every study."""

    output: Text
    no_plots: bool
    report: Text
    progress: Text

class ModelOptions(_ModelOptions, total=False):
    machine: Text
    memory_bits: int
    tolerance: Text
    curves: Text
    z_bits: int
    stack_bits: int

class RenderOptions(ModelOptions, _RunOptions, total=False):
    report: Text
    check: bool
    max_wrong_pixels: int

class RunOptions(_RunOptions, total=False):
    machine: Text
    set: Texts
    checkpoint: Text
    checkpoint_every: int
    resume: Text

class ExplainOptions(ModelOptions, total=False):
    pixel: Text
    point: Text
    why_not: Text

class SweepOptions(_ModelOptions, _StudyOptions, total=False):
    stack_bits: Text
    z_bits: Text
    machines: Text
    memory_bits: Text
    tolerance: Text
    curves: Text
    no_draw: bool
    threads: int

class CompareOptions(_ModelOptions, _StudyOptions, total=False):
    memory_bits: int
    z_bits: int
    stack_bits: int
    machines: Text
    fragments: Text
    sides: Text
    ideal: bool
    with_: Text
    threads: int

class AccuracyOptions(_ModelOptions, _StudyOptions, total=False):
    machine: Text
    tolerance: Text
    curves: Text
    z_bits: int
    stack_bits: int
    views: int
    knobs: Text
    tolerances: Text

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
def data_frame(result: Mapping[str, Any] | Iterable[Mapping[str, Any]], table: str = "points") -> Any: ...
def studies() -> list[str]: ...
def machines() -> list[Machine]: ...
def options(command: str, /) -> list[dict[str, Any]]: ...
