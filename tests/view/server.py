"""A csgsim view server for tests."""

import http.client
import json
import pathlib
import re
import socket
import subprocess
import urllib.parse


def answer_from(connection):
    """Reads an answer until its end; returns status and body."""
    data = b""
    try:
        while block := connection.recv(65536):
            data += block
    except ConnectionResetError:
        pass
    if not data:
        return None
    head, _, body = data.partition(b"\r\n\r\n")
    return int(head.split()[1]), body


class Server:
    """Runs from construction to stop()."""

    def __init__(self, csgsim, *words, cwd=None, env=None):
        self.process = subprocess.Popen([csgsim, "view", *words], cwd=cwd, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        if not re.fullmatch(r"http://127\.0\.0\.1:\d+/[0-9a-f]{32}/\n", line):
            raise RuntimeError(f"csgsim view printed no address but {line!r} {self.process.stderr.read()!r}")
        self.address = line.strip()
        where = urllib.parse.urlsplit(self.address)
        self.port = where.port
        self.token = where.path.strip("/")
        self.host = f"127.0.0.1:{self.port}"

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        self.process.stderr.close()

    def ask(self, method, path, body=None, **headers):
        """Sends a request like the page; `headers` replace its headers, or remove them if None. Returns status, headers
        and body."""
        own = {"Host": self.host}
        if method == "POST":
            own |= {"Origin": "http://" + self.host, "Content-Type": "application/json", "Sec-Fetch-Site": "same-origin"}
        own |= {name.replace("_", "-"): value for name, value in headers.items()}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
            for name, value in own.items():
                if value is not None:
                    connection.putheader(name, value)
            data = body.encode() if isinstance(body, str) else body
            if data is not None:
                connection.putheader("Content-Length", str(len(data)))
            connection.endheaders(data)
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()
        finally:
            connection.close()

    def raw(self, *pieces, seconds=20):
        """Sends raw bytes; returns status and body, or None if the connection ends without an answer."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=seconds) as connection:
            try:
                for piece in pieces:
                    connection.sendall(piece)
            except (BrokenPipeError, ConnectionResetError):
                pass
            return answer_from(connection)

    def stream(self):
        """A connection that stays open, like that of a page."""
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=20)
        connection.sendall(f"GET /{self.token}/alive HTTP/1.1\r\nHost: {self.host}\r\n\r\n".encode())
        if b" 200 " not in (head := connection.recv(4096)):
            raise RuntimeError(f"csgsim view opened no event stream but answered {head!r}")
        return connection

    def most_memory(self):
        """Peak memory of the server, in bytes."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return 1024 * int(re.search(r"VmHWM:\s*(\d+) kB", status)[1])

    def get(self, name):
        return self.ask("GET", f"/{self.token}/{name}")

    def post(self, name, request):
        """Posts a request; returns status and JSON."""
        status, _, body = self.ask("POST", f"/{self.token}/{name}", json.dumps(request))
        return status, json.loads(body)
