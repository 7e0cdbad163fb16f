# SPDX-License-Identifier: Apache-2.0
"""A studio with a browser before it, for tests and benchmarks."""

import contextlib
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

from playwright.sync_api import Error, sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[4]
# GL on the processor: the same pictures on every machine, laid out as where there is no other.
FLAGS = ['--disable-gpu', '--enable-unsafe-swiftshader', '--no-sandbox']
DRIVER = 'GL Driver Message'  # Chromium's, where pixels are read back


def program():
    return os.environ.get('LEGWRIGHT', str(ROOT / 'build/bin/legwright'))


def chromium():
    """The browser's path, or None where this machine has none."""
    names = ('chromium', 'chromium-browser', 'google-chrome')
    return next(filter(None, map(shutil.which, names)), None)


class Server:
    """A `legwright studio` of its own, with its state and outputs in a folder that goes away."""

    def __init__(self, *arguments):
        self.folder = tempfile.TemporaryDirectory()
        environment = dict(os.environ, XDG_STATE_HOME=self.folder.name + '/state')
        self.output = pathlib.Path(self.folder.name) / 'out'
        self.output.mkdir()
        command = [program(), 'studio', *arguments, '--no-browser', '--roots', str(self.output)]
        self.process = subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            cwd=ROOT,
            env=environment,
        )
        self.url = self.process.stdout.readline().strip()
        if not self.url:
            status = self.process.wait()
            self.close()
            raise RuntimeError(f'{" ".join(command)} ended with {status}')

    def close(self):
        self.process.terminate()
        self.process.wait(timeout=20)
        self.process.stdout.close()
        self.folder.cleanup()


@contextlib.contextmanager
def browser():
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=chromium(), args=FLAGS)
        yield started
        started.close()


class Page:
    """A page of the studio: what tests ask of it, and all that it wrote to its console."""

    def __init__(self, browser, url, width=1280, height=720, scheme='light', cut=None, touch=False):
        self.context = browser.new_context(
            viewport={'width': width, 'height': height},
            color_scheme=scheme,
            accept_downloads=True,
            has_touch=touch,
        )
        self.page = self.context.new_page()
        self.page.set_default_timeout(60000)
        self.console = []
        self.page.on('console', lambda message: self.say(message.text))
        self.page.on('pageerror', lambda error: self.console.append(str(error)))
        if cut:
            self.page.route(*cut)
        self.page.goto(url)

    def say(self, text):
        if DRIVER not in text:
            self.console.append(text)

    def js(self, expression, *arguments):
        return self.page.evaluate(expression, *arguments)

    def until(self, expression, argument=None, seconds=60):
        """Waits until an expression holds. (Playwright's own way needs `eval`, which the page's
        policy forbids.)"""
        end = time.monotonic() + seconds
        while not self.page.evaluate(expression, argument):
            if time.monotonic() > end:
                raise TimeoutError(f'{expression} does not hold; console: {self.console}')
            self.page.wait_for_timeout(20)

    def ready(self, walking=False):
        """Waits until a robot is shown and its motion is solved. Its walk halts unless it is asked
        for: a picture that moves takes a processor."""
        self.until(
            'globalThis.legwrightStudio?.store.get("motion") && legwrightStudio.isOpen() && '
            'legwrightStudio.view.framed'
        )
        self.settled()
        self.js('walking => legwrightStudio.view.setPlaying(walking)', walking)

    def settled(self):
        self.until(
            'legwrightStudio.edits.idle && legwrightStudio.store.get("state")?.settled && '
            'legwrightStudio.store.get("state").phase === "idle" && !legwrightStudio.loading && '
            'legwrightStudio.known === legwrightStudio.store.get("state").document'
        )

    def value(self, name):
        return self.js('name => legwrightStudio.readParameter(name).value', name)

    def state(self, key):
        return self.js('key => legwrightStudio.store.get("state")[key]', key)

    def button(self, name):
        return self.page.get_by_role('button', name=name, exact=True)

    def press_while_it_serves(self, name):
        """Presses a button unless it is off or gone: a search may end at any moment by itself."""
        return self.js(
            """name => {
              const found = [...document.querySelectorAll('button')].find(
                (one) => one.textContent.trim() === name && !one.disabled);
              found?.click();
              return Boolean(found);
            }""",
            name,
        )

    def workspace(self, name):
        self.page.get_by_role('tab', name=name, exact=True).click()

    def handle(self, name):
        """Where the first handle of a parameter is on the screen, and one pixel's worth beside."""
        return self.js(
            """name => {
              const { view } = legwrightStudio;
              view.setPlaying(false);
              view.pose();
              const { handles, stage } = view;
              const handle = handles.all.find((each) => each.name === name);
              const box = stage.canvas.getBoundingClientRect();
              const on = (v) => {
                const p = v.applyMatrix4(handles.root.matrixWorld).project(stage.camera);
                return [box.left + (p.x / 2 + 0.5) * box.width,
                        box.top + (0.5 - p.y / 2) * box.height];
              };
              const a = on(handle.held.clone());
              const b = on(handle.held.clone().addScaledVector(handle.along, 0.01));
              return { x: a[0], y: a[1], dx: b[0] - a[0], dy: b[1] - a[1] };
            }""",
            name,
        )

    def still(self, locator):
        """Where an element is, once what it lies in rolls no more. (A browser under load may show
        the same picture for some time while it rolls.)"""
        boxes = [locator.bounding_box()]
        while len(boxes) < 4 or any(box != boxes[-1] for box in boxes[-4:]):
            self.page.wait_for_timeout(150)
            boxes.append(locator.bounding_box())
        return boxes[-1]

    def swipe(self, start, end, steps=6):
        """Moves a finger over the page. It rests before it leaves: what it scrolls rolls no
        further."""
        devtools = self.context.new_cdp_session(self.page)

        def touch(kind, *points):
            points = [{'x': x, 'y': y} for x, y in points]
            devtools.send('Input.dispatchTouchEvent', {'type': kind, 'touchPoints': points})

        touch('touchStart', start)
        for i in range(1, steps + 1):
            share = i / steps
            touch('touchMove', [a + share * (b - a) for a, b in zip(start, end)])
        self.page.wait_for_timeout(150)
        touch('touchMove', end)
        touch('touchEnd')
        devtools.detach()

    def crash(self):
        """Kills the page's process, as the system does where memory ends."""
        with contextlib.suppress(Error):
            self.page.goto('chrome://crash', timeout=5000)
        self.context.close()

    def close(self):
        self.context.close()
