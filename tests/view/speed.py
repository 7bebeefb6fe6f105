#!/usr/bin/env python3
"""Measures how many pictures per second csgsim view draws while a model is turned: speed.py CSGSIM. Prints a table."""

import math
import pathlib
import sys
import time

from server import Server

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PICTURES = 40
# Model, eye and centre as elsewhere in docs/, and options.
ROWS = [
    ("carburettor", (220, -255, 135, 2, 0, 5), {}),
    ("terrain_vehicle", (560, -590, 420, -5, 0, 68), {"projection": "perspective"}),
    ("rietveld_house", (3430, -2900, 1950, 590, 230, 220), {"projection": "perspective"}),
    ("carburettor", (220, -255, 135, 2, 0, 5), {"machine": "pixel-planes-5"}),
    ("carburettor", (220, -255, 135, 2, 0, 5), {"machine": "pixel-square"}),
    ("carburettor", (220, -255, 135, 2, 0, 5), {"machine": "scan-line"}),
]


def turned(camera, degrees):
    ex, ey, ez, cx, cy, cz = camera
    sine, cosine = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    x, y = ex - cx, ey - cy
    return ",".join(f"{value:.10g}" for value in (cx + x * cosine - y * sine, cy + x * sine + y * cosine, ez, cx, cy, cz))


def main():
    csgsim = pathlib.Path(sys.argv[1]).resolve()
    print("| model | machine | pictures per second | compiling, share of time | running |\n|---|---|--:|--:|--:|")
    for model, camera, knobs in ROWS:
        server = Server(csgsim, f"tests/models/{model}.csg", "--size", "512x512", cwd=SOURCE)
        try:
            server.post("draw", {"knobs": knobs | {"camera": turned(camera, 0)}})
            parts = {"compiling": 0.0, "running": 0.0}
            begin = time.monotonic()
            for number in range(PICTURES):
                status, answer = server.post("draw", {"knobs": knobs | {"camera": turned(camera, 3 * number + 3)}})
                assert status == 200, answer
                for part in parts:
                    parts[part] += answer["seconds"][part]
            whole = time.monotonic() - begin
        finally:
            server.stop()
        shares = " | ".join(f"{100 * seconds / whole:.0f} %" for seconds in parts.values())
        print(f"| {model} | {knobs.get('machine', 'pixel-planes-4')} | {PICTURES / whole:.1f} | {shares} |")


if __name__ == "__main__":
    main()
