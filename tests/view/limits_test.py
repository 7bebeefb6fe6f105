#!/usr/bin/env python3
"""The limits of csgsim view, on requests and on evaluations: limits_test.py CSGSIM SOURCE [NAMES...]"""

import contextlib
import gzip
import http.client
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from server import Server, answer_from

CSGSIM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
MODEL = "tests/models/thesis_fig_2_3.csg"


def run(*words, **options):
    return subprocess.run([CSGSIM, *words], cwd=SOURCE, check=False, text=True, capture_output=True, **options)


class Limits(unittest.TestCase):
    """No request deprives others of memory, threads or time, with the token or without."""

    MOST_MEMORY = 150 << 20

    @classmethod
    def setUpClass(cls):
        cls.server = Server(CSGSIM, MODEL, "--size", "32x24", cwd=SOURCE)
        cls.server.post("draw", {})

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def tearDown(self):
        self.assertIsNone(self.server.process.poll())
        self.assertEqual(self.server.post("draw", {})[0], 200)
        self.assertLess(self.server.most_memory(), self.MOST_MEMORY)

    def stranger(self, fields=""):
        return f"POST /x HTTP/1.1\r\nHost: evil.example\r\n{fields}".encode()

    def own(self, fields=""):
        return (f"POST /{self.server.token}/draw HTTP/1.1\r\nHost: {self.server.host}\r\nOrigin: http://{self.server.host}\r\n"
                f"Content-Type: application/json\r\n{fields}").encode()

    def refused(self, status, *pieces):
        answer = self.server.raw(*pieces)
        self.assertIsNotNone(answer)
        self.assertEqual(answer[0], status, answer)
        self.assertTrue(json.loads(answer[1])["error"])

    def test_rejects_an_endless_header(self):
        for begin in (self.stranger(), self.own()):
            self.refused(431, begin + b"X: ", *[b"a" * (1 << 20)] * 50)
            self.refused(431, begin, *[b"a: b\r\n" * 100_000] * 50)
            self.refused(431, begin + b"a: b\r\n" * 101 + b"\r\n")
        self.refused(431, b"GET /" + b"a" * 100_000)

    def test_rejects_a_body_without_a_length(self):
        megabyte = b"a" * (1 << 20)
        chunks = [b"100000\r\n" + megabyte + b"\r\n"] * 50
        self.refused(403, self.stranger("Transfer-Encoding: chunked\r\n\r\n"), *chunks)
        self.refused(411, self.own("Transfer-Encoding: chunked\r\n\r\n"), *chunks)
        self.refused(403, self.stranger("\r\n"), *[megabyte] * 50)
        self.refused(411, self.own("\r\n"), *[megabyte] * 50)

    def test_rejects_a_compressed_body(self):
        bomb = gzip.compress(bytes(1 << 20)) * 1000
        fields = f"Content-Encoding: gzip\r\nContent-Length: {len(bomb)}\r\n\r\n"
        self.refused(403, self.stranger(fields), bomb)
        self.refused(415, self.own(fields), bomb)

    def test_accepts_a_body_up_to_its_limit(self):
        most = 4 << 20
        body = b'{"source": ""}'
        self.refused(413, self.own(f"Content-Length: {most + 1}\r\n\r\n"))
        status, _ = self.server.raw(self.own(f"Connection: close\r\nContent-Length: {most}\r\n\r\n"), body + b" " * (most - len(body)))
        self.assertIn(status, (200, 422))

    def test_rejects_json_with_too_deep_nesting_or_too_many_elements(self):
        deep = "[" * 200_000 + "]" * 200_000
        wide = ",".join(f'"k{i}":1' for i in range(300_000))
        for body in (deep, f'{{"knobs":{{"size":{deep}}}}}', f'{{"a":{deep},"b":{{}}}}', f'{{"knobs":{{"set":{deep}}}}}', f'{{{wide}}}',
                     f'{{"knobs":{{"set":[{",".join(["1"] * 500_000)}]}}}}'):
            for question in ("draw", "two", "instant", "lanes", "cancel"):
                begin = time.monotonic()
                status, _, answer = self.server.ask("POST", f"/{self.server.token}/{question}", body)
                self.assertEqual(status, 400)
                self.assertRegex(answer, rb"nested deeper|more than|too many")
                self.assertLess(time.monotonic() - begin, 10)

    def test_slow_connections_time_out_without_delaying_other_requests(self):
        begin = time.monotonic()
        slow = [socket.create_connection(("127.0.0.1", self.server.port), timeout=30) for _ in range(30)]
        for connection in slow:
            connection.sendall(self.stranger() + b"X: ")
        for _ in range(3):
            asked = time.monotonic()
            self.assertEqual(self.server.post("draw", {})[0], 200)
            self.assertLess(time.monotonic() - asked, 5)
            time.sleep(2.5)
            for connection in slow:
                connection.sendall(b"a")
        self.assertEqual([answer_from(connection)[0] for connection in slow], [408] * len(slow))
        self.assertLess(time.monotonic() - begin, 30)
        for connection in slow:
            connection.close()

    def test_a_connection_with_a_slow_body_times_out(self):
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=30) as connection:
            connection.sendall(self.own("Content-Length: 100\r\n\r\n"))
            for _ in range(4):
                time.sleep(2)
                connection.sendall(b" ")
            status, body = answer_from(connection)
        self.assertEqual(status, 408)
        self.assertTrue(json.loads(body)["error"])

    def test_many_idle_connections_occupy_few_threads_and_descriptors(self):
        idle = [socket.create_connection(("127.0.0.1", self.server.port), timeout=30) for _ in range(200)]
        self.assertEqual(self.server.post("draw", {})[0], 200)
        threads = pathlib.Path(f"/proc/{self.server.process.pid}/status").read_text()
        self.assertLess(int(threads.split("Threads:")[1].split()[0]), 16)
        self.assertLess(len(list(pathlib.Path(f"/proc/{self.server.process.pid}/fd").iterdir())), 80)
        for connection in idle:
            connection.close()

    def test_answers_every_pipelined_request(self):
        one = f"GET /{self.server.token}/view.js HTTP/1.1\r\nHost: {self.server.host}\r\n\r\n"
        last = one.replace("\r\n\r\n", "\r\nConnection: close\r\n\r\n")
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=30) as connection:
            connection.sendall((one * 20 + last).encode())
            data = b""
            while block := connection.recv(65536):
                data += block
        self.assertEqual(data.count(b"HTTP/1.1 200 OK\r\n"), 21)


