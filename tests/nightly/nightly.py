#!/usr/bin/env python3
"""Repeats the property tests with random seeds. Writes each finding to a file with the command that repeats it."""

import argparse
import concurrent.futures
import json
import os
import random
import re
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

MARK = b"Using configuration:"  # printed by rapidcheck before the first property of a process
USUAL_TIMEOUT = 1500.0  # in seconds, ctest's default


@dataclass(frozen=True)
class Test:
    name: str
    command: tuple
    folder: str
    environment: dict
    timeout: float


def property_of(test, name, otherwise):
    return next((one["value"] for one in test.get("properties", []) if one["name"] == name), otherwise)


def has_rapidcheck(program, known={}):
    if program not in known:
        path = Path(program)
        known[program] = path.is_file() and MARK in path.read_bytes()
    return known[program]


def tests_of(build, pattern):
    """The tests of ctest whose program is linked with rapidcheck."""
    listing = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True)
    for test in json.loads(listing.stdout)["tests"]:
        command = test.get("command", [])
        if not command or not re.search(pattern, test["name"]) or not has_rapidcheck(command[0]):
            continue
        environment = dict(word.split("=", 1) for word in property_of(test, "ENVIRONMENT", []))
        yield Test(test["name"], tuple(command), property_of(test, "WORKING_DIRECTORY", str(build)), environment,
                   property_of(test, "TIMEOUT", USUAL_TIMEOUT))


def parameters_of(test, seed):
    """The test's RC_PARAMS, with the seed."""
    return f"{test.environment.get('RC_PARAMS', '')} seed={seed}".strip()


def run(test, seed):
    """(failure, output): an exit code, signal or time-out; empty if it passed."""
    environment = {**os.environ, **test.environment, "RC_PARAMS": parameters_of(test, seed)}
    try:
        process = subprocess.Popen(test.command, cwd=test.folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
    except OSError as error:
        return f"cannot be run: {error.strerror}", b""
    try:
        output, _ = process.communicate(timeout=test.timeout)
    except subprocess.TimeoutExpired:
        return f"no end after {test.timeout:.0f} s", b""
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
    if process.returncode == 0:
        return "", output
    return f"signal {-process.returncode}" if process.returncode < 0 else f"exit code {process.returncode}", output


def repeat_command(test, seed):
    return f"RC_PARAMS={shlex.quote(parameters_of(test, seed))} {shlex.join(test.command)}"


def keep(folder, test, seed, why, output):
    folder.mkdir(parents=True, exist_ok=True)
    name = re.sub(r"[^A-Za-z0-9]+", "_", test.name)[:100].strip("_")
    path = folder / f"{name}-{seed}.txt"
    path.write_bytes(f"{test.name}: {why}\ncd {test.folder}\n{repeat_command(test, seed)}\n\n".encode() + output)
    return path


class Night:
    def __init__(self, options):
        self.options = options
        self.end = time.monotonic() + options.hours * 3600
        self.failed = []
        self.runs = 0

    def one(self, test, seed):
        """Runs the test; returns whether it checked any properties."""
        if time.monotonic() >= self.end:
            return False
        why, output = run(test, seed)
        self.runs += 1
        if why:
            path = keep(self.options.findings, test, seed, why, output)
            self.failed.append(f"{test.name}: {why}\n  {repeat_command(test, seed)}\n  {path}")
            print(f"FAILED  {self.failed[-1]}", flush=True)
        return MARK in output or bool(why)

    def round(self, number, tests, seed):
        """Runs a round; returns the tests that checked any properties."""
        print(f"round {number}: seed {seed}, {len(tests)} tests", flush=True)
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            drew = list(pool.map(lambda test: self.one(test, seed), tests))
        return [test for test, is_one in zip(tests, drew) if is_one]

    def all(self, tests):
        seeds = random.SystemRandom()
        number = 1
        while tests and time.monotonic() < self.end:
            seeds.shuffle(tests)  # short nights omit different tests each time
            drew = self.round(number, tests, seeds.getrandbits(63))
            if time.monotonic() < self.end:
                tests = drew
            number += 1


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path, help="a build folder with tests")
    parser.add_argument("--hours", type=float, default=2.0, help="duration in hours (%(default)s)")
    parser.add_argument("--tests", default="", metavar="REGEX", help="run only tests whose names match")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of concurrent tests (%(default)s)")
    parser.add_argument("--findings", type=Path, help="folder for findings (BUILD/nightly)")
    options = parser.parse_args(arguments)
    if not options.hours > 0:
        parser.error("--hours has to be more than 0")
    options.build = options.build.resolve()
    options.findings = options.findings or options.build / "nightly"
    return options


def main(arguments):
    options = parsed(arguments)
    tests = list(tests_of(options.build, options.tests))
    if not tests:
        sys.exit(f"nightly.py: {options.build} has no property tests of that name; build them first")
    night = Night(options)
    night.all(tests)
    print(f"{night.runs} runs, {len(night.failed)} failed" + "".join(f"\n{one}" for one in night.failed))
    return 1 if night.failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
