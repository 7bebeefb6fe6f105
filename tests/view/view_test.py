#!/usr/bin/env python3
"""Requests to csgsim view, from its page and from attackers: view_test.py CSGSIM SOURCE [NAMES...]"""

import base64
import json
import pathlib
import random
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from server import Server

CSGSIM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
MODEL = "tests/models/thesis_fig_2_3.csg"
SMALL = {"size": "64x48", "camera": "30,-40,25,0,0,2"}


def run(*words, **options):
    return subprocess.run([CSGSIM, *words], cwd=SOURCE, check=False, text=True, capture_output=True, **options)


def of_render(folder, *words):
    """The stats of csgsim render, without those that differ from run to run and without the configuration."""
    stats = pathlib.Path(folder) / "stats.json"
    picture = pathlib.Path(folder) / "picture.png"
    done = run("render", *words, "--stats", str(stats), "-o", str(picture), "--progress", "none")
    assert done.returncode == 0, done.stderr
    return without_wall(json.loads(stats.read_text())), picture.read_bytes()


def without_wall(value):
    if isinstance(value, dict):
        return {key: without_wall(each) for key, each in value.items() if not key.startswith("wall_seconds") and key != "configuration"}
    return [without_wall(each) for each in value] if isinstance(value, list) else value


class Answers(unittest.TestCase):
    """The page shows the results of the commands."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server(CSGSIM, MODEL, cwd=SOURCE)
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()
        cls.folder.cleanup()

    def test_serves_the_whole_page_with_a_strict_content_policy(self):
        for name, kind in (("", "text/html"), ("page.css", "text/css"), ("view.css", "text/css"), ("view.js", "text/javascript"), ("lanes.js", "text/javascript")):
            status, headers, body = self.server.get(name)
            self.assertEqual(status, 200)
            self.assertTrue(headers["Content-Type"].startswith(kind))
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
            self.assertNotIn("unsafe", headers["Content-Security-Policy"])
            self.assertEqual(headers["Cache-Control"], "no-store")
            self.assertNotIn(b"http://", body)

    def test_describes_the_model_and_its_options(self):
        status, _, body = self.server.get("about")
        about = json.loads(body)
        self.assertEqual(status, 200)
        self.assertEqual(about["source"], (SOURCE / MODEL).read_text())
        self.assertIn("pixel-planes-5", about["machines"])
        self.assertIn("bits", about["strategies"])

    def test_picture_and_stats_equal_those_of_render(self):
        for knobs in (SMALL, SMALL | {"machine": "pixel-planes-5"}, SMALL | {"machine": "scan-line", "projection": "perspective"},
                      SMALL | {"strategy": "bits", "z-bits": "16", "set": ["alu.bits=4"], "snap": True}):
            words = [word for name, value in knobs.items() for each in (value if isinstance(value, list) else [value])
                     for word in ([f"--{name}"] if each is True else [f"--{name}", each])]
            status, answer = self.server.post("draw", {"knobs": knobs})
            self.assertEqual(status, 200, answer)
            stats, picture = of_render(self.folder.name, MODEL, *words)
            self.assertEqual(without_wall(answer["stats"]), stats)
            self.assertEqual(answer["picture"], "data:image/png;base64," + base64.b64encode(picture).decode())
            again = subprocess.run(["bash", "-c", answer["command"].replace("csgsim", str(CSGSIM), 1) + " --stats -"], cwd=SOURCE,
                                   check=True, text=True, capture_output=True).stdout
            self.assertEqual(without_wall(json.loads(again)), stats)

    def test_a_turned_camera_changes_the_clocks_and_turning_back_restores_them(self):
        _, first = self.server.post("draw", {"knobs": SMALL})
        for eye in ("30,-40,25,0,0,2", "-20,35,11,0,0,2", "30,-40,25,0,0,2"):
            _, turned = self.server.post("draw", {"knobs": SMALL | {"camera": eye}})
            self.assertEqual(turned["stats"]["clocks"] == first["stats"]["clocks"], eye.startswith("30"))
            self.assertEqual(turned["camera"], eye)

    def test_explains_a_pixel_as_explain_does(self):
        status, answer = self.server.post("explain", {"knobs": SMALL, "pixel": "32,24", "why_not": "p1"})
        self.assertEqual(status, 200, answer)
        words = [word for name, value in SMALL.items() for word in (f"--{name}", value)]
        told = json.loads(run("explain", MODEL, *words, "--pixel", "32,24", "--why-not", "p1", "--json", "-").stdout)
        self.assertEqual(answer["story"], told)
        text = run("explain", MODEL, *words, "--pixel", "32,24", "--why-not", "p1").stdout
        self.assertEqual(answer["text"], text)

    def test_lanes_equal_those_of_wave(self):
        file = pathlib.Path(self.folder.name) / "parts.json"
        for machine in ("pixel-planes-4", "scan-line", "pixel-planes-5+ring.channels=4"):
            knobs = SMALL | {"machine": machine}
            words = [word for name, value in knobs.items() for word in (f"--{name}", value)]
            self.assertEqual(run("wave", MODEL, *words, "-o", str(file)).returncode, 0)
            recorded, parts, names = {}, {}, {}
            for event in json.loads(file.read_text())["traceEvents"]:
                if event["ph"] == "M":
                    (parts if event["name"] == "process_name" else names)[event["pid" if event["name"] == "process_name" else "tid"]] = event["args"]["name"]
                else:
                    recorded.setdefault((parts[event["pid"]], names[event["tid"]]), []).append((event["args"]["clock"], event["args"]["clocks"], event["name"]))
            status, whole = self.server.post("lanes", {"knobs": knobs})
            self.assertEqual(status, 200, whole)
            self.assertEqual((whole["begin"], whole["end"]), (whole["first"], whole["last"]))
            middle = whole["last"] // 3
            status, near = self.server.post("lanes", {"knobs": knobs, "begin": middle, "end": middle + 200})
            self.assertEqual(status, 200, near)
            for lane in near["lanes"]:
                within = [[max(begin, middle), min(begin + clocks, middle + 200) - max(begin, middle), text]
                          for begin, clocks, text in recorded.get((lane["part"], lane["name"]), []) if begin < middle + 200 and begin + clocks > middle]
                self.assertEqual(lane["stretches"], within, lane["name"])

    def test_a_pixels_wave_equals_that_of_wave_and_its_probes_have_lanes(self):
        knobs = {"size": "8x8", "z-bits": "8", "fraction-bits": "0"}
        probing = {"pixel": "5,3", "window": "i8:i9", "probes": ["tree.x:0", "tree.y:3"]}
        words = ["--size", "8x8", "--z-bits", "8", "--fraction-bits", "0", "--pixel", "5,3", "--window", "i8:i9", "--probe", "tree.x:0", "--probe", "tree.y:3"]
        status, answer = self.server.post("wave", {"knobs": knobs, **probing})
        self.assertEqual(status, 200, answer)
        self.assertEqual(answer["wave"], run("wave", MODEL, *words, "-o", "-").stdout)
        status, answer = self.server.post("lanes", {"knobs": knobs, **probing})
        self.assertEqual(status, 200, answer)
        lanes = {lane["name"]: lane["stretches"] for lane in answer["lanes"] if lane["part"] == "pixel_5_3"}
        self.assertTrue(lanes["tree_x_0"] and lanes["tree_y_3"] and lanes["enable"])

    def test_rejects_options_in_place_of_a_pixel_window_or_probe(self):
        for probing in ({"pixel": "5,3 -o x", "window": "i8"}, {"pixel": "--help", "window": "i8"}, {"pixel": "5,3", "window": "i8", "probes": ["--output=x"]},
                        {"pixel": "999,3", "window": "i8"}, {"pixel": "5,3", "window": "i999999"}):
            status, answer = self.server.post("wave", {"knobs": SMALL, **probing})
            self.assertEqual(status, 422, answer)
            self.assertNotIn("$date", answer["error"])
        for probing in ({"pixel": 5}, {"pixel": "5,3", "window": ["i8"]}, {"pixel": "5,3", "probes": "tree.x:1"}, {"begin": "x"}, {"begin": -1}):
            self.assertEqual(self.server.post("lanes", {"knobs": SMALL, **probing})[0], 400)

    def test_verdict_and_advice_equal_those_of_render(self):
        knobs = SMALL | {"z-bits": "8"}
        stats, _ = of_render(self.folder.name, MODEL, *[word for name, value in knobs.items() for word in (f"--{name}", value)], "--check", "--advice")
        status, answer = self.server.post("verdict", {"knobs": knobs})
        self.assertEqual((status, answer.get("accuracy")), (200, stats["accuracy"]), answer)
        status, answer = self.server.post("advice", {"knobs": knobs})
        self.assertEqual((status, answer.get("knobs")), (200, stats["knobs"]), answer)
        self.assertTrue(answer["knobs"])

    def test_draws_every_effect_that_the_form_offers(self):
        _, _, body = self.server.get("about")
        for effect in json.loads(body)["effects"]:
            if effect["is_list"]:
                continue
            knobs = SMALL | {"set": [effect["key"] + ".on=true"], "memory-bits": "160"}
            status, answer = self.server.post("draw", {"knobs": knobs})
            self.assertEqual(status, 200, (effect["name"], answer))

    def test_finds_an_instant_by_its_clock(self):
        _, at = self.server.post("instant", {"knobs": SMALL, "number": 9})
        begin, end = at["clocks"]
        for clock in (begin, end - 1):
            _, found = self.server.post("instant", {"knobs": SMALL, "clock": clock})
            self.assertEqual(found["number"], 9)

    def test_draws_an_edited_source_without_writing_it(self):
        before = (SOURCE / MODEL).read_text()
        status, answer = self.server.post("draw", {"knobs": SMALL, "source": "cube(size=[1,2,3],center=true);"})
        self.assertEqual((status, answer["stats"]["model"]["primitives"]), (200, 1))
        self.assertEqual((SOURCE / MODEL).read_text(), before)

    def test_errors_state_line_and_column_or_the_valid_word(self):
        status, answer = self.server.post("draw", {"knobs": SMALL, "source": "cube(size=[1,2,3],center=true);\nsphere(r=;"})
        self.assertEqual(status, 422)
        self.assertTrue(answer["error"].startswith(f"{MODEL}:2:"), answer)
        self.assertEqual(answer["line"], 2)
        self.assertGreater(answer["column"], 1)
        for knobs, told in (({"machine": "pixel-plane-4"}, "pixel-planes-4"), ({"strategy": "bit"}, "bits"), ({"size": "0x4"}, "size"),
                            ({"memory-bits": "x"}, "memory-bits"), ({"set": ["alu.bit=4"]}, "alu.bits")):
            status, answer = self.server.post("draw", {"knobs": knobs})
            self.assertEqual(status, 422, answer)
            self.assertIn(told, answer["error"])
        status, answer = self.server.post("explain", {"knobs": SMALL, "pixel": "64,0"})
        self.assertEqual(status, 422, answer)

    def test_evaluates_openscad_source_in_its_folder(self):
        if not shutil.which("openscad"):
            self.skipTest("there is no openscad")
        folder = pathlib.Path(self.folder.name)
        (folder / "part.scad").write_text("module part() cube([1, 2, 3]);\n")
        (folder / "whole.scad").write_text("use <part.scad>\npart();\n")
        server = Server(CSGSIM, str(folder / "whole.scad"), "--size", "32x24")
        try:
            for request, count in (({}, 1), ({"source": "use <part.scad>\npart(); translate([3, 0, 0]) part();\n"}, 2)):
                status, answer = server.post("draw", request)
                self.assertEqual((status, answer.get("stats", answer).get("model", {}).get("primitives")), (200, count), answer)
            status, answer = server.post("draw", {"source": "use <part.scad>\npart(;\n"})
            self.assertEqual(status, 422)
            self.assertIn("whole.scad:2: ", answer["error"])
            self.assertEqual(answer["line"], 2)
        finally:
            server.stop()

    def test_the_report_contains_the_camera_of_the_last_picture(self):
        self.server.post("draw", {"knobs": SMALL})
        status, headers, body = self.server.get("report")
        self.assertEqual(status, 200)
        self.assertIn("connect-src 'none'", headers["Content-Security-Policy"])
        self.assertIn(b"30,-40,25,0,0,2", body)


class Attacks(unittest.TestCase):
    """Rejects foreign requests, and none of them ends the server."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server(CSGSIM, MODEL, "--size", "32x24", cwd=SOURCE)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def tearDown(self):
        self.assertIsNone(self.server.process.poll())
        self.assertEqual(self.server.post("draw", {})[0], 200)

    def refused(self, status, method="POST", path=None, body="{}", **headers):
        path = f"/{self.server.token}/draw" if path is None else path
        told, answered, text = self.server.ask(method, path, None if method == "GET" else body, **headers)
        self.assertEqual(told, status, text)
        self.assertNotIn("Access-Control-Allow-Origin", answered)
        self.assertNotIn(b"picture", text)

    def test_rejects_another_host_name(self):
        for host in ("evil.example", f"evil.example:{self.server.port}", "127.0.0.1", f"127.0.0.1:{self.server.port + 1}", f"[::1]:{self.server.port}"):
            self.refused(403, Host=host)
            self.refused(403, "GET", f"/{self.server.token}/", Host=host)

    def test_rejects_another_origin(self):
        for origin in ("http://evil.example", "null", f"https://127.0.0.1:{self.server.port}", f"http://127.0.0.1:{self.server.port}.evil.example", None):
            self.refused(403, Origin=origin)
        for site in ("cross-site", "same-site"):
            self.refused(403, Sec_Fetch_Site=site)
            self.refused(403, "GET", f"/{self.server.token}/about", Sec_Fetch_Site=site)

    def test_rejects_requests_without_the_exact_token(self):
        token = self.server.token
        for path in ("/", "/draw", "//draw", f"/{token[:-1]}/draw", f"/{token}0/draw", f"/{token.upper()}x/draw", f"/{'0' * 32}/draw", f"/x/../{token}/draw"):
            self.refused(403, path=path)
        self.refused(403, "GET", f"/{token}")

    def test_serves_no_files_other_than_the_page(self):
        for path in ("../../etc/passwd", "..%2f..%2fetc%2fpasswd", "%2e%2e/%2e%2e/etc/passwd", "/etc/passwd", "view.js/../../x", "page.css%00", "thesis_fig_2_3.csg"):
            status, _, body = self.server.ask("GET", f"/{self.server.token}/{path}")
            self.assertIn(status, (400, 403, 404))
            self.assertNotIn(b"root:", body)

    def test_rejects_files_that_the_model_does_not_import(self):
        for source in ('import(file="/etc/passwd");', 'import(file="../../../../../../etc/passwd");', 'surface(file="/etc/hostname");'):
            status, answer = self.server.post("draw", {"source": source})
            self.assertEqual(status, 422)
            self.assertNotIn("root:", answer["error"])
        for knobs in ({"machine": "/etc/passwd.toml"}, {"machine": "hw/machines/pixel-planes-4.toml"}, {"scene": "/etc/passwd"},
                      {"imports-from": "/"}, {"config": "/etc/passwd"}, {"model": "/etc/passwd"}, {"limit": "1000000000"}, {"port": "1"}):
            status, answer = self.server.post("draw", {"knobs": knobs})
            self.assertEqual(status, 400, answer)
        # A word that looks like an option is treated as a value.
        for knobs in ({"size": "--scene=/etc/passwd"}, {"camera": "-1,-2,-3,0,0,0 --scene /etc/passwd"}, {"set": ["--scene", "/etc/passwd"]}):
            status, answer = self.server.post("draw", {"knobs": knobs})
            self.assertEqual(status, 422, answer)
            self.assertNotIn("root:", answer["error"])

    def test_rejects_malformed_requests(self):
        for body in ("", "{", "[]", "1", "null", '"draw"', "{}{}", '{"knobs": []}', '{"knobs": {"size": 3}}', '{"knobs": {"set": "a"}}', '{"source": 3}',
                     "\xff", '{"knobs": {"size": ["x"]}}', "[" * 100_000):
            self.refused(400, body=body)
        self.refused(415, Content_Type="text/plain")
        self.refused(404, path=f"/{self.server.token}/drawn")
        self.refused(404, "GET")
        for method in ("PUT", "DELETE", "OPTIONS", "PATCH"):
            status, headers, _ = self.server.ask(method, f"/{self.server.token}/draw", "{}")
            self.assertGreaterEqual(status, 400)
            self.assertNotIn("Access-Control-Allow-Origin", headers)

    def test_rejects_a_body_that_is_too_long(self):
        try:
            status, _, _ = self.server.ask("POST", f"/{self.server.token}/draw", json.dumps({"source": "x" * 5_000_000}))
            self.assertEqual(status, 413)
        except (BrokenPipeError, ConnectionResetError):
            pass

    def test_survives_a_thousand_broken_requests(self):
        drawn = random.Random(1)
        whole = (f"POST /{self.server.token}/draw HTTP/1.1\r\nHost: {self.server.host}\r\nOrigin: http://{self.server.host}\r\n"
                 "Content-Type: application/json\r\nContent-Length: 20\r\n\r\n{\"knobs\": {\"snap\":1}}").encode()
        for number in range(1000):
            data = bytearray(whole)
            for _ in range(drawn.randrange(1, 8)):
                at = drawn.randrange(len(data) + 1)
                match drawn.randrange(4):
                    case 0: data[at:at + 1] = bytes([drawn.randrange(256)])
                    case 1: del data[at:at + drawn.randrange(1, 40)]
                    case 2: data[at:at] = bytes(drawn.randrange(256) for _ in range(drawn.randrange(20)))
                    case _: data = data[:at + 1]
            with socket.create_connection(("127.0.0.1", self.server.port), timeout=20) as connection:
                connection.sendall(data)
                if number % 3:
                    connection.shutdown(socket.SHUT_WR)
                    connection.settimeout(20)
                    try:
                        while connection.recv(65536):
                            pass
                    except ConnectionResetError:
                        pass

    def test_answers_two_browsers_independently(self):
        wrong = []

        def turn(size):
            for _ in range(20):
                status, answer = self.server.post("draw", {"knobs": {"size": f"{size}x{size}"}})
                if status != 200 or answer["width"] != size:
                    wrong.append(answer)

        threads = [threading.Thread(target=turn, args=(size,)) for size in (16, 24)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Shutdown(unittest.TestCase):
    """The server ends with its last page."""

    def test_the_server_ends_only_after_its_last_page_is_closed(self):
        server = Server(CSGSIM, MODEL, "--patience", "1", cwd=SOURCE)
        try:
            first, second = server.stream(), server.stream()
            first.close()
            time.sleep(3)
            self.assertIsNone(server.process.poll())
            second.close()
            self.assertEqual(server.process.wait(20), 0)
        finally:
            server.stop()

    def test_sends_an_open_page_three_messages_within_ten_seconds(self):
        server = Server(CSGSIM, MODEL, cwd=SOURCE)
        try:
            page = server.stream()
            told = b""
            begin = time.monotonic()
            while told.count(b":\n\n") < 3:
                told += page.recv(4096)
            self.assertLess(time.monotonic() - begin, 10)
            page.close()
        finally:
            server.stop()

    def test_reports_a_port_in_use(self):
        server = Server(CSGSIM, MODEL, cwd=SOURCE)
        try:
            done = run("view", MODEL, "--port", str(server.port), timeout=20)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"port {server.port} of 127.0.0.1 is not available", done.stderr)
        finally:
            server.stop()

    def test_rejects_a_bad_model_before_it_serves(self):
        for word, code in (("nothing.csg", 1), ("traces/thesis_fig_2_3.csgt", 2), ("-", 2)):
            done = run("view", word, timeout=20, input="")
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
