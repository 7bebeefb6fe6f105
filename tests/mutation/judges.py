"""The tests that judge mutants: targets to build, commands to run, and usual times."""

import concurrent.futures
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

PICTURES = ["rules", "strategies", "golden", "hard_cases", "agreement"]
JUDGES_OF = {  # in the order of execution
    "hw/base": ["base", "isa", "read"],
    "hw/isa": ["isa", "view", "reference", "machines", "functional_lockstep", "golden", "lockstep_functional", "hard_cases"],
    "hw/division": ["division", "pixel_square_modules", "multi_processor_kind"],
    "hw/process": ["process", "studies"],
    "hw/processors": ["software", "host"],
    "hw/host": ["host"],
    "hw/machines": ["machines", "observe", "golden"],
    "hw/array": ["array", "pixel_planes", "pixel_square", "lockstep_cycle", "lockstep_squares", "lockstep_models"],
    "hw/wave": ["waves", "cycle"],
    "hw/link": ["link", "cycle", "pixel_square_modules", "scan_line", "pixel_planes"],
    "hw/pixel_planes": ["machines", "pixel_planes", "lockstep_planes", "lockstep_cycle"],
    "hw/scan_line": ["machines", "scan_line", "scan_line_array", "lockstep_scan_line"],
    "hw/pixel_square": ["machines", "pixel_square_modules", "pixel_square", "lockstep_squares"],
    "hw/multi_processor": ["machines", "multi_processor_kind", "multi_processor", "lockstep_multi_processor"],
    "hw/bit_serial_memory": ["bit_serial_memory", "machines", "layers"],
    "hw/kinds": ["machines", "kinds"],
    "hw/systemc": ["cycle", "pixel_planes", "scan_line", "pixel_square_modules", "elaboration"],
    "host/model": ["functions", "read", "facet", "solids"],
    "host/read": ["read", "corpus"],
    "host/commands": ["commands"],
    "host/swept": ["swept"],
    "host/flat": ["flat", "read", "corpus"],
    "host/flat/dxf": ["flat", "corpus"],
    "host/flat/lettering": ["flat", "corpus"],
    "host/flat/svg": ["flat", "corpus"],
    "host/facet": ["facet", "csg", "view", "judges", "emit", *PICTURES],
    "host/view": ["view", "csg", "judges", "emit", *PICTURES, "studies"],
    "host/convex": ["convex", "effects", "scenes"],
    "host/solids": ["solids", "sweep", "read", "corpus"],
    "host/scene": ["scene", "effects", "scenes"],
    "host/lighting": ["scene", "emit", "effects", "scenes"],
    "host/csg": ["csg", "emit", *PICTURES, "studies"],
    "host/emit": ["emit", *PICTURES, "lockstep_models", "studies"],
    "host/setup": ["setup", "session", "studies"],
    "host/effects": ["effects", "scene", "story", "scenes"],
    "sim/reference": ["reference", "functional_lockstep", "lockstep_functional", "checkpoint"],
    "sim/functional": ["functional", "functional_lockstep", "lockstep_functional", "threads", "golden"],
    "sim/cycle": ["cycle", "elaboration", "lockstep_cycle", "golden"],
    "sim/waves": ["waves", "cli"],
    "sim/rows": ["rows", "cli"],
    "sim/rtl": ["rtl", "cli"],
    "sim/story": ["story", "cli"],
    "sim/suite": ["suite", "benchmark", "cli"],
    "sim/checkpoint": ["checkpoint", "cli"],
    "sim/lockstep": ["lockstep", "cli"],
    "sim/debug": ["debug", "cli"],
    "sim/judges": ["judges", "hard_cases", "studies"],
    "sim/plots": ["plots", "studies"],
    "sim/pictures": ["pictures", "observe", "picture_faults"],
    "sim/report": ["report", "cli"],
    "sim/viewer": ["viewer"],
    "sim/viewer/server": ["viewer"],
    "sim/web/lacking": ["web"],
    "sim/web/wasm": ["web"],
    "sim/system": ["system", "cli"],
    "sim/session/model": ["session", "cli"],
    "sim/session/options": ["session", "cli"],
    "sim/session/run": ["session", "cli"],
    "sim/observe": ["observe", "long_work", "report", "cli"],
    "sim/app": ["cli"],
    "sim/app/commands": ["cli"],
    "sim/shell": ["cli"],
    "sim/shell/manual": ["cli"],
    "sim/shell/settings": ["cli"],
    "sim/software": ["software", "cli"],
    "sim/software/convert": ["convert", "cli"],
    "sim/software/display": ["software", "cli"],
    "sim/software/facets": ["software"],
    "sim/software/methods": ["software", "m68000", "cli"],
    "sim/software/planes": ["convert", "software"],
    "sim/software/rays": ["software", "hard_cases"],
    "sim/software/space": ["software"],
    "sim/software/tracing": ["software", "scenes"],
    "sim/software/traversals": ["software", "m68000"],
    "sim/software/tree": ["software"],
    "sim/studies": ["studies", "new_study", "cli"],
    "sim/studies/accuracy": ["studies", "cli"],
    "sim/studies/advise": ["studies", "cli"],
    "sim/studies/classify": ["cli"],
    "sim/studies/design": ["studies", "cli"],
    "sim/studies/display": ["cli"],
    "sim/studies/explore": ["studies", "cli"],
    "sim/studies/trace": ["cli"],
    "sim/studies/compare": ["studies", "cli"],
    "sim/studies/corpus": ["studies", "cli"],
    "sim/studies/mesh": ["cli"],
    "sim/studies/sensitivity": ["studies", "cli"],
    "sim/studies/subdivide": ["cli"],
    "sim/studies/sweep": ["studies", "cli"],
}
BY_CASE = {  # run like ctest, usually one process per test case: SystemC elaborates once
    "pixel_planes", "pixel_square", "pixel_square_modules", "scan_line", "scan_line_array", "cycle", "elaboration", "kinds", "link",
    "multi_processor", "multi_processor_kind", "waves", "debug", "long_work", "checkpoint", "picture_faults", "cli", "corpus"}
