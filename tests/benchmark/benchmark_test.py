"""Judges the stored benchmark without csgsim: an executor in plain Python reproduces pictures and counts of the smallest
cases; all files agree with one another; and the suite's version changes with its expected values.

    benchmark_test.py [executor|files|version|generated]"""
import csv
import hashlib
import re
import struct
import sys
import tomllib
import zlib
from pathlib import Path

import executor

SUITE = Path(__file__).resolve().parents[2] / "traces/benchmark"
SMALLEST = ("edge_on_faces", "minkowski_both", "crossing_cylinders", "thin_walls", "coplanar_faces", "polyhedron_ring")
MACHINE = "pixel-planes-4"  # whose array the executor's counts describe


def fnv(content):
    """64-bit FNV-1a, as docs/benchmark.md defines it."""
    value = 0xCBF29CE484222325
    for byte in content:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def cases():
    return tomllib.loads((SUITE / "suite.toml").read_text(encoding="utf-8"))


def expected():
    with open(SUITE / "expected.csv", encoding="utf-8", newline="") as file:
        return {(row["case"], row["machine"]): row for row in csv.DictReader(file)}


def program_of(case):
    return (SUITE / f"programs/{case}.txt").read_text(encoding="utf-8")


def pixels_of(png):
    """The bytes of an RGB picture of 8 bits, row by row."""
    data, at, packed = png.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, colours = struct.unpack(">IIBB", content[:10])
            assert (bits, colours) == (8, 2), f"{png.name}: not RGB of 8 bits"
        packed += content if kind == b"IDAT" else b""
        at += length + 12
    flat, rows, above = zlib.decompress(packed), bytearray(), bytearray(3 * width)
    for y in range(height):
        start = y * (3 * width + 1)
        above = unfiltered(flat[start], flat[start + 1:start + 3 * width + 1], above)
        rows += above
    return bytes(rows)


def unfiltered(kind, row, above):
    """A row of a PNG without its filter."""
    out = bytearray()
    for i, byte in enumerate(row):
        left, up, corner = (out[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
        nearest = min((left, up, corner), key=lambda one: abs(left + up - corner - one))
        out.append(byte + (0, left, up, (left + up) // 2, nearest)[kind] & 255)
    return out


def equal(what, found, wanted):
    if str(found) != str(wanted):
        raise SystemExit(f"{what}: found {found}, expected {wanted}")


def check_executor():
    for case in SMALLEST:
        row, result = expected()[case, MACHINE], executor.run(executor.parse(program_of(case)))
        picture = b"".join(colour.to_bytes(3, "big") for colour in result.colours)
        equal(f"{case}, picture", fnv(picture), row["picture"])
        equal(f"{case}, pixel_operations", result.pixel_operations, row["pixel_operations"])
        equal(f"{case}, enabled_operations", result.enabled_operations, row["enabled_operations"])
        equal(f"{case}, memory_bits", len(result.used), row["memory_bits"])
        equal(f"{case}, skipped", result.skipped, row["skipped"])
        equal(f"{case}, instructions", result.counts.total(), row["instructions"])
        names = list(row)[list(row).index("skipped") + 1:]
        for name in names:
            equal(f"{case}, {name}", result.counts[name], row[name])
        if extra := set(result.counts) - set(names):
            raise SystemExit(f"{case}: no column of {', '.join(sorted(extra))}")
        print(f"{case}: {result.counts.total()} instructions and {len(picture) // 3} pixels as expected")


def check_files():
    suite, rows = cases(), expected()
    machines = suite["stored"] + suite["compiled"]
    names = [case["name"] for case in suite["case"]]
    equal("cases and machines of expected.csv", sorted(rows), sorted((case, one) for case in names for one in machines))
    for folder, ending in (("programs", ".txt"), ("pictures", ".png")):
        equal(folder, sorted(file.name for file in (SUITE / folder).iterdir()), sorted(name + ending for name in names))
    for case in names:
        program, picture = fnv(program_of(case).encode()), fnv(pixels_of(SUITE / f"pictures/{case}.png"))
        for machine in machines:
            equal(f"{case} on {machine}, picture", picture, rows[case, machine]["picture"])
        for machine in suite["stored"]:
            equal(f"{case} on {machine}, program", program, rows[case, machine]["program"])


def digest():
    """SHA-256 of everything that is expected: names and contents."""
    total = hashlib.sha256()
    # Without the version itself, comments and words about the cases, which no value depends on.
    said = re.sub(r'(?m)^(#.*|version = .*|about = .*)\n', "", (SUITE / "suite.toml").read_text(encoding="utf-8"))
    files = {"suite.toml": said.encode(), "expected.csv": (SUITE / "expected.csv").read_bytes()}
    files |= {f"programs/{file.name}": file.read_bytes() for file in (SUITE / "programs").iterdir()}
    files |= {f"pictures/{file.stem}": pixels_of(file) for file in (SUITE / "pictures").iterdir()}
    for name in sorted(files):
        total.update(f"{name} {hashlib.sha256(files[name]).hexdigest()}\n".encode())
    return total.hexdigest()


def check_version():
    with open(SUITE / "versions.csv", encoding="utf-8", newline="") as file:
        versions = {row["version"]: row["sha256"] for row in csv.DictReader(file)}
    version, found = str(cases()["version"]), digest()
    if versions.get(version) != found:
        raise SystemExit(f"the suite's expected values are not those of version {version}. If the change is intended, give "
                         f"suite.toml a new version and add its line to versions.csv: VERSION,{found}")
    equal("the last line of versions.csv", list(versions)[-1], version)


def check_generated():
    sys.path.insert(0, str(SUITE))
    import generate
    for name, text in generate.models().items():
        if (SUITE / f"models/{name}.csg").read_text(encoding="utf-8") != text:
            raise SystemExit(f"models/{name}.csg is not what generate.py writes; run it, or restore the file")


if __name__ == "__main__":
    {"executor": check_executor, "files": check_files, "version": check_version, "generated": check_generated}[sys.argv[1]]()
