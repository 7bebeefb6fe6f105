"""A csgsim view that a test asks."""

import http.client
import json
import re
import subprocess
import urllib.parse


class Server:
    """Runs from its making to stop()."""

    def __init__(self, csgsim, *words, cwd=None):
        self.process = subprocess.Popen([csgsim, "view", *words], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        if not re.fullmatch(r"http://127\.0\.0\.1:\d+/[0-9a-f]{32}/\n", line):
            raise RuntimeError(f"no address: {line!r} {self.process.stderr.read()!r}")
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
        """Status, headers and bytes of the answer to a request as the page makes it, but for what `headers` say otherwise; None leaves one out."""
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

    def get(self, name):
        return self.ask("GET", f"/{self.token}/{name}")

    def post(self, name, wish):
        """Status and JSON."""
        status, _, body = self.ask("POST", f"/{self.token}/{name}", json.dumps(wish))
        return status, json.loads(body)
