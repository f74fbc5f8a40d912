#!/usr/bin/env python3
"""Opens the page of `eikonal render --view` in headless Chromium (Debian: chromium) while it renders, and uses it as a user would.

Chromium is driven by its own protocol over a WebSocket of the standard library alone. Fails if the console has an error, if the page asks for
anything from elsewhere, shows no image, no pixel, no curve or no stages; if pause, go on, save or stop have no effect; if layers, exposure or
cropping change nothing; if the page does not say that the program has ended. --screenshots FOLDER keeps pictures, to be looked at. Exits with
77 if Chromium is not installed.
"""
import argparse
import base64
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Browser:
    """A page in headless Chromium."""

    def __init__(self, program, profile):
        self.process = subprocess.Popen([program, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-port=0", "--window-size=1280,900",
                                         f"--user-data-dir={profile}", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", "about:blank"],
                                        stderr=subprocess.PIPE, text=True)
        for line in self.process.stderr:
            if found := re.search(r"ws://127.0.0.1:(\d+)/", line):
                break
        port = int(found[1])
        targets = json.load(urllib.request.urlopen(f"http://127.0.0.1:{port}/json"))
        path = next(t["webSocketDebuggerUrl"] for t in targets if t["type"] == "page").split(f":{port}", 1)[1]
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=60)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        self._read_until(b"\r\n\r\n")
        self.count, self.events = 0, []

    def _read_until(self, end):
        text = b""
        while not text.endswith(end):
            text += self.socket.recv(1)
        return text

    def _exactly(self, count):
        data = b""
        while len(data) < count:
            data += self.socket.recv(count - len(data))
        return data

    def _receive(self):
        message = b""
        while True:
            first, length = self._exactly(2)
            length = struct.unpack(">H", self._exactly(2))[0] if length == 126 else struct.unpack(">Q", self._exactly(8))[0] if length == 127 else length
            message += self._exactly(length)
            if first & 0x80:
                return json.loads(message)

    def call(self, method, **params):
        self.count += 1
        data = json.dumps({"id": self.count, "method": method, "params": params}).encode()
        mask = os.urandom(4)
        size = struct.pack(">BB", 0x81, 0x80 | len(data)) if len(data) < 126 else struct.pack(">BBH", 0x81, 0xFE, len(data))
        self.socket.sendall(size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))
        while True:
            answer = self._receive()
            if answer.get("id") == self.count:
                return answer.get("result", answer)
            self.events.append(answer)

    def value(self, expression):
        return self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)["result"].get("value")

    def until(self, expression, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if result := self.value(expression):
                return result
            time.sleep(0.1)
        raise AssertionError(f"the page never has: {expression}; its phase is {self.value('phase.textContent')}")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, **more)

    def screenshot(self, file):
        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot")["data"]))

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.wait()


IMAGE = """(() => { const c = document.getElementById("picture"), d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
  let sum = 0; for (let i = 0; i < d.length; i += 4) sum += d[i] + d[i + 1] + d[i + 2]; return [c.width, c.height, sum / d.length]; })()"""


