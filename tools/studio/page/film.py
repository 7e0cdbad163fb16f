#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The animated picture of the README: a walk through the Studio in Chromium, as fast as it went.

    tools/page --film OUT.webp

The puppy is to walk sideways, which it is not built for. A length is dragged, an axis is turned,
the search goes on from there, MuJoCo plays what it found and judges it.
"""

import argparse
import io
import pathlib
import sys
import time

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'tests/tools/studio/page'))
from studio_browser import Page, Server, browser, chromium  # noqa: E402

TASK = 'examples/puppy/sideways.toml'
SHOWN = (900, 506)  # pixels of the film
EVERY = 0.12  # s between its pictures
LAST = 2500  # ms for which the last one stays
POINTER = """() => {
  const dot = document.createElement("div");
  Object.assign(dot.style, { position: "fixed", width: "16px", height: "16px", zIndex: 99,
    borderRadius: "8px", border: "2px solid white", background: "rgba(20,20,20,.75)",
    pointerEvents: "none", transform: "translate(-50%,-50%)", left: "50%", top: "50%" });
  document.body.append(dot);
  addEventListener("pointermove", (e) => {
    dot.style.left = e.clientX + "px";
    dot.style.top = e.clientY + "px";
  }, true);
}"""


class Film:
    """Pictures of the page and when each was taken."""

    def __init__(self, studio):
        self.studio = studio
        self.frames = []

    def shoot(self):
        bytes_ = self.studio.page.screenshot(type='png')
        picture = Image.open(io.BytesIO(bytes_)).convert('RGB')
        self.frames.append((time.monotonic(), picture.resize(SHOWN, Image.LANCZOS)))

    def roll(self, seconds, until=None):
        """Films for some seconds, or until an expression holds."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            begun = time.monotonic()
            self.shoot()
            if until and self.studio.js(until):
                break
            rest = EVERY - (time.monotonic() - begun)
            if rest > 0:
                self.studio.page.wait_for_timeout(1000 * rest)

    def save(self, path):
        times = [at for at, _ in self.frames]
        lasts = [round(1000 * (b - a)) for a, b in zip(times, times[1:])] + [LAST]
        pictures = [picture for _, picture in self.frames]
        pictures[0].save(
            path,
            save_all=True,
            append_images=pictures[1:],
            duration=lasts,
            loop=0,
            quality=45,
            method=4,
            minimize_size=True,
        )


def move(film, start, end, steps=8):
    for i in range(1, steps + 1):
        share = i / steps
        spot = [a + share * (b - a) for a, b in zip(start, end)]
        film.studio.page.mouse.move(*spot)
        film.roll(EVERY)


def drag(film, name, along, steps=10):
    """Takes hold of a handle and moves it by so many steps of one centimetre or radian / 100."""
    studio = film.studio
    at = studio.handle(name)
    studio.js('legwrightStudio.view.setPlaying(true)')
    mouse = studio.page.mouse
    move(film, (at['x'] + 60, at['y'] + 40), (at['x'], at['y']))
    at = studio.handle(name)
    mouse.move(at['x'], at['y'])
    mouse.down()
    studio.js('legwrightStudio.view.setPlaying(true)')
    end = (at['x'] + at['dx'] * along, at['y'] + at['dy'] * along)
    move(film, (at['x'], at['y']), end, steps)
    mouse.up()
    film.roll(0.8)


def play(film):
    studio = film.studio
    film.roll(1.5)
    drag(film, 'front_thigh_length', 2.5)
    studio.js('legwrightStudio.selection.set(["front_hip_axis_roll"])')
    film.roll(0.4)
    drag(film, 'front_hip_axis_roll', 30)
    studio.workspace('Simulate')
    film.roll(0.5)
    studio.button('Optimise').click()
    at_rest = 'legwrightStudio.store.get("state").phase === "idle"'
    film.roll(25, f'{at_rest} && legwrightStudio.store.get("state").iterations > 0')
    film.roll(1.5)
    studio.button('Play in MuJoCo').click()
    film.roll(4)
    studio.button('Judge').click()
    film.roll(40, 'legwrightStudio.store.get("judge")?.verdict')
    studio.page.locator('p.verdict').scroll_into_view_if_needed()
    film.roll(1.0)
    studio.page.get_by_text('limits are kept').click()
    film.roll(1.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('output', type=pathlib.Path)
    options = parser.parse_args()
    if not chromium():
        print('film: no chromium on this machine', file=sys.stderr)
        return 3
    server = Server(str(ROOT / TASK))
    with browser() as chrome:
        studio = Page(chrome, server.url)
        studio.ready(walking=True)
        studio.js(POINTER)
        film = Film(studio)
        play(film)
        film.save(options.output)
        size = options.output.stat().st_size / 1024
        seconds = film.frames[-1][0] - film.frames[0][0]
        print(f'{options.output}: {len(film.frames)} pictures, {seconds:.0f} s, {size:.0f} KiB')
        studio.close()
    server.close()
    return 0


if __name__ == '__main__':
    sys.exit(main())
