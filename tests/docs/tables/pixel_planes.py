"""The saving of a second buffer, for docs/machines/pixel-planes.md."""

import re

from figures import THESIS_MODELS, ruled

TURNS = (0, 5, 10)
CLOCK = 10e6  # Hz


def pace(figures, model, buffers):
    """Frames per second of three frames, each and in total, while the camera turns."""
    run = figures.runs.run(f"csgsim render {figures.model(model)} --memory-bits 96 --frames 3 --turn 5 --progress none"
                               f" --machine pixel-planes-4+scan_out.buffers={buffers} -o $OUT/frame.png")
    intervals = [int(line.split()[3].replace(",", "")) for line in run.printed.splitlines() if re.match(r"\d+\s\s", line)]
    in_all = re.search(r"clocks = ([0-9.]+) frames a second", run.printed)
    return [f"{CLOCK / each:.1f}" for each in intervals] + [f"{float(in_all[1]):.1f}"]


def buffers(figures):
    rows = []
    for model in THESIS_MODELS:
        for count in (1, 2):
            stats = figures.render(model, f"--memory-bits 96 --machine pixel-planes-4+scan_out.buffers={count}")
            rows.append((model if count == 1 else "", count, f"{stats.clocks:,}", f"{stats.interval_clocks:,}", *pace(figures, model, count)))
    return ruled(("turned by", "buffers", "clocks at 0°", "interval, clocks", "frames/s at 0°", *(f"at {each}°" for each in TURNS[1:]), "of all three"), rows)
