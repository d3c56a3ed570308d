#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes what the documentation shows again: the tables of parameters and measures, and the pictures. Run it after a change that they should show.
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

./run study studies/strokes_vs_filter.toml --out "$out/strokes_vs_filter" >/dev/null
cp "$out/strokes_vs_filter/charts/flicker.png" docs/images/strokes_vs_filter_flicker.png
./run study studies/antialiasing.toml --out "$out/antialiasing" >/dev/null
cells=("$out"/antialiasing/cells/00{01,03,05,07,09,02,04,06,08,10}_final.png)  # a row a method
scripts/enlarge_crops.py docs/images/antialiasing.png 355 265 48 60 4 5 "${cells[@]}"

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

mkdir -p docs/images/detectors
for study in detectors transfer turn edge_quality_by_dihedral; do
  ./run study "studies/$study.toml" --out "$out/$study" >/dev/null
done
cp "$out/detectors/grid.png" "$out/detectors/charts/f1.svg" "$out/transfer/charts/transfer.svg" docs/images/detectors/
cp "$out/detectors/charts/precision_recall_1.svg" docs/images/detectors/precision_recall.svg
cp "$out/turn/grid.png" docs/images/detectors/turn.png
for chart in three_f recall_by_class; do
  cp "$out/edge_quality_by_dihedral/charts/$chart.svg" "docs/images/edge_quality/${chart}_dihedral.svg"
done

./run study studies/styles.toml --out "$out/styles" >/dev/null
cp "$out/styles/grid.png" docs/images/styles.png
cells=("$out"/styles/cells/00{06,09,12,21}_final.png)  # ink brush, pencil, charcoal, marker
scripts/enlarge_crops.py docs/images/brushes.png 395 35 120 90 4 2 "${cells[@]}"

./run tune studies/tuning/models_k.toml --out "$out/models_k" >/dev/null
cp "$out/models_k/charts/box.svg" docs/images/tuning_models_k.svg

mkdir -p docs/images/vectors
# vectors NAME BUFFER ARGUMENT...
vectors() {
  ./run render --format svg --buffers "$2" "${@:3}" --out "$out/vectors" >/dev/null
  cp "$out/vectors/$2.svg" "docs/images/vectors/$1.svg"
}
part=(--scene data/scenes/model.toml --mesh debian:libcgal-demo/fandisk.off)
vectors cartoon strokes --regions --set stroke.width=3 --set stroke.taper_in=30 --set stroke.taper_out=30 --set stroke.outline=1.4 \
  --set stroke.bridge=12 --set stroke.shortest=14 --set stroke.smoothing=2 --set curves.suggestive=true --set curves.crease_angle=70
vectors hidden strokes "${part[@]}" --set stroke.hidden=true --set stroke.width=2.5
vectors plot curves "${part[@]}" --centre-lines --plot-width 120

# regenerate PAGE COMMAND...: what the command prints follows its marker, to the end of the page.
regenerate() {
  local page=$1
  shift
  sed "/^<!-- generated: inkbench $* -->\$/q" "docs/$page" >"$out/$page"
  ./run "$@" >>"$out/$page"
  cp "$out/$page" "docs/$page"
}
regenerate parameters.md params --format markdown
regenerate measures.md measure --list markdown
regenerate architecture.md passes --format markdown
./run passes --format dot | dot -Tsvg >docs/images/flow.svg
echo "docs/ is up to date" >&2
