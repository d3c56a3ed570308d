#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What `cmake --install` leaves, moved elsewhere: install_test.py BUILD_FOLDER CONSUMER_FOLDER [unittest's arguments].

The built tree is installed below the build folder and the prefix moved. Then the program runs from another folder, and
programs outside the tree are built with the CMake package. The source tree is there all the while, so each test asks
which of the two was used.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, CONSUMER = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("INKBENCH_ROOT", "CMAKE_PREFIX_PATH")}


def run(*command, **options):
    return subprocess.run([str(word) for word in command], env=ENVIRONMENT, text=True, capture_output=True, **options)


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(dir=BUILD, prefix="install_test_")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.prefix = cls.folder / "moved here"
        installed = run("cmake", "--install", BUILD, "--prefix", cls.folder / "first")
        if installed.returncode != 0:
            raise AssertionError(installed.stdout + installed.stderr)
        (cls.folder / "first").rename(cls.prefix)
        cls.data = cls.prefix / "share/inkbench"

    def inkbench(self, *arguments):
        return run(self.prefix / "bin/inkbench", *arguments, cwd=self.folder)

    def succeeds(self, result):
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def test_version_is_printed(self):
        self.assertRegex(self.succeeds(self.inkbench("--version")), r"^inkbench \d")

    def test_info_names_the_installed_data(self):
        self.assertRegex(self.succeeds(self.inkbench("info")), f"(?m)^data +{re.escape(str(self.data))}$")

    def test_a_scene_is_drawn(self):
        self.succeeds(self.inkbench("render", "--size", "64x48", "--out", "drawn"))
        self.assertTrue((self.folder / "drawn/final.png").is_file())

    def test_an_image_of_another_kind_is_written_by_the_installed_module(self):
        arguments = ["render", "--size", "64x48", "--format", "exr", "--out", "module"]
        self.succeeds(self.inkbench(*arguments))
        module = self.prefix / "lib/inkbench/inkbench_image_codecs.so"
        content = module.read_bytes()
        self.addCleanup(module.write_bytes, content)
        module.write_bytes(b"no library")
        self.assertIn(f"{module}: images cannot be", self.inkbench(*arguments).stderr)

    def test_installed_studies_are_listed(self):
        (self.data / "studies/only_here.toml").write_text('title = "Here"\npurpose = "Told from the source tree\'s"\n')
        self.addCleanup((self.data / "studies/only_here.toml").unlink)
        self.assertIn("studies/only_here.toml ", self.succeeds(self.inkbench("study", "list")))

    def test_an_installed_study_finds_its_scene_and_the_page(self):
        self.succeeds(self.inkbench("study", self.data / "studies/figures/figure_03.toml", "--out", "figure"))
        self.succeeds(self.inkbench("tune", "list"))
        self.succeeds(self.inkbench("tune", "models_k", "--dry-run"))
        self.assertIn("Figure 3", (self.folder / "figure/index.html").read_text())

    def test_installed_shaders_are_used_before_those_of_the_source_tree(self):
        shader = self.data / "shaders/combine.frag"
        text = shader.read_text()
        self.addCleanup(shader.write_text, text)
        shader.write_text(text.replace("void main() {", "void main() { broken_here;"))
        result = self.inkbench("render", "--size", "64x48", "--out", "broken")
        self.assertIn("broken_here", result.stderr)

    def test_the_documentation_is_beside_the_data_for_the_window(self):
        self.assertTrue((self.data / "docs/workbench.md").is_file())

    def test_programs_outside_the_tree_are_built_with_the_package_and_use_what_it_installed(self):
        build = self.folder / "consumer"
        self.succeeds(run("cmake", "-G", "Ninja", "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}"))
        self.succeeds(run("cmake", "--build", build))
        self.assertEqual(self.succeeds(run(build / "draw", cwd=self.folder)), "64 x 48 x 3\n")
        self.assertEqual(self.succeeds(run(build / "sweep", cwd=self.folder)).splitlines(),
                         ["49", str(self.data), str(self.prefix / "lib/inkbench/inkbench_image_codecs.so")])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
