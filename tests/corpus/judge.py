#!/usr/bin/env python3
"""Compares csgsim's depth pictures of the corpus with OpenSCAD's meshes; exits with 1 if one is wrong.

    judge.py --csgsim build/release/csgsim                      all models, both projections, 512 x 512
    judge.py --csgsim ... --machines --strategies gear thread   two models, also on every machine and with every strategy

A picture is correct if at most 4 of 262,144 pixels are covered only in it or only by the mesh, and if 99.95 % of those
covered in both are within a thousandth of the mesh's diagonal. Needs openscad and numpy."""
import argparse
import sys
import tempfile
from pathlib import Path

import numpy as np

import combinations
import mesh_depth
import meshes
from drawn import render

COLUMNS = "%-28s %-11s %9s %8s %8s %12s %11s %8s %7s  %s"


def difference(seen, expected, diagonal):
    """Pixels covered in one picture only, pixels covered in both, and those of the latter with a wrong depth."""
    both = np.isfinite(seen) & np.isfinite(expected)
    silhouette = int((np.isfinite(seen) != np.isfinite(expected)).sum())
    wrong = int((np.abs(np.where(both, seen, 0.0) - np.where(both, expected, 0.0)) > diagonal / 1000).sum())
    return silhouette, int(both.sum()), wrong


def judge_view(arguments, model, triangles, projection):
    """A row of the table, and the errors."""
    camera = mesh_depth.camera(triangles, projection)
    drawn = render(arguments.csgsim, model, (camera, projection), arguments.size, arguments.option)
    if not drawn:
        return (model.stem, projection, *["-"] * 7), [f"exit code {drawn.code}: {drawn.said}"]
    expected = mesh_depth.depth(triangles, camera, projection, arguments.size)
    silhouette, covered, wrong = difference(drawn.depth, expected, mesh_depth.diagonal(triangles))
    faults = []
    if silhouette * 512 * 512 > 4 * arguments.size ** 2:
        faults.append("silhouette")
    if wrong * 2000 > covered:
        faults.append("depths")
    if covered == 0:
        faults.append("nothing is seen")
    if arguments.pairs:
        size = arguments.variant_size if drawn.seconds < arguments.slow else arguments.variant_size // 2
        faults += combinations.judge(arguments.csgsim, model, (camera, projection), size, arguments.pairs, arguments.tally)
    counts = drawn.stats["model"]
    return (model.stem, projection, counts["halfspaces"], counts.get("pieces", "-"), counts["primitives"], drawn.stats["clocks"], silhouette,
            wrong, f"{drawn.seconds:.2f}"), faults


def judge(arguments, model):
    """The verdict on the model."""
    reason = meshes.refused().get(model.stem)
    triangles = (meshes.mesh_apart if arguments.apart else meshes.mesh)(model, arguments.meshes)
    failed = False
    for projection in mesh_depth.PROJECTIONS:
        row, faults = judge_view(arguments, model, triangles, projection)
        is_refused = row[2] == "-"
        expected = reason is not None and is_refused and reason in faults[0]
        if reason is not None and not is_refused:
            faults.append("drawn, but listed in refused.txt")
        failed |= bool(faults) and not expected
        verdict = "refused: " + reason if expected else "; ".join(faults) or "right"
        print(COLUMNS % (*row, verdict), flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--csgsim", default=str(meshes.CORPUS.parent.parent / "build/release/csgsim"))
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--meshes", type=Path, default=Path(tempfile.gettempdir()) / "csgsim-corpus", help="folder for OpenSCAD's meshes")
    parser.add_argument("--machines", action="store_true", help="also compare every machine with pixel-planes-4")
    parser.add_argument("--strategies", action="store_true", help="also compare every strategy with the stack")
    parser.add_argument("--cross", action="store_true", help="with both: combine every machine with every strategy")
    parser.add_argument("--variant-size", type=int, default=128, help="picture size for machines and strategies")
    parser.add_argument("--slow", type=float, default=float("inf"), help="halve that size for models that take more seconds than this")
    parser.add_argument("--apart", action="store_true", help="let OpenSCAD make a mesh of each child of a union if the union takes too long")
    parser.add_argument("--option", action="append", default=[], help="further arguments of csgsim; repeat for each: --option=--memory-bits --option=256")
    parser.add_argument("models", nargs="*")
    arguments = parser.parse_args()
    arguments.pairs = combinations.chosen(arguments.csgsim, arguments.machines, arguments.strategies, arguments.cross)
    arguments.tally = combinations.Tally()
    print(COLUMNS % ("model", "projection", "halfsp.", "pieces", "solids", "clocks", "silhouette", "depths", "seconds", "verdict"))
    failures = [model.stem for model in meshes.models(arguments.models) if judge(arguments, model)]
    if arguments.pairs:
        arguments.tally.print()
    if failures:
        print(f"{len(failures)} models differ from OpenSCAD's meshes: {' '.join(failures)}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
