# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven by its DevTools protocol over two pipes: open a page, evaluate JavaScript, take
pictures, hear what goes wrong."""
import base64
import json
import os
import select
import subprocess
import tempfile
import time

OPTIONS = ("--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--hide-scrollbars", "--disable-dev-shm-usage", "--no-first-run", "--remote-debugging-pipe")


class Browser:
    """A context: the browser ends with it."""

    def __init__(self, program, width=1280, height=900, patience=240.):
        self.program, self.size, self.patience = program, (width, height), patience
        self.errors, self.replies, self.buffer, self.n = [], {}, b"", 0
        self.allowed = ("file:", "data:", "blob:", "about:")  # beginnings of what may be asked for

    def __enter__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        theirs_in, self.to_browser = os.pipe()
        self.from_browser, theirs_out = os.pipe()
        # The browser reads from descriptor 3 and writes to descriptor 4.
        command = [self.program, *OPTIONS, f"--user-data-dir={self.profile.name}", "about:blank"]
        self.process = subprocess.Popen(["bash", "-c", f'exec "$@" 3<&{theirs_in} 4>&{theirs_out}', "bash", *command],
                                        pass_fds=(theirs_in, theirs_out), stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(theirs_in)
        os.close(theirs_out)
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.resize(*self.size)
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(20.)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        self.profile.cleanup()

    def call(self, method, **parameters):
        """The result of a command; events that come meanwhile are looked at."""
        self.n += 1
        message = {"id": self.n, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + self.patience
        while self.n not in self.replies:
            self.read_messages(end)
        reply = self.replies.pop(self.n)
        if "error" in reply:
            raise RuntimeError(f"{method}: {reply['error']}")
        return reply["result"]

    def read_messages(self, end):
        if not select.select([self.from_browser], [], [], max(end - time.monotonic(), 0.))[0]:
            raise RuntimeError("the browser does not answer")
        data = os.read(self.from_browser, 1 << 20)
        if not data:
            raise RuntimeError("the browser has ended")
        *messages, self.buffer = (self.buffer + data).split(b"\0")
        for text in messages:
            message = json.loads(text)
            if "id" in message:
                self.replies[message["id"]] = message
            else:
                self.hear(message.get("method"), message.get("params", {}))

    def hear(self, method, event):
        """Keeps errors of scripts and of the console, and every request that would leave this machine."""
        if method == "Runtime.exceptionThrown":
            details = event["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Runtime.consoleAPICalled" and event["type"] in ("error", "assert"):
            self.errors.append(" ".join(str(part.get("value", part.get("description"))) for part in event["args"]))
        elif method == "Log.entryAdded" and event["entry"]["level"] == "error":
            self.errors.append(event["entry"]["text"])
        elif method == "Network.requestWillBeSent" and not event["request"]["url"].startswith(self.allowed):
            self.errors.append("request of " + event["request"]["url"][:200])

    def resize(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def evaluate(self, expression):
        """The value of a JavaScript expression, of a promise when it is kept."""
        reply = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in reply:
            raise RuntimeError(f"{expression}: {reply['exceptionDetails'].get('exception', {}).get('description')}")
        return reply["result"].get("value")

    def wait_for(self, expression):
        """Waits until the expression is true; says whether it has become so."""
        end = time.monotonic() + self.patience
        while not self.evaluate(expression):
            if time.monotonic() > end:
                return False
            time.sleep(0.05)
        return True

    def open(self, path, fragment=""):
        """Opens a file or an address; returns the seconds until the page says that it is ready, None if it does not."""
        begin = time.monotonic()
        self.call("Page.navigate", url="about:blank")
        address = path if path.startswith("http:") else "file://" + os.path.abspath(path)
        self.call("Page.navigate", url=address + fragment)
        is_ready = self.wait_for("!!document.body && ['ready', 'failed'].includes(document.body.dataset.state)")
        is_ready = is_ready and self.evaluate("document.body.dataset.state") == "ready"
        return time.monotonic() - begin if is_ready else None

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))