def use(page, folder, keep):
    page.until("image > 0 && document.getElementById('phase').textContent === 'rendering'")
    width, height, light = page.value(IMAGE)
    assert (width, height) == (96, 96) and light > 5, f"{width} x {height} pixels, mean {light}"
    page.until("state.errors.length > 2 && document.querySelector('#curve polyline') && document.querySelectorAll('#stages tr').length > 3")
    page.until("/ left$/.test(document.getElementById('progress').textContent)")
    keep(page, "rendering")

    # the pixel below the mouse
    box = page.value("(r => [r.left, r.top, r.width, r.height])(document.getElementById('picture').getBoundingClientRect())")
    page.mouse("mouseMoved", box[0] + box[2] * 0.5, box[1] + box[3] * 0.25)
    page.until("document.querySelectorAll('#pixel tr').length >= 8")
    assert page.value("where.textContent") == "48, 24", page.value("where.textContent")

    # pause: no more samples; going on: more
    page.value("document.getElementById('pause').click()")
    page.until("state.phase === 'paused'")
    time.sleep(1)
    before = page.value("state.samples")
    time.sleep(1)
    assert page.value("state.samples") == before, "a paused render goes on"
    page.value("document.getElementById('save').click()")
    page.until("state.saves === 1")
    assert (folder / "a.exr").exists() and (folder / "a.film").exists(), "save writes no files"
    keep(page, "paused")
    page.value("document.getElementById('goOn').click()")
    page.until(f"state.samples > {before}")

    # layers, false colours, exposure
    names = page.value("[...document.getElementById('layer').options].map(o => o.value)")
    for name in ("image", "albedo", "N", "P", "Z", "objectId", "variance", "sampleCount", "relative error"):
        assert name in names, f"{name} is not among {names}"
        page.value(f"(l => {{ l.value = '{name}'; l.dispatchEvent(new Event('change')); }})(document.getElementById('layer'))")
        page.until(f"document.getElementById('picture').dataset.layer === '{name}'")
        if name != "sampleCount":
            assert page.value(IMAGE)[2] > 1, f"{name} is black"
        keep(page, name.replace(" ", "-"))
    page.value("(l => { l.value = 'image'; l.dispatchEvent(new Event('change')); })(document.getElementById('layer'))")
    page.until("document.getElementById('picture').dataset.layer === 'image'")
    light = page.value(IMAGE)[2]
    page.value("(e => { e.value = 2; e.dispatchEvent(new Event('input')); })(document.getElementById('exposure'))")
    assert page.value(IMAGE)[2] > 1.1 * light, "exposure changes nothing"

    # crop by dragging
    page.value("cropping.click()")
    page.mouse("mousePressed", box[0] + box[2] * 0.251, box[1] + box[3] * 0.251, clickCount=1)
    page.mouse("mouseMoved", box[0] + box[2] * 0.749, box[1] + box[3] * 0.499)
    keep(page, "cropped")
    page.mouse("mouseReleased", box[0] + box[2] * 0.749, box[1] + box[3] * 0.499, clickCount=1)
    assert page.value("option.value") == "--pixelbounds 24,72,24,48", page.value("option.value")
    page.value("cropping.click()")
    page.call("Input.dispatchMouseEvent", type="mouseWheel", x=box[0] + box[2] / 2, y=box[1] + box[3] / 2, deltaX=0, deltaY=-600)
    page.until(f"document.getElementById('picture').getBoundingClientRect().width > 2 * {box[2]}")

    # stop: the image is written, and the page says that the program has ended
    page.value("document.getElementById('stop').click()")
    page.until("state.hasEnded && !notice.hidden")
    assert page.value("phase.textContent") == "interrupted"
    assert "has ended" in page.value("notice.textContent")
    keep(page, "ended")
    resources = page.value("performance.getEntriesByType('resource').map(e => new URL(e.name).origin).filter(o => o !== location.origin && o !== 'null')")
    assert not resources, f"resources from elsewhere: {resources}"
    errors = [e for e in page.events if e["method"] == "Runtime.exceptionThrown" or
              (e["method"] == "Runtime.consoleAPICalled" and e["params"]["type"] == "error") or
              (e["method"] == "Log.entryAdded" and e["params"]["entry"]["level"] == "error" and "ERR_CONNECTION" not in e["params"]["entry"]["text"])]
    assert not errors, errors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "scenes" / "cornell-box.pbrt")
    parser.add_argument("--screenshots", type=pathlib.Path)
    o = parser.parse_args()
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not chromium:
        print("chromium is not installed: skipped")
        sys.exit(77)

    def keep(page, name):
        if o.screenshots:
            page.screenshot(o.screenshots / f"view-{name}.png")

    with tempfile.TemporaryDirectory() as name, tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        folder = pathlib.Path(name)
        render = subprocess.Popen([o.program.resolve(), "render", o.scene.resolve(), "-o", "a.exr", "--checkpoint", "a.film", "--resolution", "96x96", "--spp",
                                   "1000000", "--aov", "all", "--view"], cwd=folder, stderr=subprocess.PIPE, text=True)
        page = None
        try:
            url = next(line for line in render.stderr if line.startswith("view: ")).split()[1]
            page = Browser(chromium, profile)
            for domain in ("Page", "Runtime", "Log"):
                page.call(f"{domain}.enable")
            page.call("Page.navigate", url=url)
            use(page, folder, keep)
            status = render.wait(timeout=30)
            assert status == 130, f"exit status {status}"
            print("the page does what it should")
        finally:
            render.kill()
            render.wait()
            if page:
                page.close()


if __name__ == "__main__":
    main()
