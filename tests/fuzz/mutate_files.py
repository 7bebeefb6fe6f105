#!/usr/bin/env python3
"""Runs csgsim itself on mutations of files of every kind, and reports violations.

    mutate_files.py CSGSIM [--minutes M | --cases N] [--seed S] [--jobs J] [--kinds a,b] [--limit SECONDS] [--out FOLDER]
                           [--server build/release/tests/fuzz/libcsgsim_fork_server.so]
    mutate_files.py CSGSIM --again FINDING

A case is a folder with the inputs of a command, with one file mutated. Violations are: an end by a signal, an exit code
other than 0, 1 and 2, more than --limit seconds of processor time, or as long without any, a failure without a message,
a message that asks to report it, and files written that the command line does not name. Each finding is the folder of
its case, with its `command` and output, in FOLDER; --again repeats one. The exit code is 1 if there are any. With
--server (fork_server.cpp) csgsim is started once per job and forked for each case.
"""

import argparse
import collections
import concurrent.futures
import dataclasses
import fcntl
import io
import os
import pathlib
import random
import re
import resource
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
import zlib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
CUBE = "difference() { cube(size = [8, 6, 4], center = true); sphere(r = 3, $fn = 8); }\n"
SMALL = ["--size", "16x16"]
MOST_MEMORY = 4 << 30
MOST_FILE = 256 << 20
LONGEST_SAMPLE = 40_000

Files = dict[str, bytes]


@dataclasses.dataclass
class Sample:
    """A template of cases: the files of its folder, and which of them is mutated."""

    kind: str
    files: Files
    changed: str
    commands: list[list[str]]
    writes: tuple[str, ...] = ()  # names, or prefixes of names that end in a slash or a star
    seal: object = None  # corrects a checksum


# ---- mutations ----

NUMBERS = [b"0", b"-1", b"1", b"-0.0", b"1e999", b"-1e999", b"nan", b"inf", b"1e-320", b"1e300", b"4294967295", b"4294967296",
           b"2147483648", b"9223372036854775807", b"18446744073709551615", b"18446744073709551616", b"0.5", b"1e6", b"99999",
           b"0x10", b"1_000", b"007"]
PIECES = [b"\xff", b"\x9f", b"\xc0\x80", b"\0", b"\\u0000", b"\r", b"\n", b"\"", b"'", b",", b";", b"(", b")", b"[", b"]", b"{",
          b"}", b"=", b"#", b"/*", b"//", b"&amp;", b"<", b">", b"../", b"-o", b"--", b"--config=x", b"null", b"true", b"false",
          b"undef", b"\xe2\x80\xae", b"%n%s", b"\x1b[2J", b" ", b"\t", b"A" * 5000, b"[" * 300, b"(" * 300]
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def mutate_once(text: bytes, others: list[bytes], rng: random.Random) -> bytes:
    at = rng.randrange(len(text) + 1)
    count = min(1 + rng.randrange(30), len(text) - at)
    choice = rng.randrange(12)
    if choice == 0:
        return text[:at] + text[at + count:]
    if choice == 1:
        return text[:at] + rng.choice(PIECES) + text[at:]
    if choice == 2:
        return text[:at] + rng.choice(PIECES) + text[at + count:]
    if choice == 3 and at < len(text):
        return text[:at] + bytes([rng.randrange(256)]) + text[at + 1:]
    if choice == 4 and at < len(text):
        return text[:at] + bytes([text[at] ^ 1 << rng.randrange(8)]) + text[at + 1:]
    if choice in (5, 6, 7):
        numbers = list(NUMBER.finditer(text[:200_000]))
        if numbers:
            one = rng.choice(numbers)
            return text[:one.start()] + rng.choice(NUMBERS) + text[one.end():]
    if choice == 8:
        lines = text.split(b"\n")
        begin = rng.randrange(len(lines))
        piece = lines[begin:begin + 1 + rng.randrange(3)]
        to = rng.randrange(len(lines) + 1)
        return b"\n".join(lines[:to] + piece + lines[to:])
    if choice == 9:
        lines = text.split(b"\n")
        begin = rng.randrange(len(lines))
        return b"\n".join(lines[:begin] + lines[begin + 1 + rng.randrange(3):])
    if choice == 10:
        other = rng.choice(others)
        begin = rng.randrange(len(other) + 1)
        return text[:at] + other[begin:begin + rng.randrange(200)] + text[at:]
    return text[:at] if rng.randrange(4) == 0 else text[:at] + text[at:at + count] * (1 + rng.randrange(3)) + text[at:]


