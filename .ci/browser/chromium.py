"""Drives a headless Chromium through its DevTools pipe: no packages, no port."""

import json
import os
import select
import shutil
import subprocess
import tempfile
import time

FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-extensions",
    "--disable-sync",
    "--no-first-run",
    "--mute-audio",
    "--hide-scrollbars",
    "--remote-debugging-pipe",
]


def find():
    """The browser's path, from $CHROMIUM or the usual names."""
    names = [os.environ.get("CHROMIUM", ""), "chromium", "chromium-browser", "google-chrome"]
    for name in filter(None, names):
        path = shutil.which(name)
        if path:
            return path
    raise SystemExit("error: no Chromium found; `apt-get install chromium`, or name it in CHROMIUM")


class Browser:
    """A Chromium with a fresh profile, as a context manager."""

    def __enter__(self):
        self.profile = tempfile.TemporaryDirectory(prefix="facette-browser-", ignore_cleanup_errors=True)
        ours_in, theirs_out = os.pipe()
        theirs_in, ours_out = os.pipe()
        command = [find(), *FLAGS, f"--user-data-dir={self.profile.name}", "about:blank"]
        self.process = subprocess.Popen(
            command,
            close_fds=False,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            preexec_fn=lambda: (self._place(theirs_in, 3, theirs_out, 4)),
        )
        os.close(theirs_in)
        os.close(theirs_out)
        self.read_end, self.write_end = ours_in, ours_out
        self.buffer, self.number, self.events = b"", 0, []
        return self

    @staticmethod
    def _place(read_end, read_at, write_end, write_at):
        """In the child: DevTools reads at 3 and writes at 4. Moved out of the way first, as numbers may coincide."""
        spare_read, spare_write = os.dup(read_end), os.dup(write_end)
        high_read, high_write = os.dup2(spare_read, 60), os.dup2(spare_write, 61)
        os.dup2(high_read, read_at)
        os.dup2(high_write, write_at)

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.read_end)
        os.close(self.write_end)
        self.profile.cleanup()

    def _receive(self, deadline):
        """The next message, or None at the deadline."""
        while b"\0" not in self.buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self.read_end], [], [], left)[0]:
                return None
            part = os.read(self.read_end, 1 << 16)
            if not part:
                raise RuntimeError("Chromium ended unexpectedly")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, session=None, seconds=60, **parameters):
        """Calls a DevTools method and returns its result; events that arrive meanwhile are kept."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + seconds
        while True:
            reply = self._receive(deadline)
            if reply is None:
                raise RuntimeError(f"{method}: no answer within {seconds} s")
            if reply.get("id") == self.number:
                if "error" in reply:
                    raise RuntimeError(f"{method}: {reply['error']['message']}")
                return reply["result"]
            self.events.append(reply)

    def wait(self, method, session, seconds=30):
        """Waits for an event of this name."""
        deadline = time.monotonic() + seconds
        seen = 0
        while True:
            for event in self.events[seen:]:
                if event.get("method") == method and event.get("sessionId") == session:
                    return event["params"]
            seen = len(self.events)
            event = self._receive(deadline)
            if event is None:
                raise RuntimeError(f"{method} did not happen within {seconds} s")
            self.events.append(event)


class Tab:
    """A page of the browser that notes requests and complaints."""

    def __init__(self, browser, width, height, theme=None):
        self.browser = browser
        self.context = browser.call("Target.createBrowserContext")["browserContextId"]
        target = browser.call("Target.createTarget", url="about:blank", browserContextId=self.context)
        self.target = target["targetId"]
        attached = browser.call("Target.attachToTarget", targetId=self.target, flatten=True)
        self.session = attached["sessionId"]
        for domain in ["Page", "Network", "Runtime", "Log"]:
            self.call(f"{domain}.enable")
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=width < 600,
        )
        if theme:
            script = f"try {{ localStorage.setItem('mdbook-theme', '{theme}'); }} catch (e) {{}}"
            self.call("Page.addScriptToEvaluateOnNewDocument", source=script)

    def call(self, method, **parameters):
        return self.browser.call(method, session=self.session, **parameters)

    def open(self, url):
        """Loads a page and returns the requests it made and what it complained about."""
        self.browser.events.clear()
        self.call("Page.navigate", url=url)
        self.browser.wait("Page.loadEventFired", self.session)
        self.evaluate("document.fonts.ready.then(() => new Promise(r => setTimeout(r, 150)))")
        return self.noted()

    def noted(self):
        """The requests and complaints since the page was opened."""
        requests, complaints = [], []
        for event in self.browser.events:
            if event.get("sessionId") != self.session:
                continue
            method, params = event["method"], event["params"]
            if method == "Network.requestWillBeSent":
                requests.append(params["request"]["url"])
            elif method == "Network.loadingFailed" and not params.get("canceled"):
                complaints.append(f"loading failed: {params['errorText']}")
            elif method == "Runtime.exceptionThrown":
                complaints.append(params["exceptionDetails"].get("text", "exception"))
            elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
                words = [str(a.get("value", a.get("description", ""))) for a in params["args"]]
                complaints.append(f"console: {' '.join(words)}")
            elif method == "Log.entryAdded" and params["entry"]["level"] == "error":
                complaints.append(f"log: {params['entry']['text']} {params['entry'].get('url', '')}")
        return requests, complaints

    def evaluate(self, expression):
        """The value of a JavaScript expression (or of its promise)."""
        result = self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        if "exceptionDetails" in result:
            details = result["exceptionDetails"]
            text = details.get("exception", {}).get("description", details["text"])
            raise RuntimeError(f"script: {text}")
        return result["result"].get("value")

    def picture(self, file):
        """Writes what the window shows as PNG."""
        import base64

        data = self.call("Page.captureScreenshot", format="png")["data"]
        with open(file, "wb") as out:
            out.write(base64.b64decode(data))

    def close(self):
        self.browser.call("Target.disposeBrowserContext", browserContextId=self.context)
