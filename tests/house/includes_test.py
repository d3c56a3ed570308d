#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every include goes with the direction of the house: a folder includes itself, what it needs (CMakeLists.txt), and
what those need. No two files have one name.

    includes_test.py SOURCE_FOLDER FOLDERS_FILE
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


def needs_of(lines):
    """Folder by folder all that it may include, itself among them."""
    direct = {words[0]: words[1:] for words in (line.split() for line in lines) if words}

    def reach(folder, seen):
        if folder not in seen:
            seen.add(folder)
            for need in direct[folder]:
                reach(need, seen)
        return seen

    return {folder: reach(folder, set()) for folder in direct}


def main():
    root, folders = Path(sys.argv[1]), Path(sys.argv[2])
    needs = needs_of(folders.read_text().splitlines())
    faults, names = [], defaultdict(list)
    for path in sorted(p for top in ("pipeline", "studies", "app") for p in (root / top).rglob("*") if p.suffix in (".h", ".cpp")):
        here = str(path.relative_to(root).parent)
        names[path.name].append(path.relative_to(root))
        if here not in needs:
            faults.append(f"{path.relative_to(root)}: its folder is no target of CMakeLists.txt")
            continue
        for include in INCLUDE.findall(path.read_text()):
            target = str(Path(include).parent)
            if target not in needs[here]:
                faults.append(f"{path.relative_to(root)}: includes {include}, but {here} does not need {target}")
    faults += [f"{name}: two files have this name: {', '.join(map(str, paths))}" for name, paths in names.items() if len(paths) > 1]
    print("\n".join(faults) or f"{len(names)} files, every include with the direction")
    return 1 if faults or not names else 0


if __name__ == "__main__":
    sys.exit(main())
