"""A headless Chromium that a test leads through a page: it evaluates JavaScript, presses keys and takes screenshots.

    with Browser(390, 844) as browser:
        browser.open("/tmp/page.html")
        browser.press("End")
        browser.save_screenshot("/tmp/end.png")
"""
import base64
import json
import os
import shutil
import subprocess
import tempfile


class Browser:
    def __init__(self, width, height, scale=1):
        self._size = {"width": width, "height": height, "deviceScaleFactor": scale, "mobile": width < 600}

    @staticmethod
    def find():
        """The path of Chromium, or None if it is not installed."""
        return shutil.which("chromium")

    def __enter__(self):
        self._profile = tempfile.TemporaryDirectory()
        read_commands, self._commands = os.pipe()
        self._replies, write_replies = os.pipe()

        def connect():  # Chromium reads commands from descriptor 3 and replies on descriptor 4
            commands, replies = os.dup(read_commands), os.dup(write_replies)
            os.dup2(commands, 3)
            os.dup2(replies, 4)

        self._process = subprocess.Popen(
            [self.find(), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
             "--remote-debugging-pipe", f"--user-data-dir={self._profile.name}", "about:blank"],
            preexec_fn=connect, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(read_commands)
        os.close(write_replies)
        self._buffer, self._number, self._session = b"", 0, None
        targets = self._call("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self._session = self._call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        self._call("Page.enable")
        self._call("Emulation.setDeviceMetricsOverride", **self._size)
        return self

    def __exit__(self, *_):
        os.close(self._commands)
        self._process.wait(timeout=60)
        os.close(self._replies)
        self._profile.cleanup()

    def emulate_media(self, media):
        """Use the style for a medium, such as "print", from now on."""
        self._call("Emulation.setEmulatedMedia", media=media)

    def open(self, path):
        self._call("Page.navigate", url="file://" + os.path.abspath(path))
        while self._read().get("method") != "Page.loadEventFired":
            pass
        self.evaluate("Promise.all([...document.images].map(image => image.decode())).then(() => true)")

    def evaluate(self, script):
        """The value of a JavaScript expression, once it is known."""
        reply = self._call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in reply:
            raise RuntimeError(reply["exceptionDetails"]["exception"]["description"])
        return reply["result"].get("value")

    def press(self, key):
        """Press a key, and wait until the page has scrolled."""
        for kind in ("keyDown", "keyUp"):
            self._call("Input.dispatchKeyEvent", type=kind, key=key, code=key)
        self.settle()

    def swipe(self, across):
        """Swipe by a number of pixels to the right, or to the left if it is negative."""
        x, y = self._size["width"] / 2, self._size["height"] / 2
        self._call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self._call("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x + across, "y": y}])
        self._call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.settle()

    def settle(self):
        """Wait until the page has stayed in place for several frames."""
        self.evaluate("""new Promise(done => {
            let last = scrollY, still = 0;
            const look = () => {
                still = scrollY === last ? still + 1 : 0;
                last = scrollY;
                still > 10 ? done(true) : requestAnimationFrame(look);
            };
            look();
        })""")

    def show(self, selector):
        self.evaluate(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{behavior: 'instant'}})")
        self.settle()

    def save_screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self._call("Page.captureScreenshot", format="png")["data"]))

    def _call(self, method, **parameters):
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._commands, json.dumps(message).encode() + b"\0")
        while True:
            reply = self._read()
            if reply.get("id") == self._number:
                if "error" in reply:
                    raise RuntimeError(f"{method}: {reply['error']['message']}")
                return reply["result"]

    def _read(self):
        while b"\0" not in self._buffer:
            data = os.read(self._replies, 1 << 16)
            if not data:
                raise RuntimeError("Chromium has ended")
            self._buffer += data
        message, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(message)