def mutate(text: bytes, others: list[bytes], rng: random.Random) -> bytes:
    for _ in range(1 + min(rng.randrange(4), rng.randrange(4))):
        text = mutate_once(text, others, rng)
    return text


# ---- samples ----

def sealed_at_end(text: bytes) -> bytes:
    """Writes the CRC-32 of the preceding bytes into the last four bytes."""
    return text[:-4] + zlib.crc32(text[:-4]).to_bytes(4, "little") if len(text) > 4 else text


def rezipped(mutated: Files, name: str) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for member, text in mutated.items():
            archive.writestr(member, text)
    return packed.getvalue()


def read_all(*patterns: str, longest: int = LONGEST_SAMPLE) -> list[tuple[str, bytes]]:
    found = []
    for pattern in patterns:
        for path in sorted(SOURCE.glob(pattern)):
            if path.is_file() and path.stat().st_size <= longest:
                found.append((path.name, path.read_bytes()))
    if not found:
        sys.exit(f"mutate_files.py: nothing matches {patterns}")
    return found


RENDER = ["render", "m.csg", *SMALL, "-o", "p.png", "--stats", "s.json"]
RENDERED = ("p.png", "s.json")


def imported(kind: str, patterns: list[str], node: str) -> list[Sample]:
    """Models that import the mutated file."""
    samples = []
    for name, text in read_all(*patterns):
        file = "f" + pathlib.Path(name).suffix
        model = node.replace("FILE", file).encode()
        samples.append(Sample(kind, {"m.csg": model, file: text}, file, [RENDER], RENDERED))
    return samples


def of_sources() -> list[Sample]:
    """Samples whose files are in the repository."""
    cube = CUBE.encode()
    all_samples = []

    def add(kind: str, patterns: list[str], file: str, commands: list[list[str]], writes: tuple[str, ...], **others):
        files = {name: text for name, text in others.get("beside", {}).items()}
        for _, text in read_all(*patterns, longest=others.get("longest", LONGEST_SAMPLE)):
            all_samples.append(Sample(kind, files | {file: text}, file, commands, writes, others.get("seal")))

    add("csg", ["tests/models/*.csg", "tests/corpus/*.csg", "tests/fuzz/corpus/read/*"], "m.csg",
        [RENDER, ["explain", "m.csg", *SMALL, "--pixel", "8,8"]], RENDERED, longest=3000)
    add("commands", ["tests/models/*.jan", "tests/fuzz/corpus/commands/*"], "m.jan", [["render", "m.jan", *SMALL, "-o", "p.png"]], RENDERED, longest=3000)
    if shutil.which("openscad"):
        add("scad", ["tests/corpus/*.scad"], "m.scad", [["render", "m.scad", *SMALL, "-o", "p.png"]], RENDERED, longest=2000)
    flat = "linear_extrude(height = 2, center = false, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, $fs = 2) {\n" \
           "import(file = \"FILE\", layer = \"\", origin = [0, 0], scale = 1, convexity = 1, $fn = 0, $fa = 12, $fs = 2);\n}\n"
    solid = "import(file = \"FILE\", layer = \"\", origin = [0, 0], scale = 1, convexity = 1, $fn = 0, $fa = 12, $fs = 2);\n"
    all_samples.extend(imported("stl", ["tests/models/solids/*.stl", "tests/corpus/data/*.stl", "tests/fuzz/corpus/mesh/*.stl"], solid))
    all_samples.extend(imported("off", ["tests/models/solids/*.off", "tests/fuzz/corpus/mesh/*.off"], solid))
    all_samples.extend(imported("obj", ["tests/models/solids/*.obj", "tests/fuzz/corpus/mesh/*.obj"], solid))
    all_samples.extend(imported("amf", ["tests/models/solids/*.amf"], solid))
    all_samples.extend(imported("3mf", ["tests/models/solids/*.3mf"], solid))
    all_samples.extend(imported("svg", ["tests/unit/flat/drawings/*.svg", "tests/fuzz/corpus/svg/*"], flat))
    all_samples.extend(imported("dxf", ["tests/unit/flat/drawings/*.dxf", "tests/fuzz/corpus/dxf/*"], flat))
    all_samples.extend(imported("surface", ["tests/models/solids/heights_*.dat", "tests/models/solids/heights_*.png",
                                            "tests/fuzz/corpus/surface/*"],
                                "surface(file = \"FILE\", center = true, invert = false, convexity = 1);\n"))
    add("scene", ["tests/scenes/*.toml", "tests/fuzz/corpus/scene/all.toml"], "look.toml",
        [["render", "m.csg", *SMALL, "--scene", "look.toml", "-o", "p.png"]], RENDERED, beside={"m.csg": cube})
    add("machine", ["hw/machines/*.toml"], "mine.toml",
        [["render", "m.csg", *SMALL, "--machine", "mine.toml", "-o", "p.png"], ["manual", "machines", "mine.toml"]], RENDERED,
        beside={"m.csg": cube})
    settings = [b"size = '16x16'\nview-all = true\nset = ['alu.bits=4']\n[render]\nz-bits = 18\ncamera = [9, -9, 9, 0, 0, 0]\n"
                b"strategy = 'list'\nwithout = ['hidden']\n[sweep]\nz-bits = '16..20'\n"]
    settings += [text for _, text in read_all("tests/fuzz/corpus/settings/*.toml")]
    for text in settings:
        command = ["render", "m.csg", *SMALL, "--config", "run.toml"]
        all_samples.append(Sample("settings", {"m.csg": cube, "run.toml": text}, "run.toml",
                                  [command + ["-o", "p.png", "--stats", "s.json", "--depth", "d.exr", "--owner", "w.png"],
                                   command + ["--dump-config"]], ("*",)))  # it may name output files
    add("program text", ["tests/fuzz/corpus/program_text/*", "tests/debugging/*.txt"], "p.csgt",
        [["run", "p.csgt", "--stats", "s.json"], ["disasm", "p.csgt"]], RENDERED, longest=8000)
    for pattern in ("one.csgt", "two_*.csgt"):
        add("program", [f"tests/fuzz/corpus/program_binary/{pattern}"], "p.csgt",
            [["run", "p.csgt", "--stats", "s.json"], ["disasm", "p.csgt"]], RENDERED, seal=sealed_at_end)
    program = SOURCE / "tests/fuzz/corpus/program_text/two_stack.csgt"
    scripts = [b"step 3\ninfo\nbreak primitive a\nrun\nprint Z1 8,8\nback 2\nquit\n"]
    scripts += [text for _, text in read_all("tests/debugging/*.commands", "tests/fuzz/corpus/debug_command/*")]
    for text in scripts:
        all_samples.append(Sample("debug script", {"p.csgt": program.read_bytes(), "c.commands": text}, "c.commands",
                                  [["debug", "p.csgt", "-x", "c.commands"]], ("*",)))  # its commands name output files
    return all_samples


