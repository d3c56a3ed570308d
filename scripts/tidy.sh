#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/tidy.sh [FILE...]: clang-tidy, as .clang-tidy says, over these sources or all of pipeline/, studies/ and app/.
# Prints the findings alone; exit status 1 if there are any. Nothing is built: build/tidy holds only the compile commands.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
folder=$root/build/tidy
mkdir -p "$folder"

# Headers are most of the work, so all sources are read as they are compiled, several together; named ones each alone.
unity=ON
[ $# -gt 0 ] && unity=OFF
cmake -S "$root" -B "$folder" -G Ninja -D CMAKE_CXX_COMPILER=clang++ -D INKBENCH_UNITY=$unity -D INKBENCH_TESTS=OFF \
  >"$folder/configure.log" 2>&1 || {
  cat "$folder/configure.log" >&2
  exit 1
}

# Sources that the build itself writes are left out.
list() {
  if [ $# -gt 0 ]; then
    realpath -- "$@"
  else
    sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$folder/compile_commands.json" | grep -vE "^$root/scripts/|/generated/"
  fi
}

# Together, a source is included by another file, which is no finding. A header is read by many: its finding counts once.
found=$folder/found
rm -rf "$found"
mkdir "$found"
status=0
# shellcheck disable=SC2016
list "$@" | xargs -d '\n' -P "$(nproc)" -n 1 sh -c \
  'clang-tidy -p "$0" --quiet --checks=-bugprone-suspicious-include "$2" >"$1/$$.txt" 2>"$1/$$.log"' "$folder" "$found" ||
  status=$?
findings=$(cat "$found"/*.txt | grep -E '^/.*: (error|warning): ' | sed "s#^$root/##" | sort -u || true)
if [ -n "$findings" ]; then
  printf '%s\n' "$findings"
  exit 1
fi
if [ $status -ne 0 ]; then
  cat "$found"/*.txt "$found"/*.log >&2
  exit 1
fi
