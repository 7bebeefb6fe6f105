#!/usr/bin/env python3
"""Measures the size of the page without a server program: size.py SITE. Prints a table."""

import gzip
import pathlib
import sys


def main():
    site = pathlib.Path(sys.argv[1])
    pages = [file for ending in ("html", "css", "js") for file in site.glob("*." + ending)]
    groups = {"`csgsim.wasm`": [site / "csgsim.wasm"], "the page and its scripts": pages, "models": list((site / "models").iterdir())}
    print("| | kB | kB with gzip |\n|---|--:|--:|")
    for name, files in groups.items():
        texts = [file.read_bytes() for file in files]
        packed = sum(len(gzip.compress(text)) for text in texts)
        print(f"| {name} | {sum(map(len, texts)) / 1000:,.0f} | {packed / 1000:,.0f} |")


if __name__ == "__main__":
    main()
