#!/usr/bin/env bash
# Makes what the documentation shows again: the parameter table and the pictures. Run it after a change that they should show.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"
out=build/docs
mkdir -p docs/images

./run study studies/figures --out "$out/figures" >/dev/null
for figure in "$out"/figures/*/; do
  cp "$figure/grid.png" "docs/images/$(basename "$figure").png"
done
./run study studies/k_comparison.toml --out "$out/k_comparison" >/dev/null
cp "$out/k_comparison/grid.png" docs/images/k_comparison.png
./run study studies/buffers.toml --out "$out/buffers" >/dev/null
cp "$out/buffers/grid.png" docs/images/buffers.png

marker='<!-- generated: inkbench params --format markdown -->'
sed "/^$marker\$/q" docs/parameters.md >"$out/parameters.md"
./run params --format markdown >>"$out/parameters.md"
cp "$out/parameters.md" docs/parameters.md
echo "docs/ is up to date" >&2
