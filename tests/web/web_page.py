"""The page without a server program, for tests: its csgsim.wasm in node, and the page behind a static server."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


class Answering:
    """csgsim.wasm in node, with a model."""

    def __init__(self, site, name, text, knobs=None):
        self.folder = tempfile.TemporaryDirectory()
        for file in ("program.js", "wasi.js", "csgsim.wasm"):
            shutil.copy(site / file, self.folder.name)
        (pathlib.Path(self.folder.name) / "package.json").write_text('{"type": "module"}')
        self.process = subprocess.Popen(["node", HERE / "answers.mjs", self.folder.name], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.begun = self.send({"begin": [name, text, knobs or {}]})

    def send(self, message):
        """Sends a message; returns status and text."""
        self.process.stdin.write(json.dumps(message) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def post(self, question, request):
        """Sends a request; returns status and JSON, like the server of csgsim view."""
        status, body = self.send({"question": question, "request": request})
        return status, json.loads(body)

    def stop(self):
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()
        self.folder.cleanup()


class StaticServer:
    """Python's file server."""

    def __init__(self, folder):
        self.process = subprocess.Popen([sys.executable, "-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", folder],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.address = re.search(r"\((http://[^)]*)\)", self.process.stdout.readline()).group(1)

    def stop(self):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()
