"""Savings and errors of adaptive anti-aliasing, in docs/effects.md."""

from figures import ruled

SAMPLES = ((4, None), (4, 1), (4, 128), (16, None), (16, 1), (16, 64), (16, 104), (16, 128))


def drawn(figures, samples, least_difference):
    """Clocks, and the levels of the picture."""
    options = f"--memory-bits 256 --set effects.antialias.samples={samples}"
    if least_difference is not None:
        options += f" --set effects.antialias.adaptive=true --set effects.antialias.least_difference={least_difference}"
    run = figures.runs.run(f"csgsim render {figures.model('carburettor')} {options} --progress none -o $OUT/picture.ppm --stats $OUT/stats.json")
    return run.json("stats.json").clocks, (run.folder / "picture.ppm").read_bytes()[-512 * 512 * 3:]


def samples(figures):
    rows = []
    for count, least_difference in SAMPLES:
        clocks, picture = drawn(figures, count, least_difference)
        if least_difference is None:
            full_clocks, full = clocks, picture
            rows.append((count, "full", f"{clocks:,}", "", "", ""))
            continue
        differences = [abs(a - b) for a, b in zip(picture, full) if a != b]
        square_mean = (sum(each * each for each in differences) / len(full)) ** 0.5
        rows.append((count, least_difference, f"{clocks:,}", f"{clocks / full_clocks:.3f}", max(differences, default=0), f"{square_mean:.1f}"))
    return ruled(("samples", "`least_difference`", "clocks", "fraction of full", "maximum difference", "root mean square"), rows, numbers_from=0)