SCAD = """#!/bin/sh
# Stands in for OpenSCAD: the evaluation of an endless text never ends.
text=$(cat)
case "$text" in *endless*) echo $$ > "$CSGSIM_TEST_PID"; sleep 1000;; *) printf '%s\\n' "$text";; esac
"""


class Evaluation(unittest.TestCase):
    """An endless evaluation delays no other request, and is terminated."""

    CUBE = {"source": "cube(size=[1,2,3],center=true);"}
    ENDLESS = {"source": "endless();"}

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        folder = pathlib.Path(self.folder.name)
        (folder / "openscad").write_text(SCAD)
        (folder / "openscad").chmod(0o755)
        (folder / "model.scad").write_text("cube(size=[1,2,3],center=true);\n")
        self.pid = folder / "pid"
        self.env = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}", "CSGSIM_TEST_PID": str(self.pid)}

    def serve(self, *words, model="model.scad"):
        server = Server(CSGSIM, str(pathlib.Path(self.folder.name) / model), "--size", "32x24", *words, env=self.env)
        self.addCleanup(server.stop)
        return server

    def begun(self, server, request):
        """Starts a thread that requests an evaluation; returns it and its answers once OpenSCAD has started."""
        answers = []

        def ask():
            begin = time.monotonic()
            with contextlib.suppress(OSError, http.client.HTTPException):
                answers.append((*server.post("draw", request), time.monotonic() - begin))

        thread = threading.Thread(target=ask)
        thread.start()
        end = time.monotonic() + 30
        while not self.pid.exists() and time.monotonic() < end:
            time.sleep(0.02)
        self.assertTrue(self.pid.exists())
        return thread, answers

    def openscad_has_ended(self):
        end = time.monotonic() + 10
        while time.monotonic() < end:
            try:
                os.kill(int(self.pid.read_text()), 0)
            except ProcessLookupError:
                return True
            time.sleep(0.05)
        return False

    def test_an_evaluation_ends_at_its_time_limit_without_delaying_other_requests(self):
        server = self.serve("--evaluation-time", "3")
        self.assertEqual(server.post("draw", {})[0], 200)
        thread, answers = self.begun(server, self.ENDLESS)
        for question, request in (("draw", {}), ("explain", {"pixel": "16,12"}), ("instant", {"number": 3}), ("tree", {}), ("draw", self.CUBE),
                               ("draw", {"knobs": {"camera": "3,-10,9,0,0,2"}})):
            status, answer = server.post(question, request)
            self.assertEqual(status, 200, answer)
        self.assertTrue(thread.is_alive())
        thread.join()
        (status, answer, seconds), = answers
        self.assertEqual(status, 422)
        self.assertIn("longer than 3 s", answer["error"])
        self.assertIn("--evaluation-time", answer["error"])
        self.assertGreaterEqual(seconds, 3)
        self.assertLess(seconds, 15)
        self.assertTrue(self.openscad_has_ended())

    def test_an_evaluation_is_cancelled_by_its_name(self):
        server = self.serve("--evaluation-time", "600")
        thread, answers = self.begun(server, self.ENDLESS | {"evaluation": "mine"})
        self.assertEqual(server.post("progress", {"evaluation": "other"}), (200, {}))
        status, progress = server.post("progress", {"evaluation": "mine"})
        self.assertEqual((status, progress["doing"], progress["most"]), (200, "evaluating the model", 600))
        server.post("cancel", {"evaluation": "other"})
        time.sleep(0.3)
        self.assertTrue(thread.is_alive())
        self.assertEqual(server.post("cancel", {"evaluation": "mine"})[0], 200)
        thread.join(20)
        self.assertFalse(thread.is_alive())
        self.assertEqual((answers[0][0], answers[0][1]["cancelled"]), (422, True))
        self.assertTrue(self.openscad_has_ended())
        self.assertEqual(server.post("draw", {})[0], 200)

    def test_the_default_evaluation_time_is_ten_seconds(self):
        self.assertRegex(" ".join(run("view", "--help").stdout.split()), r"--evaluation-time SECONDS [^\[]*\[[^\]]*; default: 10\]")
        server = self.serve()
        status, _, body = server.get("about")
        self.assertEqual((status, json.loads(body)["evaluation_time"]), (200, 10))

    def test_ctrl_c_ends_server_and_openscad_within_five_seconds(self):
        server = self.serve("--evaluation-time", "600")
        thread, _ = self.begun(server, self.ENDLESS | {"evaluation": "mine"})
        begin = time.monotonic()
        server.process.send_signal(signal.SIGINT)
        server.process.wait(20)
        self.assertLess(time.monotonic() - begin, 5)
        self.assertTrue(self.openscad_has_ended())
        thread.join(20)

    def test_closing_the_last_page_ends_server_and_openscad(self):
        server = self.serve("--evaluation-time", "600", "--patience", "1")
        thread, _ = self.begun(server, self.ENDLESS)
        server.stream().close()
        self.assertEqual(server.process.wait(20), 0)
        self.assertTrue(self.openscad_has_ended())
        thread.join(20)

    def test_rejects_pipes_and_devices_as_inputs_without_waiting(self):
        pipe = pathlib.Path(self.folder.name) / "pipe.csg"
        os.mkfifo(pipe)
        done = run("view", str(pipe), timeout=20)
        self.assertEqual(done.returncode, 1)
        self.assertIn("pipe or a device", done.stderr)
        os.mkfifo(scene := pathlib.Path(self.folder.name) / "scene.toml")
        done = run("view", MODEL, "--scene", str(scene), timeout=20)
        self.assertEqual(done.returncode, 1)
        self.assertIn("scene.toml: cannot be read: it is a pipe or a device", done.stderr)
        (pathlib.Path(self.folder.name) / "plain.csg").write_text("cube(size=[1,2,3],center=true);\n")
        server = self.serve(model="plain.csg")
        begin = time.monotonic()
        for source in ('surface(file="pipe.csg");', 'import(file="pipe.csg");', 'surface(file="/dev/zero");'):
            status, answer = server.post("draw", {"source": source})
            self.assertEqual(status, 422, answer)
        self.assertLess(time.monotonic() - begin, 10)

    def test_an_evaluation_that_includes_a_pipe_ends_at_the_time_limit(self):
        if not shutil.which("openscad"):
            self.skipTest("there is no openscad")
        os.mkfifo(pathlib.Path(self.folder.name) / "pipe.scad")
        self.env = None
        server = self.serve("--evaluation-time", "2")
        status, answer = server.post("draw", {"source": "include <pipe.scad>\ncube(1);\n"})
        self.assertEqual(status, 422)
        self.assertIn("longer than 2 s", answer["error"])
        self.assertEqual(server.post("draw", {})[0], 200)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