def seldom_plotted(words: list[str]) -> list[list[str]]:
    """Commands with plots, which take seconds, and more often without."""
    return [words, *[[*words, "--no-plots"]] * 7]


def of_runs(csgsim: str) -> list[Sample]:
    """Samples whose files are written by csgsim."""
    samples = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "m.csg").write_text(CUBE)
        shutil.copy(SOURCE / "tests/fuzz/corpus/program_text/two_stack.csgt", folder / "p.csgt")

        def run(*words: str):
            done = subprocess.run([csgsim, *words], cwd=folder, capture_output=True, check=False)
            if done.returncode:
                sys.exit(f"mutate_files.py: csgsim {' '.join(words)} ends with {done.returncode}: {done.stderr.decode()}")

        def files(*names: str) -> Files:
            return {one: (folder / one).read_bytes() for one in names}

        render = ["render", "m.csg", *SMALL]
        for more in ([], ["--machine", "scan-line", "--set", "cells.words=6", "--camera", "9,-9,9,0,0,0"], ["--check", "--advice"]):
            run(*render, *more, "--stats", "s.json")
            samples.append(Sample("stats", files("m.csg", "s.json"), "s.json", [["rerun", "s.json", "--anyway", "-o", "p.png"]], ("p.png",)))
        run("run", "p.csgt", "--stats", "s.json")
        samples.append(Sample("stats", files("p.csgt", "s.json"), "s.json", [["rerun", "s.json", "-o", "p.png"]], ("p.png",)))

        run("run", "p.csgt", "--checkpoint", "c.csgs", "--checkpoint-every", "20")
        if (folder / "c.csgs").exists():
            samples.append(Sample("checkpoint", files("p.csgt", "c.csgs"), "c.csgs", [["run", "p.csgt", "--resume", "c.csgs", "--stats", "s.json"]],
                                  ("s.json",), sealed_at_end))

        studies = {
            "sweep": ["sweep", "m.csg", *SMALL, "--strategy", "stack,list,bits", "--stack-bits", "3,4", "--z-bits", "16,20"],
            "compare": ["compare", "m.csg", "--camera=9,-9,9,0,0,0", "--sides", "16,24", "--fragments", "5", "--machines",
                        "pixel-planes-4,scan-line", "--size", "16x16"],
            "accuracy": ["accuracy", "m.csg", "--size", "8x8", "--views", "1", "--knobs", "z-bits,fn,tolerance,together"],
            "corpus": ["corpus", "m.csg", "n.csg", *SMALL, "--machines", "pixel-planes-4,scan-line"],
            "subdivide": ["subdivide", "m.csg", *SMALL, "--subdivisions", "0,2", "--tolerances", "1,0.5"],
            "explore": ["explore", "m.csg", "n.csg", *SMALL, "--vary", "alu.bits=1,4", "--vary", "z-bits=12,16"],
            "advise": ["advise", "m.csg", *SMALL, "--strategy", "stack,list", "--z-bits", "16", "--fraction-bits", "6"],
        }
        (folder / "n.csg").write_text(CUBE.replace("8", "7"))
        for study, words in studies.items():
            out = folder / "out"
            shutil.rmtree(out, ignore_errors=True)
            run(*words, "-o", "out", "--no-plots")
            table = f"out/{study}.csv"
            beside = files("m.csg", "n.csg", table, f"out/{study}.study")
            again = words + ["-o", "out"]
            samples.append(Sample("table", beside, table, seldom_plotted(again), ("out/",)))
            if study == "advise":
                continue
            shutil.rmtree(out)
            for shard in ("1/2", "2/2"):
                run(*words, "--shard", shard, "-o", "out")
            shards = [str(path.relative_to(folder)) for path in sorted(out.glob("shards/*.shard"))]
            for changed in shards:
                samples.append(Sample("shard", files("m.csg", "n.csg", *shards), changed,
                                      [*seldom_plotted(["gather", "out"]), ["gather", "out", "--missing"],
                                       ["gather", "out", "--no-plots", "--report", "p.html"]],
                                      ("out/", "p.html")))
    return samples


