"""sources_test.py SOURCE: the page for WebAssembly is compiled of files that are there, and of those that CMake makes."""
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "sim/web"))
import build  # noqa: E402
import rooms  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    made = Path(folder)
    rooms.make_sources(made)
    for room in [*build.ROOMS, *build.JSON_ROOMS]:
        for files in build.batches_of(room, made).values():
            for file in files:
                if not file.exists():
                    raise SystemExit(f"{file}: of the room {room}, is not there")
