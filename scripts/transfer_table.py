#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The transfer table of docs/detectors.md: of each detector the mean and the worst F in each kind of circumstance.

    transfer_table.py out/transfer/data.csv
"""

import csv
import sys
from collections import defaultdict


def main():
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    detectors = list(dict.fromkeys(row["edges.method"] for row in rows))
    values = defaultdict(list)
    for row in rows:
        kind = row["variant"].split()[0]
        for key in (row["variant"], "any " + kind):
            values[key, row["edges.method"]].append(float(row["f1"]))
    names = list(dict.fromkeys(row["variant"] for row in rows))
    print("| | " + " | ".join(detectors) + " |\n" + "|---" * (len(detectors) + 1) + "|")
    for name in names:
        cells = [values[name, detector] for detector in detectors]
        print(f"| {name} | " + " | ".join(f"{sum(c) / len(c):.3f} ({min(c):.3f})" for c in cells) + " |")
    for kind in ("planes", "size", "scale", "faces"):
        cells = [values["any " + kind, detector] for detector in detectors]
        print(f"| **any {kind}** | " + " | ".join(f"{sum(c) / len(c):.3f} ({min(c):.3f})" for c in cells) + " |")


if __name__ == "__main__":
    main()