# ---- cases ----

def limits():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_FILE, MOST_FILE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


@dataclasses.dataclass
class Ended:
    code: int | None  # None after a time-out
    err: str
    seconds: float


def worked(pid: int) -> float:
    """Processor seconds of the process and of the children it has waited for."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def wait_for(pid: int, ended, limit: float) -> int | None:
    """The first result of ended(seconds); None if the process works for longer than the limit, or is idle as long. Other load
    on the computer does not count."""
    last, since = 0.0, time.monotonic()
    while True:
        code = ended(min(limit, 0.5) if last else limit)
        if code is not None:
            return code
        now = worked(pid)
        if now > last + 0.05:
            last, since = now, time.monotonic()
        if now > limit or time.monotonic() - since > limit:
            return None


def kill_group(pid: int):
    """Processes started by the process."""
    try:
        os.killpg(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


class Starter:
    """Starts csgsim separately for each case."""

    def __init__(self, csgsim: str):
        self.csgsim = csgsim

    def code_of(self, words: list[str], folder: pathlib.Path, err: pathlib.Path, limit: float) -> int | None:
        with open(err, "wb") as file:
            child = subprocess.Popen([self.csgsim, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                     stderr=file, preexec_fn=limits, start_new_session=True)

        def ended(seconds: float) -> int | None:
            try:
                return child.wait(seconds)
            except subprocess.TimeoutExpired:
                return None

        code = wait_for(child.pid, ended, limit)
        kill_group(child.pid)
        child.wait()
        return code


class Server:
    """One csgsim that forks for each case."""

    def __init__(self, csgsim: str, library: str):
        requests, self.asked = os.pipe()
        self.answers, answering = os.pipe()

        def connect():
            # Copies both to descriptors beyond 4 first, so that neither overwrites the other.
            copies = os.dup(requests), os.dup(answering)
            copies = tuple(fcntl.fcntl(one, fcntl.F_DUPFD, 10) for one in copies)
            os.dup2(copies[0], 3)
            os.dup2(copies[1], 4)
            os.closerange(5, 100)
            limits()

        subprocess.Popen([csgsim], env={**os.environ, "LD_PRELOAD": str(pathlib.Path(library).resolve())}, stdin=subprocess.DEVNULL,
                         preexec_fn=connect, close_fds=False)
        os.close(requests)
        os.close(answering)
        self.csgsim = csgsim

    def answer(self) -> int:
        text = os.read(self.answers, 4)
        if len(text) != 4:
            sys.exit("mutate_files.py: the server has ended")
        return int.from_bytes(text, sys.byteorder, signed=True)

    def code_of(self, words: list[str], folder: pathlib.Path, err: pathlib.Path, limit: float) -> int | None:
        text = b"".join(os.fsencode(word) + b"\0" for word in [folder, err, self.csgsim, *words])
        os.write(self.asked, len(text).to_bytes(4, sys.byteorder) + text)
        pid = self.answer()

        def ended(seconds: float) -> int | None:
            ready, _, _ = select.select([self.answers], [], [], seconds)
            return os.waitstatus_to_exitcode(self.answer()) if ready else None

        code = wait_for(pid, ended, limit)
        kill_group(pid)
        if code is None:
            self.answer()
        return code


def run_limited(starter: Starter | Server, words: list[str], folder: pathlib.Path, limit: float) -> Ended:
    begin = time.monotonic()
    err = folder.parent / "err"
    code = starter.code_of(words, folder, err, limit)
    with open(err, "rb") as file:
        text = file.read(20_000).decode(errors="replace")
    return Ended(code, text, time.monotonic() - begin)


def state_of(folder: pathlib.Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def may_be_written(name: str, writes: tuple[str, ...]) -> bool:
    return any(name == one or one == "*" or (one.endswith("/") and name.startswith(one)) for one in writes)


def faults_of(ended: Ended, before: dict[str, bytes], after: dict[str, bytes], sample: Sample) -> str:
    if ended.code is None:
        return "out of time"
    if ended.code < 0:
        return signal.Signals(-ended.code).name
    if ended.code not in (0, 1, 2):
        return f"exit {ended.code}"
    if "report it" in ended.err and "if the error remains, report it" not in ended.err:
        return "asks to report it"
    if ended.code != 0 and not ended.err.strip():
        return "says nothing"
    for name, text in after.items():
        if before.get(name) != text and not may_be_written(name, sample.writes):
            return f"writes {pathlib.Path(name).name if name in before else 'a new file'}"
    return ""


def write_case(sample: Sample, folder: pathlib.Path, files: Files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)


def changed_text(sample: Sample, others: list[bytes], rng: random.Random) -> bytes:
    text = sample.files[sample.changed]
    if sample.kind in ("3mf", "amf") and text[:2] == b"PK" and rng.randrange(4):
        with zipfile.ZipFile(io.BytesIO(text)) as archive:
            members = {name: archive.read(name) for name in archive.namelist()}
        name = rng.choice(sorted(members))
        members[name] = mutate(members[name], others, rng)
        return rezipped(members, name)
    text = mutate(text, others, rng)
    return sample.seal(text) if sample.seal and rng.randrange(16) else text


class Search:
    def __init__(self, arguments: argparse.Namespace, samples: list[Sample]):
        self.arguments = arguments
        self.by_kind: dict[str, list[Sample]] = collections.defaultdict(list)
        for sample in samples:
            self.by_kind[sample.kind].append(sample)
        self.kinds = sorted(self.by_kind)
        self.out = pathlib.Path(arguments.out)
        self.csgsim = str(pathlib.Path(arguments.csgsim).resolve())
        self.of_thread = threading.local()

    def starter(self) -> Starter | Server:
        if not hasattr(self.of_thread, "starter"):
            library = self.arguments.server
            self.of_thread.starter = Server(self.csgsim, library) if library else Starter(self.csgsim)
        return self.of_thread.starter

    def case(self, number: int) -> tuple[str, str, Ended, list[str]]:
        """Runs the case of that number; returns its kind and violation."""
        rng = random.Random(f"{self.arguments.seed} {number}")
        sample = rng.choice(self.by_kind[self.kinds[number % len(self.kinds)]])
        others = [one.files[one.changed] for one in self.by_kind[sample.kind]]
        files = dict(sample.files)
        files[sample.changed] = changed_text(sample, others, rng)
        command = rng.choice(sample.commands)
        with tempfile.TemporaryDirectory(prefix="mutate-") as name:
            folder = pathlib.Path(name) / "case"
            folder.mkdir()
            write_case(sample, folder, files)
            before = state_of(folder)
            ended = run_limited(self.starter(), command, folder, self.arguments.limit)
            wrong = faults_of(ended, before, state_of(folder), sample)
            if wrong:
                self.keep(number, sample, files, command, wrong, ended)
        return sample.kind, wrong, ended, command

    def keep(self, number: int, sample: Sample, files: Files, command: list[str], wrong: str, ended: Ended):
        folder = self.out / f"{sample.kind}-{wrong}-{number}".replace(" ", "_").replace("/", "_")
        folder.mkdir(parents=True, exist_ok=True)
        write_case(sample, folder, files)
        (folder / "command").write_text("\0".join(command))
        (folder / "said").write_text(f"{wrong}\n{ended.err}")

    def run(self) -> int:
        begin = time.monotonic()
        cases = collections.Counter()
        wrong_ones: dict[tuple[str, str, str], list[int]] = collections.defaultdict(list)
        slowest: dict[str, float] = collections.defaultdict(float)
        seconds: dict[str, float] = collections.defaultdict(float)

        def goes_on(number: int) -> bool:
            if self.arguments.cases:
                return number < self.arguments.first + self.arguments.cases
            return time.monotonic() - begin < 60 * self.arguments.minutes

        next_told = 60.0
        with concurrent.futures.ThreadPoolExecutor(self.arguments.jobs) as pool:
            number = self.arguments.first
            running: dict[concurrent.futures.Future, int] = {}
            while running or goes_on(number):
                while len(running) < self.arguments.jobs and goes_on(number):
                    running[pool.submit(self.case, number)] = number
                    number += 1
                done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
                for one in done:
                    kind, wrong, ended, _ = one.result()
                    cases[kind] += 1
                    seconds[kind] += ended.seconds
                    slowest[kind] = max(slowest[kind], ended.seconds)
                    if wrong:
                        said = re.sub(r"\d+|'.*?'", "#", ended.err.strip().split("\n")[-1])[:100]
                        wrong_ones[(kind, wrong, said)].append(running[one])
                    del running[one]
                minutes = (time.monotonic() - begin) / 60
                if 60 * minutes > next_told:
                    next_told += 60
                    print(f"{cases.total()} cases, {cases.total() / minutes:.0f} a minute, {sum(map(len, wrong_ones.values()))} findings", flush=True)
        minutes = (time.monotonic() - begin) / 60
        print(f"\n{'kind':<14}{'cases':>8}{'mean, s':>12}{'slowest, s':>12}")
        for kind in self.kinds:
            print(f"{kind:<14}{cases[kind]:>8}{seconds[kind] / max(cases[kind], 1):>12.3f}{slowest[kind]:>12.1f}")
        print(f"\n{cases.total()} cases in {minutes:.1f} minutes, {cases.total() / max(minutes, 1e-9):.0f} a minute; seed {self.arguments.seed}, "
              f"the next is --first {number}")
        for (kind, wrong, said), numbers in sorted(wrong_ones.items()):
            print(f"{kind}: {wrong}, {len(numbers)} times, as in {self.out}/*-{numbers[0]}: {said}")
        return 1 if wrong_ones else 0


def run_again(csgsim: str, finding: pathlib.Path, limit: float) -> int:
    command = (finding / "command").read_text().split("\0")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "case"
        shutil.copytree(finding, folder)
        ended = run_limited(Starter(str(pathlib.Path(csgsim).resolve())), command, folder, limit)
    print(f"csgsim {' '.join(command)}: exit {ended.code}, {ended.seconds:.1f} s\n{ended.err}")
    return 0 if ended.code in (0, 1, 2) else 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("csgsim")
    parser.add_argument("--minutes", type=float, default=1)
    parser.add_argument("--cases", type=int, default=0, help="number of cases, instead of a time")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--seed", default="1987")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--kinds", default="", help="comma-separated list; default all")
    parser.add_argument("--limit", type=float, default=20, help="time limit of a case in seconds")
    parser.add_argument("--out", default="findings")
    parser.add_argument("--server", help="library that forks csgsim")
    parser.add_argument("--again", help="folder of a finding")
    arguments = parser.parse_args()
    if arguments.again:
        return run_again(arguments.csgsim, pathlib.Path(arguments.again), arguments.limit)
    samples = of_sources() + of_runs(str(pathlib.Path(arguments.csgsim).resolve()))
    known = sorted({sample.kind for sample in samples})
    kinds = arguments.kinds.split(",") if arguments.kinds else known
    if not set(kinds) <= set(known):
        parser.error(f"the kinds are {', '.join(known)}")
    return Search(arguments, [sample for sample in samples if sample.kind in kinds]).run()


if __name__ == "__main__":
    sys.exit(main())
