"""Drawing a model with csgsim, or its error message."""
import json
import resource
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import exr


@dataclass
class Drawn:
    """A picture with its counts, or the reason why there is none."""
    depth: np.ndarray = None
    owner: np.ndarray = None
    picture: bytes = b""
    stats: dict = None
    seconds: float = 0.0  # processor time
    code: int = 0
    said: str = ""

    def __bool__(self):
        return self.code == 0


def children_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def render(csgsim, model, view, size, options=()):
    """Draws from a view: eye, centre and projection."""
    camera, projection = view
    with tempfile.TemporaryDirectory() as folder:
        depth, owner, picture, stats = (Path(folder) / name for name in ("depth.exr", "owner.exr", "picture.ppm", "stats.json"))
        command = [csgsim, "render", model, "--camera=" + ",".join(map(repr, camera)), "--projection", projection, "--size", f"{size}x{size}",
                   "--progress", "none", "--depth", depth, "--owner", owner, "-o", picture, "--stats", stats, *options]
        before = children_seconds()
        run = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
        seconds = children_seconds() - before
        if run.returncode != 0:
            return Drawn(code=run.returncode, said=run.stderr.strip(), seconds=seconds)
        return Drawn(exr.read(depth, "Z"), exr.read(owner, "owner"), picture.read_bytes(), json.loads(stats.read_text(encoding="utf-8")), seconds)
