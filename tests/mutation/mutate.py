#!/usr/bin/env python3
"""Mutation testing: finds small wrong edits that no test detects."""

import argparse
import csv
import fcntl
import fnmatch
import json
import os
import signal
import sys
import time
from collections import Counter
from pathlib import Path

from judges import JUDGES_OF, Judges
from mutants import dependants, files_of, in_random_order, mutants_of

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ["room", "file", "line", "column", "edit", "kind", "result", "by", "seconds", "text"]
MOST_DEPENDANTS = 16  # headers included by more .cpp files take too long to rebuild


class Restored:
    """A source file with an edit, restored in any case; after a crash, by the next run."""

    def __init__(self, build, mutant):
        self.note = build / "mutation-in-flight.json"
        self.file = mutant.file
        self.path = ROOT / mutant.file
        self.mutant = mutant

    def __enter__(self):
        self.text = self.path.read_text()
        self.note.write_text(json.dumps({"file": self.file, "text": self.text}))
        self.path.write_text(self.mutant.apply(self.text))

    def __exit__(self, *_):
        self.path.write_text(self.text)
        self.note.unlink()


def restore_after_a_crash(build):
    note = build / "mutation-in-flight.json"
    if note.exists():
        saved = json.loads(note.read_text())
        (ROOT / saved["file"]).write_text(saved["text"])
        note.unlink()


def judge(judges, room, asked, mutant, build):
    """(result, judge) of a mutant."""
    with Restored(build, mutant):
        for name in asked or JUDGES_OF[room]:
            outcome = judges.ask(name, mutant.file)
            if outcome.result != "passed":
                return outcome.result, name
    return "survived", ""


def read_results(path):
    if not path.exists():
        return {}
    with path.open(newline="") as file:
        return {(row["file"], row["line"], row["column"], row["edit"]): row for row in csv.DictReader(file)}


