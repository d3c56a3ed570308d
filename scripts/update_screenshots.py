#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes the documentation's pictures of the window again, on a display of its own: real mouse and keyboard events, the
window's own screenshots. Needs Debian's xvfb and xdotool (`./check` installs them) and a build (`./run` makes it).

    scripts/update_screenshots.py [NAME...]     # all, or those named
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/inkbench"
IMAGES = ROOT / "docs/images/workbench"
PATIENCE = 60.0  # s


class Window:
    """The program in a folder of its own, which the next start shares."""

    def __init__(self, display, folder, *arguments, size="1280x800"):
        self.folder = folder
        self.environment = dict(os.environ, DISPLAY=display, HOME=str(folder), LIBGL_ALWAYS_SOFTWARE="1")
        for variable in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            self.environment.pop(variable, None)
        self.state_file = folder / "state.json"
        self.state_file.unlink(missing_ok=True)
        self.marks = 0
        command = [PROGRAM, "app", "--size", size, "--state-file", self.state_file, *arguments]
        self.process = subprocess.Popen(list(map(str, command)), cwd=folder, env=self.environment)
        self.rest()
        if self.state()["layout"]["show_welcome"] == "true":
            self.key("Escape")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.send("key", "ctrl+q")
        try:
            self.process.wait(timeout=PATIENCE)
        finally:
            self.process.kill()

    def state(self):
        return json.loads(self.state_file.read_text())

    def wait(self, what, holds):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if self.process.poll() is not None:
                sys.exit(f"the window ended while waiting for {what}")
            if self.state_file.exists() and holds(self.state()):
                return
            time.sleep(0.05)
        sys.exit(f"waited in vain for {what}")

    def rest(self):
        """Until nothing has changed for a moment, judging and reports included."""
        self.wait("the window", lambda state: True)
        last, since = None, time.monotonic()
        while time.monotonic() - since < 1.0:
            now = self.state_file.read_text()
            if now != last or self.state()["finds_lines"]:
                last, since = now, time.monotonic()
            time.sleep(0.05)

    def send(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def input(self, *words):
        self.send(*words, "key", "Pause")
        self.marks += 1
        self.wait("the mouse and keyboard", lambda state: state["marks"] == self.marks)
        self.rest()

    def key(self, *keys):
        for key in keys:
            self.input("key", key)

    def place(self, widget, across=0.5, down=0.5):
        self.wait(f"the widget {widget}", lambda state: widget in state["ui"])
        left, top, right, bottom = self.state()["ui"][widget]
        return round(left + across * (right - left)), round(top + down * (bottom - top))

    def move(self, widget, across=0.5, down=0.5):
        self.input("mousemove", *self.place(widget, across, down))

    def click(self, widget, across=0.5, down=0.5, button=1):
        self.input("mousemove", *self.place(widget, across, down), "click", button)

    def drag(self, start, end):
        steps = [word for i in range(1, 7) for word in
                 ("mousemove", *(round(a + (b - a) * i / 6) for a, b in zip(start, end)), "sleep", "0.03")]
        self.input("mousemove", *start, "mousedown", 1, *steps, "mouseup", 1)

    def save(self, name):
        before = set(self.folder.glob("inkbench-*.png"))
        self.key("F12")
        self.wait("the screenshot", lambda state: set(self.folder.glob("inkbench-*.png")) > before)
        (picture,) = set(self.folder.glob("inkbench-*.png")) - before
        shutil.move(picture, IMAGES / f"{name}.png")
        print(IMAGES / f"{name}.png")


def sheet(window):
    """The framebuffers from the scene to its lines, and why a pixel is a line."""
    window.click("tile:combined_edges", 0.31, 0.33)
    while not window.state()["why"]["inked"]:
        window.key("Left")
    window.move("tile:final", 0.55, 0.6)
    window.save("sheet")


def judge(window):
    """The lines against the reference lines, two states split."""
    window.key("Escape", "p")
    window.drag(window.place("bar:combine.k_normal", 0.41), window.place("bar:combine.k_normal", 0.62))
    window.key("j", "l", "l", "c")
    window.input("mousemove", 700, 780)
    window.wait("the measures", lambda state: not state["judge"]["behind"] and state["judge"]["pinned"])
    window.rest()
    window.save("judge")


def causes(window):
    """Why lines are false or missing, and the cause of one pixel."""
    window.key("7", "l", "l", "l")
    window.wait("the causes", lambda state: state["causes"])
    window.click("tile:final", 0.45, 0.5)
    while not window.state()["why"]["inked"]:
        window.key("Left")
    window.input("mousemove", 640, 790)
    window.wait("the causes again", lambda state: state["causes"])
    window.save("causes")


def fit(window):
    """The paper's coefficients fitted: how good their values are, behind their bars."""
    window.click("tab:Judge")
    window.click("fit")
    window.wait("the fit", lambda state: state["fit"]["result"])
    window.click("fit:take over")
    window.input("mousemove", 640, 790)
    window.wait("the measures", lambda state: not state["judge"]["behind"])
    window.save("fit")


def marks(window):
    """What is wanted and what is not, painted over the picture."""
    window.key("7", "m")
    window.wait("the brush", lambda state: "brush:Wanted" in state["ui"])
    tile = "tile:final"
    for start, end in (((0.61, 0.56), (0.73, 0.61)), ((0.72, 0.605), (0.815, 0.57))):
        window.drag(window.place(tile, *start), window.place(tile, *end))
    window.click("brush:Unwanted")
    window.move(tile)
    window.input("keydown", "ctrl", *["click", 4] * 6, "keyup", "ctrl")
    for start, end in (((0.33, 0.55), (0.52, 0.46)), ((0.36, 0.63), (0.53, 0.58))):
        window.drag(window.place(tile, *start), window.place(tile, *end))
    window.wait("the strokes", lambda state: state["painted"]["unwanted"] > 0)
    window.move(tile, 0.5, 0.7)
    window.rest()
    window.save("marks")


def ramps(window):
    """The ramp editor under the shaded picture."""
    window.key("6", "r")
    window.input("mousemove", 640, 790)
    window.save("ramps")


def curve(window):
    """The curve under the mouse, with what it is."""
    window.input("mousemove", *window.place("tile:curves"), "click", "--repeat", 2, "--delay", 60, 1)
    across = 0.4
    while not window.state()["view"]["curve"]:
        across += 0.004
        window.move("tile:curves", across, 0.3)
    window.save("curve")


def style(window):
    """A bundled style, its width along the stroke drawn by hand."""
    window.key("t")
    window.click("style:ink_brush")
    graph = "profile:stroke.profile"
    places = [window.place(graph, *at) for at in ((0, 0.9), (0.15, 0.5), (0.3, 0.15), (0.45, 0.1), (0.6, 0.5), (0.75, 0.2), (1, 0.95))]
    steps = [word for start, end in zip(places, places[1:]) for i in range(1, 5) for word in
             ("mousemove", *(round(a + (b - a) * i / 4) for a, b in zip(start, end)), "sleep", "0.05")]
    window.input("mousemove", *places[0], "mousedown", 1, *steps, "mouseup", 1)
    window.key("7")
    window.input("mousemove", 640, 60)
    window.save("style")


def polygons(window):
    """A level of the rabbit with its triangles, in the light theme."""
    window.click("menu:View")
    window.click("menu:Light")
    window.click("bar:mesh.faces", 0.45)
    window.key("7", "w")
    window.input("mousemove", 640, 790)
    window.save("polygons")


def study(window):
    """A grid of two parameters, run from the window."""
    window.move("bar:combine.k_normal")
    window.key("s")
    window.wait("the form", lambda state: "run study" in state["ui"])
    window.move("bar:combine.k_depth")
    window.key("shift+s")
    window.click("run study")
    window.wait("the study", lambda state: state["studies"]["list"] and state["studies"]["list"][0]["state"] == "finished")
    window.rest()
    window.save("study")


SHOTS = {"sheet": sheet, "judge": judge, "causes": causes, "fit": fit, "marks": marks, "ramps": ramps, "curve": curve, "style": style,
         "polygons": polygons, "study": study}


def main():
    names = sys.argv[1:] or list(SHOTS)
    unknown = set(names) - set(SHOTS)
    if unknown:
        sys.exit(f"no such picture: {', '.join(unknown)}; there are {', '.join(SHOTS)}")
    IMAGES.mkdir(parents=True, exist_ok=True)
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1920x1200x24", "-nolisten", "tcp"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    try:
        display = ":" + os.read(read, 16).decode().strip()
        for name in names:
            with tempfile.TemporaryDirectory() as folder:
                with Window(display, Path(folder)) as window:
                    SHOTS[name](window)
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
