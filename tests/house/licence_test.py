#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every source file says its licence in its first line, or in its second where the first has to be another.

    licence_test.py SOURCE_FOLDER
"""

import sys
from pathlib import Path

LINE = "SPDX-License-Identifier: MIT"
FOLDERS = ("app", "benchmarks", "data", "pipeline", "scripts", "shaders", "studies", "tests")
FILES = ("CMakeLists.txt", "check", "run")
# What has to be the first line of its file.
FIRST = ("#!", "#version ")
# What is no source, or is copied into what people make: scenes and studies are written anew from these examples, and the
# template of the report becomes a person's report. LICENSE covers them all.
FREE_SUFFIXES = (".toml", ".html", ".png", ".dict", ".supp")
FREE_FOLDERS = ("tests/fuzz/seeds",)


def is_free(path):
    return path.endswith(FREE_SUFFIXES) or path.startswith(tuple(f"{folder}/" for folder in FREE_FOLDERS))


def has_line(text):
    lines = text.splitlines()[:2]
    if lines and lines[0].startswith(FIRST):
        lines = lines[1:]
    return bool(lines) and LINE in lines[0]


def main():
    root = Path(sys.argv[1])
    paths = [p for folder in FOLDERS for p in (root / folder).rglob("*") if p.is_file() and "__pycache__" not in p.parts]
    names = sorted(str(p.relative_to(root)) for p in paths) + list(FILES)
    sources = [name for name in names if not is_free(name)]
    faults = [name for name in sources if not has_line((root / name).read_text(errors="replace"))]
    print("\n".join(f"{name}: does not open with a comment that says {LINE}" for name in faults)
          or f"{len(sources)} files say their licence")
    return 1 if faults or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