BY_FILE = {"cli"}  # takes minutes, and has a test file for most files that it judges
TOO_SLOW = ["*half a million facets*", "*turned by 1e-7*"]
LEFT_OUT = {"hard_cases": ["--source-file-exclude=*hard_cases_many*"]}  # trees of 10,000 nodes take minutes
RANDOM = "seed=1 noshrink=1"
PATIENCE = 10  # multiple of the usual time
LEAST_TIME_LIMIT = 10.0  # in seconds
MEMORY = 12 << 30  # bytes of address space; a test checks the 8 GiB limit of a child process


@dataclass(frozen=True)
class Outcome:
    result: str  # passed, failed, timeout or uncompilable
    text: str = ""


def run(command, seconds, cwd=None, environment=None, memory=None):
    """Runs a command, which ends together with all processes it started; returns its Outcome."""
    limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))) if memory else None
    process = subprocess.Popen(
        command, cwd=cwd, env={**os.environ, **(environment or {})}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, start_new_session=True, preexec_fn=limit)
    try:
        output, _ = process.communicate(timeout=seconds)
        return Outcome("passed" if process.returncode == 0 else "failed", output.decode(errors="replace"))
    except subprocess.TimeoutExpired:
        return Outcome("timeout")
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()


def target_of(judge):
    return judge if judge.startswith("lockstep_") else f"test_{judge}"


def environment_of(test):
    """The environment that ctest sets for a test."""
    set_ = next((one["value"] for one in test.get("properties", []) if one["name"] == "ENVIRONMENT"), [])
    return dict(word.split("=", 1) for word in set_)


