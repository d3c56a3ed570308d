#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/try_corpus.sh [--out FOLDER] [--limit SECONDS] FOLDER...: draws every mesh file below the folders, each in a
# process of its own with a time limit (20 s), and says how many were drawn, refused, failed or took too long; a table of the
# reasons; and a contact sheet of all that were drawn (FOLDER/sheet/grid.png, and grid_2.png, ...; out/corpus without --out).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
out=$root/out/corpus
limit=20
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=$2 && shift 2 ;;
    --limit) limit=$2 && shift 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || { sed -n '3,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
inkbench=${INKBENCH:-$root/build/release/inkbench}
[ -x "$inkbench" ] || { echo "inkbench: error: $inkbench is not built; ./run builds it, or set INKBENCH" >&2; exit 2; }

# From above and the side, so that flat things are seen, too.
view=(camera.eye=[5.6,5.6,8] camera.target=[0,1.6,0] camera.fov=36)

mkdir -p "$out"
rm -rf "$out/drawn" "$out/sheet"
# The formats are the program's to say.
endings=$("$inkbench" info --meshes | sed 's/, /\n/g; s/\./\\./g' | paste -sd'|' | sed 's/|/\\|/g')
find -L "$@" -type f -iregex ".*\($endings\)" -print0 | sort -z >"$out/files"
: >"$out/results"

# A line for each file: what became of it, its file, the error or the notes.
number=0
while IFS= read -r -d '' file; do
  number=$((number + 1))
  status=0
  timeout --kill-after=2 "$limit" "$inkbench" render --scene "$root/data/scenes/subject.toml" --mesh "$file" --size 240x180 \
    "${view[@]/#/--set=}" --out "$out/drawn/$number" >/dev/null 2>"$out/messages" </dev/null || status=$?
  case $status in
    0) kind=drawn ;;
    1) kind=failed ;;
    2) kind=refused ;;
    124 | 137) kind=late ;;
    *) kind=crashed ;;
  esac
  # The reason without the file's name, or the notes without what they count.
  reason=$(grep -m1 'inkbench: error:' "$out/messages" | sed 's/^inkbench: error: //' || true)
  reason=${reason//"$file"/FILE}
  [ "$kind" != drawn ] || reason=$(sed -n "s/^inkbench: note: model '[^']*': //p" "$out/messages" | sed 's/[0-9][0-9,.]*/N/g' | paste -sd'|')
  printf '%s\t%s\t%s\n' "$kind" "$file" "$reason" >>"$out/results"
done <"$out/files"
rm -f "$out/messages"

echo "$number files:"
cut -f1 "$out/results" | sort | uniq -c | sort -rn
echo
echo "Not drawn, by reason (numbers as N), with an example of each:"
awk -F'\t' '$1 != "drawn" {reason = $3; gsub(/[0-9][0-9,.]*/, "N", reason); key = $1 ": " reason; count[key]++; example[key] = $2}
  END {for (key in count) printf "%5d  %s\n       %s\n", count[key], key, example[key]}' "$out/results" |
  paste -d'\t' - - | sort -rn | tr '\t' '\n'
echo
echo "Drawn with notes:"
awk -F'\t' '$1 == "drawn" && $3 != "" {n = split($3, notes, "|"); delete seen
  for (i = 1; i <= n; ++i) if (!(notes[i] in seen)) {seen[notes[i]] = 1; count[notes[i]]++}}
  END {for (note in count) printf "%5d  %s\n", count[note], note}' "$out/results" | sort -rn

# The sheet is a study with a variant for each file that was drawn.
toml_text() { sed 's/\\/\\\\/g; s/"/\\"/g' <<<"$1"; }
spec=$out/corpus.toml
{
  printf 'title = "Contact sheet"\nscene = "%s"\nsize = [240, 180]\nshow = ["final"]\n' "$(toml_text "$root/data/scenes/subject.toml")"
  printf '[set]\n'
  printf '%s\n' "${view[@]/=/ = }"
  awk -F'\t' '$1 == "drawn" {print $2}' "$out/results" | while IFS= read -r file; do
    count=$((${count:-0} + 1))
    printf '[[variant]]\nname = "%s"\n[variant.set]\nmodel.subject.mesh = "%s"\nmodel.subject.normals = "file"\n' \
      "$count $(toml_text "$(basename "$file")")" "$(toml_text "$(realpath "$file")")"
  done
} >"$spec"
if grep -q '^\[\[variant\]\]' "$spec"; then
  "$inkbench" study "$spec" --out "$out/sheet" >/dev/null 2>"$out/study_messages" || tail -n 3 "$out/study_messages" >&2
  echo
  ls "$out"/sheet/grid*.png
fi
