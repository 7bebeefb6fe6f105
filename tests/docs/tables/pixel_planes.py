"""The saving of a second buffer, for docs/machines/pixel-planes.md."""

from figures import THESIS_MODELS, ruled

TURNS = (0, 5, 10)
CLOCK = 10e6  # Hz


def pace(figures, model, buffers):
    """Frames per second of three frames, each and in total, while the camera turns."""
    stats = figures.runs.run(f"csgsim render {figures.model(model)} --memory-bits 96 --frames 3 --orbit 15 --progress none"
                                 f" --machine pixel-planes-4+scan_out.buffers={buffers} --stats $OUT/frames.json").json("frames.json")
    return [f"{CLOCK / frame.interval_clocks:.1f}" for frame in stats.frames] + [f"{stats.totals.frames_per_second:.1f}"]


def buffers(figures):
    rows = []
    for model in THESIS_MODELS:
        for count in (1, 2):
            stats = figures.render(model, f"--memory-bits 96 --machine pixel-planes-4+scan_out.buffers={count}")
            rows.append((model if count == 1 else "", count, f"{stats.clocks:,}", f"{stats.interval_clocks:,}", *pace(figures, model, count)))
    return ruled(("turned by", "buffers", "clocks at 0°", "interval, clocks", "frames/s at 0°", *(f"at {each}°" for each in TURNS[1:]), "of all three"), rows)