class Judges:
    def __init__(self, root, build, jobs, excepted=(), near=False):
        self.root = root
        self.build = build
        self.jobs = jobs
        self.excepted = excepted
        self.near = near
        self.usual_file = build / "mutation-usual-seconds.json"
        self.usual = json.loads(self.usual_file.read_text()) if self.usual_file.exists() else {}
        self.commands = {}

    def is_of_another_tree(self):
        cache = self.build / "CMakeCache.txt"
        return cache.exists() and f"\nCMAKE_HOME_DIRECTORY:INTERNAL={self.root}\n" not in cache.read_text()

    def configure(self):
        """Configures the build folder, including one copied from another tree, which would otherwise build that tree."""
        if self.is_of_another_tree():
            for entry in self.build.iterdir():
                if entry.is_dir():
                    shutil.rmtree(entry)
                elif not entry.name.startswith("mutation-"):
                    entry.unlink()
        if not (self.build / "build.ninja").exists():
            # GCC 12 falsely reports this warning for Boost's small_vector at -O1.
            flags = "-DCMAKE_CXX_FLAGS=-O1 -Wno-stringop-overread"
            subprocess.run(["cmake", "-S", self.root, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=", flags,
                            "-DCSGSIM_PRECOMPILE=ON", "-DCSGSIM_BATCH_TESTS=ON"], check=True)

    def make(self, judge):
        """Builds the judge."""
        outcome = run(["ninja", "-C", self.build, f"-j{self.jobs}", target_of(judge)], 3600)
        if outcome.result == "failed" and re.search(r"error:|undefined reference", outcome.text):
            return Outcome("uncompilable", outcome.text)
        return outcome

    def commands_of(self, judge):
        if judge not in self.commands:
            self.commands[judge] = list(self.find_commands(judge))
        return self.commands[judge]

    def find_commands(self, judge):
        program = str(self.build / target_of(judge))
        environment = {"RC_PARAMS": RANDOM}
        if not judge.startswith("lockstep_") and judge not in BY_CASE:
            left_out = ",".join([*TOO_SLOW, *self.excepted])
            yield [program, "--abort-after=1", "--no-colors=1", *LEFT_OUT.get(judge, []),
                   f"--test-case-exclude={left_out}"], environment
            return
        listing = subprocess.run(["ctest", "--test-dir", self.build, "--show-only=json-v1"], check=True,
                                 capture_output=True)
        for test in json.loads(listing.stdout)["tests"]:
            command = test.get("command", [""])
            if command[0] != program:
                continue
            if judge == "lockstep_squares":
                environment = {"RC_PARAMS": f"{RANDOM} max_success=30"}
            yield command, environment | environment_of(test)

    def ask(self, judge, about=""):
        """The judge's verdict on the current sources; tests in files named like `about` run first."""
        made = self.make(judge)
        if made.result != "passed":
            return made
        end = time.monotonic() + max(LEAST_TIME_LIMIT, PATIENCE * self.usual.get(judge, 60.0))

        def outcome_of(command, environment):
            return run(command, max(1.0, end - time.monotonic()), self.build, environment, MEMORY)

        if about and judge in BY_FILE:
            outcome = outcome_of(*self.command_about(judge, about))
            if outcome.result != "passed" or self.near:
                return outcome
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            running = [pool.submit(outcome_of, *command) for command in self.commands_of(judge)]
            for done in concurrent.futures.as_completed(running):
                if done.result().result != "passed":
                    pool.shutdown(wait=False, cancel_futures=True)
                    return done.result()
        return Outcome("passed")

    def command_about(self, judge, file):
        """The tests of a judge whose file name shares a word with another file's name."""
        words = ",".join(f"*{word}*" for word in Path(file).stem.split("_") if len(word) > 2)
        return [str(self.build / target_of(judge)), "--abort-after=1", f"--source-file={words}"], {"RC_PARAMS": RANDOM}

    def measure(self, judges):
        """Checks that every judge passes the unmodified sources, and records its time."""
        for judge in judges:
            if judge in self.usual:
                continue
            made = self.make(judge)
            start = time.monotonic()
            outcome = self.ask(judge) if made.result == "passed" else made
            if outcome.result != "passed":
                raise SystemExit(f"mutate.py: {judge} does not pass without any mutation ({outcome.result}):\n"
                                 f"{outcome.text[-3000:]}")
            self.usual[judge] = time.monotonic() - start
            self.usual_file.write_text(json.dumps(self.usual, indent=1))
            print(f"{judge}: passes in {self.usual[judge]:.1f} s", flush=True)
