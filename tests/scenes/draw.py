#!/usr/bin/env python3
"""tests/scenes/draw.py CSGSIM [FOLDER]: draws every scene of this folder and prints the costs as a Markdown table.

With FOLDER, the pictures are written there as NAME.png. Each scene's first line names its model and options."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent


def arguments_of(scene):
    words = scene.read_text().splitlines()[0].removeprefix("# model:").split()
    model = here / words[0]
    if not model.exists():
        model = here.parent / "models" / words[0]
    return [str(model), "--scene", str(scene)] + words[1:]


def bill_of(csgsim, scene, folder):
    command = [csgsim, "effects"] + arguments_of(scene) + ["-o", str(folder)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return json.loads((folder / "effects.json").read_text())


def main():
    csgsim = str(pathlib.Path(sys.argv[1]).resolve())
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    print("| scene | clocks without effects | with | ratio | bits without | with |")
    print("|---|--:|--:|--:|--:|--:|")
    for scene in sorted(here.glob("*.toml")):
        with tempfile.TemporaryDirectory() as folder:
            bill = bill_of(csgsim, scene, pathlib.Path(folder))
            if pictures:
                pictures.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(pathlib.Path(folder) / "all.png", pictures / f"{scene.stem}.png")
        without, with_all = bill["clocks_without_effects"], bill["clocks"]
        print(f"| `{scene.stem}` | {without:,} | {with_all:,} | {with_all / without:.2f} | "
              f"{bill['bits_without_effects']} | {bill['bits']} |", flush=True)


if __name__ == "__main__":
    main()