def append(path, row):
    new = not path.exists()
    with path.open("a", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        if new:
            writer.writeheader()
        writer.writerow(row)


def table(rows, rooms):
    """Results of the mutants that compile, by folder and in total, as Markdown in the form of README.md."""
    counts = Counter((row["room"], row["result"]) for row in rows)
    lines = ["| room | mutants | killed | of these by time-out | survivors | killed, % |", "|---|--:|--:|--:|--:|--:|"]
    sums = Counter()
    for room in [*rooms, "all"]:
        here = sums if room == "all" else Counter({name: counts[room, name] for name in ("failed", "timeout", "survived")})
        killed, mutants = here["failed"] + here["timeout"], here.total()
        share = f"{100 * killed / mutants:.0f}" if mutants else "-"
        name = room if room == "all" else f"`{room}`"
        lines.append(f"| {name} | {mutants} | {killed} | {here['timeout']} | {here['survived']} | {share} |")
        sums += here if room != "all" else Counter()
    return "\n".join(lines)


def line_text(mutant):
    return (ROOT / mutant.file).read_text().splitlines()[mutant.line - 1].strip()


def chosen_mutants(rooms, seed):
    counts = dependants(ROOT)
    chosen = {}
    for room in rooms:
        files = [file for file in files_of(ROOT, room) if counts[str(file)] <= MOST_DEPENDANTS]
        chosen[room] = iter(in_random_order(ROOT, files, seed))
    return chosen


def shares(options, rooms):
    """The number of compiling mutants for each folder."""
    if options.per_room:
        return [options.per_room] * rooms
    return [options.count // rooms + (i < options.count % rooms) for i in range(rooms)]


def rooms_in(patterns):
    """The folders that match a pattern such as sim/software/*; all of them without a pattern."""
    for pattern in patterns:
        if not fnmatch.filter(JUDGES_OF, pattern):
            raise SystemExit(f"mutate.py: no folder matches '{pattern}'; --list prints the folders")
    return [room for room in JUDGES_OF if not patterns or any(fnmatch.fnmatch(room, pattern) for pattern in patterns)]


def go_through(options, judges, rooms):
    """Tests the folders in turns, until every folder has its share of compiling mutants."""
    results = read_results(options.results)
    waiting = chosen_mutants(rooms, options.seed)
    wanted = dict(zip(rooms, shares(options, len(rooms))))
    gone_through = []
    while waiting:
        for room in list(waiting):
            mutant = next(waiting[room], None) if wanted[room] > 0 else None
            if mutant is None:
                del waiting[room]
                continue
            row = results.get(mutant.key)
            if row is None:
                start = time.monotonic()
                text = line_text(mutant)
                result, by = judge(judges, room, options.judge, mutant, options.build)
                row = dict(zip(COLUMNS, [room, *mutant.key, mutant.kind, result, by,
                                         f"{time.monotonic() - start:.1f}", text]))
                append(options.results, row)
                print(f"{result:12} {by:20} {row['seconds']:>6} s  {mutant.file}:{mutant.line}:{mutant.column}: "
                      f"{mutant.edit}", flush=True)
            wanted[room] -= row["result"] != "uncompilable"
            gone_through.append(row)
    return gone_through


def try_again(options, judges):
    """Repeats the mutants of the results file that still exist, with the current tests."""
    rows = {key: row for key, row in read_results(options.again).items() if options.all or row["result"] == "survived"}
    for room in rooms_in(options.room):
        for place in (place for file in files_of(ROOT, room) for place in mutants_of(ROOT, file)):
            for mutant in place:
                if mutant.key not in rows or line_text(mutant) != rows[mutant.key]["text"]:
                    continue
                result, by = judge(judges, room, options.judge, mutant, options.build)
                print(f"{result:12} {by:20} {mutant.file}:{mutant.line}:{mutant.column}: {mutant.edit}", flush=True)


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1, help="seed for the choice and order of mutants (%(default)s)")
    parser.add_argument("--count", type=int, default=400, help="number of compiling mutants over all folders (%(default)s)")
    parser.add_argument("--per-room", type=int, metavar="N", help="N mutants for each folder instead")
    parser.add_argument("--room", action="append", default=[], help="only this folder, or a pattern such as sim/software/*; may be repeated")
    parser.add_argument("--list", action="store_true", help="only print the folders with the tests that judge each")
    parser.add_argument("--judge", action="append", help="only this test executable, without test_; may be repeated")
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "mutants", help="the build folder (%(default)s)")
    parser.add_argument("--results", type=Path, help="results file to append to (BUILD/mutation-results.csv)")
    parser.add_argument("--again", type=Path, help="only test the survivors of this results file again")
    parser.add_argument("--except", dest="excepted", action="append", default=[], metavar="CASE",
                        help="exclude a test case that fails without a mutation; may be repeated")
    parser.add_argument("--near", action="store_true",
                        help="of the cli tests run only those in files named like the edited one")
    parser.add_argument("--all", action="store_true", help="with --again: also repeat killed mutants")
    parser.add_argument("--jobs", type=int, default=2, help="number of concurrent compilers (%(default)s)")
    options = parser.parse_args(arguments)
    options.build = options.build.resolve()
    options.results = options.results or options.build / "mutation-results.csv"
    return options


def main(arguments):
    options = parsed(arguments)
    if options.list:
        for room in rooms_in(options.room):
            print(f"{room:26} {' '.join(JUDGES_OF[room])}")
        return
    rooms = rooms_in(options.room)
    os.nice(5)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    options.build.mkdir(parents=True, exist_ok=True)
    lock = (options.build / "mutation-lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise SystemExit(f"mutate.py: another run uses {options.build}; name another folder with --build") from None
    restore_after_a_crash(options.build)
    judges = Judges(ROOT, options.build, options.jobs, options.excepted, options.near)
    judges.configure()
    judges.measure(options.judge or dict.fromkeys(name for room in rooms for name in JUDGES_OF[room]))
    if options.again:
        try_again(options, judges)
        return
    print(table(go_through(options, judges, rooms), rooms))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except KeyboardInterrupt:
        raise SystemExit(130) from None
