#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Vector files as other programs draw them, against OpenGL's pictures: vectors_test.py INKBENCH chromium|inkscape.

With INKBENCH_SCREENSHOTS=FOLDER what they draw is left there to look at.
"""

import base64
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
from PIL import Image

INKBENCH, PROGRAM = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2]
SIZE = 512
STYLES = {
    "plain": [],
    "rich": ["stroke.width=5", "stroke.taper_in=20", "stroke.taper_out=20", "stroke.wobble=1.5", "stroke.opacity=0.8",
             "stroke.colour=class", "stroke.crease.opacity=0.5", "stroke.object.opacity=0.5", "stroke.hidden=true",
             "curves.suggestive=true", "stroke.suggestive.opacity=0.5"],
    "shading": ["stroke.width=4", "stroke.colour=shading"],
}


def render(folder, form, settings, *options):
    command = [INKBENCH, "render", "--format", form, "--out", str(folder), *options]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def pixels(path):
    picture = Image.open(path).convert("RGBA")
    white = Image.new("RGBA", picture.size, "white")
    return numpy.asarray(Image.alpha_composite(white, picture).convert("RGB")).astype(float) / 255


class Chromium:
    def __init__(self, folder):
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service

        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for flag in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--force-color-profile=srgb", f"--user-data-dir={folder / 'profile'}"]:
            options.add_argument(flag)
        self.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)

    def draw(self, svg, png):
        size = {"width": SIZE, "height": SIZE, "deviceScaleFactor": 1, "mobile": False}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        self.browser.get(svg.as_uri())
        shot = self.browser.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})
        png.write_bytes(base64.b64decode(shot["data"]))

    def quit(self):
        self.browser.quit()


class Inkscape:
    def __init__(self, folder):
        self.environment = {**os.environ, "HOME": str(folder), "DISPLAY": ""}

    def draw(self, svg, png):
        command = ["inkscape", str(svg), "--export-type=png", f"--export-filename={png}", "--export-dpi=96",
                   "--export-area-page", "--export-background=white"]
        subprocess.run(command, check=True, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def quit(self):
        pass


class VectorsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="inkbench_vectors_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.program = {"chromium": Chromium, "inkscape": Inkscape}[PROGRAM](cls.folder)
        cls.addClassCleanup(cls.program.quit)
        for name, style in STYLES.items():
            for form in ("png", "svg"):
                render(cls.folder / name, form, style, "--buffers", "strokes,curves")

    def drawn(self, svg):
        png = svg.with_name(f"{svg.stem}_{PROGRAM}.png")
        self.program.draw(svg, png)
        if kept := os.environ.get("INKBENCH_SCREENSHOTS"):
            shutil.copy(png, pathlib.Path(kept) / f"{svg.parent.name}_{png.name}")
        picture = pixels(png)
        self.assertEqual(picture.shape, (SIZE, SIZE, 3))
        return picture

    def assert_alike(self, picture, wanted, most, most_in_ink):
        """Over the picture, and over the pixels that have ink in either of them: the programs antialias by a few
        samples a pixel."""
        squares = ((picture - wanted) ** 2).mean(axis=2)
        inked = numpy.minimum(picture, wanted).min(axis=2) < 1
        self.assertLessEqual(squares.mean() ** 0.5, most)
        self.assertLessEqual(squares[inked].mean() ** 0.5, most_in_ink)

    def test_strokes_are_drawn_as_opengl_draws_them(self):
        for name in STYLES:
            with self.subTest(name):
                strokes = self.drawn(self.folder / name / "strokes.svg")
                self.assert_alike(strokes, pixels(self.folder / name / "strokes.png"), 0.015, 0.07)

    def test_curves_are_drawn_as_opengl_draws_them(self):
        # OpenGL has covered curves of an earlier class over visible ones of a later class.
        for name, most, most_in_ink in (("plain", 0.015, 0.08), ("rich", 0.03, 0.12)):
            with self.subTest(name):
                curves = self.drawn(self.folder / name / "curves.svg")
                self.assert_alike(curves, pixels(self.folder / name / "curves.png"), most, most_in_ink)

    def test_shading_below_strokes_is_the_final_picture(self):
        settings = ["ink.from=strokes"]
        render(self.folder / "cartoon", "svg", settings, "--buffers", "strokes", "--regions")
        render(self.folder / "cartoon", "png", settings, "--buffers", "final")
        cartoon = self.drawn(self.folder / "cartoon" / "strokes.svg")
        self.assert_alike(cartoon, pixels(self.folder / "cartoon" / "final.png"), 0.03, 0.03)

    @unittest.skipIf(PROGRAM == "inkscape", "the same file")
    def test_pdf_is_the_same_drawing(self):
        render(self.folder / "rich", "pdf", STYLES["rich"], "--buffers", "strokes")
        pdf = self.folder / "rich" / "strokes.pdf"
        subprocess.run(["pdftoppm", "-r", "96", "-png", "-singlefile", str(pdf), str(pdf.with_suffix(""))], check=True)
        self.assert_alike(pixels(pdf.with_suffix(".png")), self.drawn(pdf.with_suffix(".svg")), 0.015, 0.07)

    @unittest.skipIf(PROGRAM == "inkscape", "it has no DOM to ask")
    def test_groups_are_found_by_class_and_object(self):
        self.program.browser.get((self.folder / "rich" / "strokes.svg").as_uri())
        for group in ("crease-box", "object-rabbit", "hidden-crease-box"):
            count = self.program.browser.execute_script(
                "return document.querySelectorAll('#' + arguments[0] + ' > path').length", group)
            self.assertGreater(count, 0, group)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
