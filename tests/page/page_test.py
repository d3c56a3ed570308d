#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The report page in headless Chromium: page_test.py INKBENCH SAMPLE_PAGES [unittest's arguments].

A small real study and sample pages are written into a temporary folder and opened by file://.
With INKBENCH_SCREENSHOTS=FOLDER pictures of page and viewer are left there to look at.
"""

import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

INKBENCH, SAMPLE_PAGES = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:3])
HOSTILE = "</script><script>window.broken = 1</script><img src=x onerror='window.broken = 1'> \"quoted\" & <b>bold"
SPEC = """
title = '''%s'''
purpose = "A real study, small"
size = [320, 240]
show = ["final", "combined_edges"]
measure = ["f1", "recall"]
[[axis]]
key = "combine.k_depth"
label = "k depth"
values = [0.001, 0.003, 0.03]
[[axis]]
key = "combine.k_normal"
label = "k normal"
values = [0.0125, 0.1]
""" % HOSTILE

VARIANTS = """
title = "An axis and variants"
size = [64, 48]
[[axis]]
key = "combine.k_depth"
values = [0.003, 0.03]
[[variant]]
name = "machine"
[[variant]]
name = "rabbit"
"""


def write_pages(folder):
    for name, spec in (("small", SPEC), ("variants", VARIANTS)):
        (folder / f"{name}.toml").write_text(spec)
        study = [INKBENCH, "study", f"{name}.toml", "--out", name]
        subprocess.run(study, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for kind in ("full", "large"):
        subprocess.run([SAMPLE_PAGES, kind, folder / kind], check=True)


def start_browser(folder):
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    flags = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
             "--force-color-profile=srgb", f"--user-data-dir={folder / 'profile'}"]
    for flag in flags:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="inkbench_page_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        write_pages(cls.folder)
        cls.browser = start_browser(cls.folder)
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.browser.get("about:blank")
        for log in ("browser", "performance"):
            self.browser.get_log(log)  # what came before is not this test's
        self.resize(1280, 800)

    # What the tests do.

    def js(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def cdp(self, command, **arguments):
        return self.browser.execute_cdp_cmd(command, arguments)

    def resize(self, width, height, mobile=False):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def open(self, name, fragment=""):
        self.browser.get("about:blank")
        self.browser.get((self.folder / name / "index.html").as_uri() + fragment)

    def press(self, *keys):
        for key in keys:
            ActionChains(self.browser).send_keys(key).perform()

    def wait(self, condition, message="nothing happened"):
        return WebDriverWait(self.browser, 10, poll_frequency=0.05).until(lambda _: condition(), message)

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def cell(self, number):
        return self.find(f'.cell[data-cell="{number - 1}"]')

    def is_open(self):
        return self.js("return document.getElementById('viewer').open")

    def pictures(self):
        """What is seen in the middle of each window of the viewer: [alt, natural width and height]."""
        return self.js("""
            return [...document.querySelectorAll('.window')].map((area) => {
              const box = area.getBoundingClientRect();
              const top = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
              return top && top.matches('img.picture') ? [top.alt, top.naturalWidth, top.naturalHeight] : null;
            });""")

    def wait_for_cell(self, number):
        def is_shown():
            seen = self.pictures()
            return seen and all(one and one[0].endswith(f" of cell {number}") for one in seen)
        self.wait(is_shown, f"cell {number} is not shown")

    def screenshot(self, clip=None):
        time.sleep(0.1)  # what was just changed is drawn
        more = {"clip": {**clip, "scale": 1}} if clip else {}
        return base64.b64decode(self.cdp("Page.captureScreenshot", **more)["data"])

    def stage_picture(self):
        box = self.js("const b = document.querySelector('.window').getBoundingClientRect();"
                      "return {x: b.x, y: b.y, width: b.width, height: b.height}")
        return self.screenshot(box)

    def count_pixels(self, png, condition):
        """How many pixels of a PNG meet a condition in JavaScript on r, g, b."""
        return self.browser.execute_async_script("""
            const [data, done] = arguments;
            const isMeant = (r, g, b) => CONDITION;
            const image = new Image();
            image.onload = () => {
              const canvas = document.createElement('canvas');
              [canvas.width, canvas.height] = [image.width, image.height];
              const context = canvas.getContext('2d');
              context.drawImage(image, 0, 0);
              const p = context.getImageData(0, 0, image.width, image.height).data;
              let count = 0;
              for (let i = 0; i < p.length; i += 4) count += isMeant(p[i], p[i + 1], p[i + 2]) ? 1 : 0;
              done(count);
            };
            image.src = 'data:image/png;base64,' + data;
            """.replace("CONDITION", condition), base64.b64encode(png).decode())

    def keep(self, name):
        folder = os.environ.get("INKBENCH_SCREENSHOTS")
        if folder:
            pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
            (pathlib.Path(folder) / f"{name}.png").write_bytes(self.screenshot())

    FIND_HEAD = """
        const heads = [...document.querySelectorAll('.data thead th')];
        const index = heads.findIndex((head) => head.innerText.replace(/[\\s↑↓]/g, '') === arguments[0]);
        """

    def column(self, name):
        """The table's fields in a column, top to bottom, as their full texts."""
        return self.js(self.FIND_HEAD + """
            const rows = [...document.querySelectorAll('.data tbody tr[data-cell]')];
            return rows.map((row) => row.children[index].title || row.children[index].innerText);
            """, name)

    def sort_state(self, name):
        return self.js(self.FIND_HEAD + "return heads[index].ariaSort;", name)

    def assert_fits(self, width):
        self.assertLessEqual(self.js("return document.scrollingElement.scrollWidth"), width)

    def assert_quiet(self):
        """No message in the console, nothing asked of the network, since the last call."""
        self.assertEqual([entry["message"] for entry in self.browser.get_log("browser")], [])
        for entry in self.browser.get_log("performance"):
            event = json.loads(entry["message"])["message"]
            if event["method"] == "Network.requestWillBeSent":
                self.assertRegex(event["params"]["request"]["url"], r"^(file|data|about):")

    # Claims.

    def test_page_opens_without_errors_and_without_network(self):
        for name in ("small", "full", "large"):
            with self.subTest(name):
                self.open(name)
                self.wait(lambda: self.js("return document.querySelectorAll('.cell img').length > 0"))
                self.assert_quiet()

    def test_thumbnails_are_pictures(self):
        self.open("small")
        images = "[...document.querySelectorAll('.cell img')]"
        self.wait(lambda: self.js(f"return {images}.every((image) => image.complete)"))
        widths = self.js(f"return {images}.map((image) => image.naturalWidth)")
        self.assertEqual(len(widths), 12)
        self.assertTrue(all(width >= 180 for width in widths), widths)
        self.keep("page")

    def test_file_alone_shows_its_grid_and_opens_cells(self):
        (self.folder / "alone").mkdir()
        shutil.copy(self.folder / "small/index.html", self.folder / "alone")
        self.open("alone")
        images = "[...document.querySelectorAll('.cell img')]"
        self.wait(lambda: self.js(f"return {images}.every((image) => image.complete)"))
        self.assertTrue(all(self.js(f"return {images}.map((image) => image.naturalWidth > 0)")))
        self.cell(2).click()
        self.wait_for_cell(2)

    def test_texts_are_texts(self):
        for name in ("small", "full"):
            with self.subTest(name):
                self.open(name)
                self.assertEqual(self.find("h1").get_property("textContent"), HOSTILE)
                self.assertEqual(self.browser.title, HOSTILE)
                self.assertIsNone(self.js("return window.broken ?? null"))
        self.cell(3).click()
        self.wait_for_cell(3)
        self.assertIn(HOSTILE, self.find("#viewer-name").text)
        self.press("a", Keys.ARROW_DOWN)  # the failed one
        self.wait(lambda: HOSTILE in self.find("#viewer-side").text)
        self.assertIn(HOSTILE, self.find("#stage").text)
        self.assertIsNone(self.js("return window.broken ?? null"))

    def test_click_shows_all_pictures_at_full_size(self):
        self.open("small")
        self.cell(5).click()
        self.wait_for_cell(5)
        self.assertEqual(self.pictures(), [["final of cell 5", 320, 240], ["combined_edges of cell 5", 320, 240]])
        sizes = self.js("return [...document.querySelectorAll('img.picture')].map((i) => [i.width, i.height])")
        self.assertEqual(sizes, [[320, 240], [320, 240]], "one pixel to one, as there is room")
        self.assertIn("k_depth = 0.003, k_normal = 0.1", self.find("#viewer-name").text)
        fields = self.find("#viewer-side").text
        for text in ("combine.k_depth", "0.003", "f1", "recall"):
            self.assertIn(text, fields)
        self.keep("viewer")
        self.assert_quiet()

    def test_enter_opens_and_escape_returns_the_focus(self):
        self.open("small")
        self.js("document.querySelector('.cell').focus()")
        self.press(Keys.ARROW_RIGHT, Keys.ARROW_DOWN, Keys.ENTER)
        self.wait_for_cell(5)
        self.press(Keys.ESCAPE)
        self.wait(lambda: not self.is_open())
        self.assertEqual(self.js("return document.activeElement.dataset.cell"), "4")
        self.wait(lambda: "cell=" not in self.browser.current_url)

    def test_flip_shows_the_other_cell_in_its_place(self):
        self.open("small", "#cell=1")
        self.wait_for_cell(1)
        self.press("f", "+")
        first = self.stage_picture()
        self.press("a", Keys.ARROW_DOWN)
        self.wait_for_cell(4)
        self.press("x")
        self.wait_for_cell(1)
        self.assertEqual(self.find(".side-of[aria-pressed=true] b").text, "A")
        self.press(" ")
        self.wait_for_cell(4)
        self.assertEqual(self.find(".side-of[aria-pressed=true] b").text, "B")
        self.assertEqual(self.find("#stage").get_attribute("data-shown"), "b")
        self.keep("viewer_compare")
        places = self.js("""
            const images = [...document.querySelector('.window').querySelectorAll('img.picture')];
            return images.map((image) => JSON.stringify(image.getBoundingClientRect()));""")
        self.assertEqual(len(places), 2)
        self.assertEqual(places[0], places[1])
        second = self.stage_picture()
        self.assertNotEqual(first, second)
        self.press(" ", " ")
        self.assertEqual(self.stage_picture(), second, "nothing moves")

    def test_difference_is_black_for_equal_cells(self):
        self.open("full", "#cell=1&a=1&difference=1")
        self.wait(lambda: self.js("return document.querySelectorAll('.layer img.picture').length") == 8)
        self.wait(lambda: self.count_pixels(self.stage_picture(), "r + g + b > 0") == 0)
        self.press(Keys.ARROW_RIGHT)
        self.wait(lambda: "Cell 2" in self.find("#viewer-compare").text)
        self.wait(lambda: self.count_pixels(self.stage_picture(), "r + g + b > 600") > 50)

    def test_arrows_go_to_neighbours_and_pages(self):
        self.open("full", "#cell=1")
        self.wait_for_cell(1)
        for key, number in ((Keys.ARROW_RIGHT, 2), (Keys.ARROW_DOWN, 6), (Keys.ARROW_LEFT, 5), (Keys.ARROW_LEFT, 5),
                            (Keys.PAGE_DOWN, 17), (Keys.ARROW_UP, 13), (Keys.PAGE_UP, 1)):
            self.press(key)
            self.wait_for_cell(number)
        self.press(Keys.PAGE_DOWN, Keys.ESCAPE)
        self.wait(lambda: self.js("return document.activeElement.dataset.cell") == "12")

    def test_reference_lines_lie_over_the_pictures(self):
        self.open("full", "#cell=1")
        self.wait_for_cell(1)
        self.wait(lambda: self.js("return [...document.querySelectorAll('.overlay img')].every((i) => i.complete)"))
        plain = self.stage_picture()
        self.press("r")
        self.wait(lambda: self.stage_picture() != plain)
        magenta = "r > 220 && g < 60 && b > 120 && b < 200"
        self.assertGreater(self.count_pixels(self.stage_picture(), magenta), 200, "black lines stand out from ink")
        self.assertEqual(self.count_pixels(plain, magenta), 0)
        self.assertIn("silhouette", self.find("#viewer-side").text)
        self.keep("viewer_reference")
        self.press("r")
        self.wait(lambda: self.stage_picture() == plain)

    def test_causes_lie_over_the_pictures_with_a_legend(self):
        self.open("full", "#cell=1")
        self.wait_for_cell(1)
        self.wait(lambda: self.js("return [...document.querySelectorAll('.causes img')].every((i) => i.complete)"))
        plain = self.stage_picture()
        self.press("c")
        self.wait(lambda: self.stage_picture() != plain)
        self.assertIn("false: grazing", self.find("#viewer-side").text)
        self.assertIn("causes=1", self.browser.current_url)
        self.keep("viewer_causes")
        self.press("c")
        self.wait(lambda: self.stage_picture() == plain)

    def test_zoom_and_pan_are_shared(self):
        self.open("small", "#cell=1")
        self.wait_for_cell(1)
        self.press("f", "+", "+", "+")
        self.wait(lambda: self.find("#zoom-now").text == "800 %")
        area = self.find(".window")
        places = "return [...document.querySelectorAll('img.picture')].map((i) => [i.offsetLeft, i.offsetTop, i.width])"
        before = self.js(places)
        ActionChains(self.browser).drag_and_drop_by_offset(area, 60, 40).perform()
        after = self.js(places)
        for old, new in zip(before, after):
            self.assertEqual([new[0] - old[0], new[1] - old[1], new[2]], [60, 40, 2560])
        self.assertEqual(after[0], after[1])
        rendering = self.js("return getComputedStyle(document.querySelector('img.picture')).imageRendering")
        self.assertEqual(rendering, "pixelated")

    def test_link_opens_what_was_shown(self):
        self.open("full", "#cell=10")
        self.wait_for_cell(10)
        self.press("a", Keys.ARROW_LEFT, "r", "2", "x")
        parts = ("cell=9", "a=10", "show=a", "reference=1", "picture=2")
        self.wait(lambda: all(part in self.browser.current_url for part in parts))
        fragment = "#" + self.browser.current_url.split("#")[1]
        picture = self.stage_picture()
        self.open("full", fragment)
        self.wait_for_cell(10)
        self.assertEqual([one[0] for one in self.pictures()], ["front · edges of cell 10"])
        self.wait(lambda: self.stage_picture() == picture)
        for wrong in ("#cell=0", "#cell=99", "#cell=x&a=-1", "#cell=1&a=99&zoom=nan&picture=77"):
            self.open("full", wrong)
            self.assertEqual(self.is_open(), wrong.startswith("#cell=1&"))
            self.assert_quiet()

    def test_keys_work_after_clicks(self):
        self.open("small", "#cell=1&a=2")
        self.wait_for_cell(1)
        self.find(".side-of[data-which=a]").click()
        self.wait_for_cell(2)
        self.press(Keys.ARROW_DOWN)
        self.wait_for_cell(4)
        self.find(".pane-name").click()
        self.wait(lambda: len(self.pictures()) == 1)
        self.press("0", Keys.ARROW_UP)
        self.wait_for_cell(1)
        self.assertEqual(len(self.pictures()), 2)
        self.find("#zoom-in").click()
        self.press(" ")
        self.wait_for_cell(2)

    def test_back_closes_the_viewer(self):
        self.open("small")
        self.cell(1).click()
        self.wait_for_cell(1)
        self.browser.back()
        self.wait(lambda: not self.is_open())
        self.browser.forward()
        self.wait_for_cell(1)

    def test_columns_sort_by_number_with_empty_fields_last(self):
        self.open("full")
        head = self.find("[data-column='4']")
        head.click()
        upwards = self.column("f1")
        self.assertEqual(self.sort_state("f1"), "ascending")
        numbers = [float(text) for text in upwards if text not in ("", "nan")]
        self.assertEqual(numbers, sorted(numbers))
        self.assertNotEqual(upwards, sorted(upwards), "not as text")
        self.assertEqual(set(upwards[-3:]), {"", "nan"})
        self.press(Keys.ENTER)  # the head still has the focus
        downwards = self.column("f1")
        self.assertEqual(self.sort_state("f1"), "descending")
        self.assertEqual([float(text) for text in downwards[:-3]], numbers[::-1])
        self.assertEqual(set(downwards[-3:]), {"", "nan"})
        self.press(Keys.ENTER)
        self.assertEqual(self.sort_state("f1"), "none")
        self.assertEqual(self.column("cell"), [str(i) for i in range(1, 25) if i != 8])

    def test_measures_say_what_they_mean(self):
        self.open("small")
        heads = self.js("return [...document.querySelectorAll('th button')].map((b) => [b.textContent, b.title])")
        meanings = {name: title for name, title in heads}
        self.assertEqual(meanings["recall"], "Of what belongs, this share is drawn.")
        self.assertEqual(meanings["cell"], "")

    def test_row_opens_its_cell_and_gets_the_focus_back(self):
        self.open("small")
        self.js("arguments[0].scrollIntoView({block: 'center'})", self.find(".data tbody"))
        self.find(".data tbody tr[data-cell='3'] td:nth-child(3)").click()
        self.wait_for_cell(4)
        self.press(Keys.ESCAPE)
        self.wait(lambda: self.js("return document.activeElement.textContent") == "4")

    def test_table_shows_short_numbers_and_keeps_the_whole_ones(self):
        self.open("small")
        fields = self.js("""
            const rows = [...document.querySelectorAll('.data tbody tr')];
            return rows.map((row) => [row.children[5].innerText, row.children[5].title]);""")
        data = (self.folder / "small/data.csv").read_text().splitlines()
        for (short, whole), line in zip(fields, data[1:]):
            self.assertEqual(whole, line.split(",")[5])
            self.assertRegex(short, r"^\d\.\d{4}$")
            self.assertAlmostEqual(float(short), float(whole), places=4)

    def test_nothing_is_wider_than_a_phone(self):
        self.resize(375, 740, mobile=True)
        for name in ("small", "full", "large"):
            with self.subTest(name):
                self.open(name)
                self.assert_fits(375)
                self.keep(f"phone_{name}")
                self.open(name, "#cell=1&a=2&reference=1")
                self.wait(self.is_open)
                self.assert_fits(375)
                self.assertLessEqual(self.js("return document.querySelector('.viewer-body').scrollWidth"), 375)
                outside = self.js("""
                    const all = [...document.querySelectorAll('#viewer :not(.window *)')];
                    return all.filter((e) => e.getBoundingClientRect().right > 376).map((e) => e.className);""")
                self.assertEqual(outside, [])
                self.keep(f"phone_viewer_{name}")

    def test_variants_are_called_so_and_their_short_names_stay_on_a_line(self):
        self.open("variants")
        self.assertEqual(self.js("return [...document.querySelectorAll('.corner .axis')].map((e) => e.textContent)"),
                         ["variant", "k_depth"])
        lines = self.js("""
            const range = document.createRange();
            return [...document.querySelectorAll('.grid-table tbody th, .corner .axis')].map((e) => {
              range.selectNodeContents(e);
              return range.getClientRects().length;
            });""")
        self.assertEqual(lines, [1, 1, 1, 1])

    def test_dark_and_light_follow_the_reader(self):
        self.open("small")
        colours = {}
        for scheme in ("light", "dark"):
            self.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.keep(f"page_{scheme}")
            colours[scheme] = self.js("const s = getComputedStyle(document.body); return [s.backgroundColor, s.color]")
        self.cdp("Emulation.setEmulatedMedia", features=[])
        brightness = {scheme: [sum(map(int, re.findall(r"\d+", colour)[:3])) for colour in both]
                      for scheme, both in colours.items()}
        self.assertGreater(brightness["light"][0] - brightness["light"][1], 500)
        self.assertGreater(brightness["dark"][1] - brightness["dark"][0], 500)

    def test_of_ten_thousand_cells_those_in_sight_are_laid_out(self):
        self.open("large")
        self.wait(lambda: self.js("return document.querySelectorAll('.cell img').length > 0"))
        self.assertLess(self.js("return document.querySelectorAll('*').length"), 20_000)
        self.assertEqual(self.js("return document.querySelector('.data').getAttribute('aria-rowcount')"), "10001")
        self.js("document.getElementById('table-box').scrollTop = 1e9")
        self.wait(lambda: self.column("cell")[-1] == "10000")
        self.js("document.getElementById('grid-box').scrollTop = 1e9")
        self.wait(lambda: self.js("return document.querySelector('.cell[data-cell=\"9999\"] img')?.naturalWidth > 0"))

    def test_keys_are_told(self):
        self.open("small")
        self.press("?")
        self.wait(lambda: "flips between A and B" in self.find("#keys").text)
        self.press(Keys.ESCAPE)
        self.wait(lambda: not self.js("return document.getElementById('keys').open"))

    def test_paper_has_every_row_of_grid_and_table_and_no_controls(self):
        self.resize(1280, 300)
        self.open("full")
        filled = "return document.querySelectorAll('.cell').length"
        self.js("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.js(filled), 12)
        self.assertEqual(len(self.column("cell")), 23)
        self.assertTrue(self.find(".spec").get_property("open"))
        self.cdp("Emulation.setEmulatedMedia", media="print")
        shown = self.js("""
            return [...document.querySelectorAll('.tools, .contents, dialog')].filter((e) => e.offsetParent).length""")
        self.cdp("Emulation.setEmulatedMedia", media="")
        self.assertEqual(shown, 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
