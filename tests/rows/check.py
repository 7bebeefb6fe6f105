#!/usr/bin/env python3
"""Judges the row-command traces of one machine. Usage: check.py CSGSIM FOLDER MACHINE MODEL OPTIONS...

The trace is replayed and must draw csgsim's picture. Its DRAM commands must obey the rules of rules.py. Its clocks must
be those of the stats and of a wave of the SystemC modules, and within 1 % of a schedule by these rules alone. The first
two checks also have to fail on a damaged trace. With the option --command-set, which only csgsim rows has, the clocks
are compared with the schedule alone.
"""
import json
import pathlib
import subprocess
import struct
import sys
import zlib

import rules


def csgsim(program, *words):
    subprocess.run([program, *words], check=True, stdout=subprocess.PIPE)


def require(holds, what):
    if not holds:
        sys.exit(f"check.py: {what}")


def pixels_of_png(path):
    """The pixels of an RGB picture, three bytes each."""
    data, place, parts, header = path.read_bytes(), 8, [], b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        content = data[place + 8:place + 8 + length]
        header = content if kind == b"IHDR" else header
        parts += [content] if kind == b"IDAT" else []
        place += 12 + length
    width, height, depth, colour_type = struct.unpack(">IIBB", header[:10])
    require((depth, colour_type) == (8, 2), f"{path} is no RGB picture of eight bits")
    raw, size, rows = zlib.decompress(b"".join(parts)), 3 * width, [bytes(3 * width)]
    for y in range(height):
        kind, *line = raw[y * (size + 1):(y + 1) * (size + 1)]
        for i in range(size):
            left = line[i - 3] if i >= 3 else 0
            above, corner = rows[-1][i], rows[-1][i - 3] if i >= 3 else 0
            estimate = left + above - corner
            paeth = min((left, above, corner), key=lambda one: abs(estimate - one))
            line[i] = line[i] + (0, left, above, (left + above) // 2, paeth)[kind] & 255
        rows.append(bytes(line))
    return b"".join(rows[1:])


def replayed_pixels(trace, picture):
    subprocess.run([sys.executable, str(pathlib.Path(__file__).with_name("replay.py")), str(trace), str(picture)],
                   check=True)
    return picture.read_bytes().split(b"\n", 3)[3]


def read_commands(path):
    """The form drampower as (clock, name, bank), and the addresses of the form ramulator2, which must agree."""
    lines = [line.split(",") for line in path.read_text().splitlines()]
    return [(int(words[0]), words[1], int(words[4])) for words in lines]


def check_picture(folder, trace):
    expected = pixels_of_png(folder / "picture.png")
    require(replayed_pixels(trace, folder / "replayed.ppm") == expected, "the replayed trace draws another picture")
    require(len(set(expected)) > 2, "the picture is empty")
    # A damaged trace: a row of the picture is complemented before it is sent.
    lines = trace.read_text().splitlines()
    scan_out = lines.index("scan_out")
    row = lines[scan_out + 1].split()[6]
    lines.insert(scan_out, f"0 0 0 - - AP {row}")
    lines.insert(scan_out + 1, f"0 0 0 - - WRITE !{row}")
    (folder / "damaged.rows").write_text("\n".join(lines) + "\n")
    require(replayed_pixels(folder / "damaged.rows", folder / "damaged.ppm") != expected,
            "a damaged trace draws the same picture")


def check_rules(commands, clocks):
    faults, checked = rules.check_commands(commands)
    require(not faults, f"{len(faults)} violations, first {faults[:3]}")
    require(checked > 3_000, f"only {checked} distances were checked")
    require(commands[-1] == (clocks, "END", 0), f"the trace ends at {commands[-1]}, the stats at {clocks}")
    names = {name for _, name, _ in commands}
    require({"ACT", "PRE", "RD", "REFA", "END"} <= names, f"the trace contains only {sorted(names)}")
    for name in ("ACT", "PRE"):
        require(notices_early(commands, name), f"no early {name} is noticed")


def notices_early(commands, name):
    """Whether the rules detect a command that is issued 20 clocks too early, at one of 40 places."""
    places = [i for i, command in enumerate(commands) if command[1] == name]
    for place in places[len(places) // 2:][:40]:
        window = list(commands[max(0, place - 100):place + 100])
        sound = len(rules.check_commands(window)[0])
        clock, _, bank = commands[place]
        window[min(place, 100)] = (clock - 20, name, bank)
        if len(rules.check_commands(sorted(window, key=lambda one: one[0]))[0]) > sound:
            return True
    return False


def check_clocks(trace, clocks):
    lines = trace.read_text().splitlines()
    require(not rules.different_sequences(lines), "slots execute different commands")
    scheduled = rules.schedule(lines)
    require(abs(scheduled - clocks) <= 0.01 * clocks, f"the rules alone need {scheduled} clocks, csgsim {clocks}")
    print(f"{clocks} clocks, {scheduled} by the rules alone: {100 * (scheduled - clocks) / clocks:+.3f} %")


def waved_commands(path):
    """(clock, command) of each change of the row command in a wave. Clock n begins at time (n + 1) periods."""
    commands, times, code = [], [], None
    with open(path, encoding="ascii") as wave:
        for line in wave:
            words = line.split()
            if words[:2] == ["$var", "string"] and words[4] == "row_command":
                code = words[3]
            elif line.startswith("#"):
                times.append(int(line[1:]))
            elif len(words) == 2 and words[1] == code and words[0].startswith("s"):
                commands.append((times[-1], words[0][1:].replace("\\x20", " ")))
    period = times[0]  # clock 0 is the first of the file
    return [(time // period - 1, text) for time, text in commands]


def check_wave(folder, trace, end):
    """The SystemC modules begin the same commands in the first bank at the same clocks, until clock `end`."""
    traced, last = [], "-"
    for line in trace.read_text().splitlines():
        words = line.split()
        if words[0] in ("segment", "instruction"):
            last = "-"
        if words[0].isdigit() and words[1] == "0" and words[2] in ("0", "*") and int(words[0]) < end:
            text = " ".join(words[5:words.index("bus") if "bus" in words else None])
            traced += [(int(words[0]), text)] if text != last else []
            last = text
    waved = [one for one in waved_commands(folder / "wave.vcd") if one[1] != "-" and one[0] < end]
    require(len(traced) > 1_000, f"only {len(traced)} commands were compared with the wave")
    require(waved == traced, f"the wave differs: {[pair for pair in zip(waved, traced) if pair[0] != pair[1]][:3]}")


def check_addresses(folder):
    """All forms of DRAM commands contain the same commands."""
    full = [line.split(",") for line in (folder / "trace.drampower").read_text().splitlines()]
    short = [line.split(",") for line in (folder / "trace.drampower4").read_text().splitlines()]
    name4 = {"REFA": "REF"}
    require(short == [[words[0], name4.get(words[1], words[1]), words[4]] for words in full], "drampower4 differs")
    header, *recorded = [line.split(",") for line in (folder / "trace.ramulator2").read_text().splitlines()]
    require(header == "clock,command,Channel,Rank,BankGroup,Bank,Row,Column,type,source".split(","), str(header))
    name2 = {"PRE": "PREpb", "REFA": "REFab"}
    require([words[:2] for words in recorded] == [[words[0], name2.get(words[1], words[1])] for words in full[:-1]],
            "ramulator2 differs")
    for words, same in zip(recorded, full):
        if words[1] != "REFab":
            require(int(words[4]) + 4 * int(words[5]) == int(same[4]) and words[4] == same[3], f"bank of {words}")
        if words[1] in ("ACT", "RD", "WR"):
            require(words[6] == same[5], f"row of {words}")


def main():
    program, folder, machine, model, *options = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    own = options.index("--command-set") if "--command-set" in options else len(options)
    common = [model, "--machine", machine, *options[:own]]
    csgsim(program, "render", *common, "-o", str(folder / "picture.png"), "--stats", str(folder / "stats.json"))
    for form in ("csgsim", "drampower", "drampower4", "ramulator2"):
        csgsim(program, "rows", *common, *options[own:], "--form", form, "-o", str(folder / f"trace.{form}"))
    trace = folder / "trace.csgsim"
    clocks = json.loads((folder / "stats.json").read_text())["shown_clocks"]
    if options[own:]:
        usual, clocks = clocks, int(trace.read_text().split()[-1])
        require(clocks != usual, "the command set changes nothing")
    else:
        end = min(clocks, 100_000)
        csgsim(program, "wave", *common, "--pixel", "1,1", "--window", f"0:{end}", "-o", str(folder / "wave.vcd"))
        check_wave(folder, trace, end - 100)
    check_picture(folder, trace)
    check_rules(read_commands(folder / "trace.drampower"), clocks)
    check_addresses(folder)
    if "trees" not in machine and "planes" not in machine:
        check_clocks(trace, clocks)


if __name__ == "__main__":
    main()
