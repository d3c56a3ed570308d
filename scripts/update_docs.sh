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
for study in k_comparison buffers edge_quality_quick; do
  ./run study "studies/$study.toml" --out "$out/$study" >/dev/null
  cp "$out/$study/grid.png" "docs/images/$study.png"
done

mkdir -p docs/images/edge_quality
for study in edge_quality_vs_polygons k_against_density; do
  ./run study "studies/$study.toml" --out "$out/$study" >/dev/null
done
for chart in recall_by_class inner_lines three_f normals; do
  cp "$out/edge_quality_vs_polygons/charts/$chart.svg" docs/images/edge_quality/
done
for chart in f1_by_k price; do
  cp "$out/k_against_density/charts/$chart.svg" docs/images/edge_quality/
done

marker='<!-- generated: inkbench params --format markdown -->'
sed "/^$marker\$/q" docs/parameters.md >"$out/parameters.md"
./run params --format markdown >>"$out/parameters.md"
cp "$out/parameters.md" docs/parameters.md
echo "docs/ is up to date" >&2
