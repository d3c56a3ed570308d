#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/fuzz.sh TARGET SECONDS: runs one fuzz target of the sanitize build; its findings stay in build/fuzz/TARGET.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
target=$1
seconds=$2
folder=$root/build/fuzz/$target
mkdir -p "$folder/corpus" "$folder/findings"
seeds=()
[ -d "$root/tests/fuzz/seeds/$target" ] && seeds=("$root/tests/fuzz/seeds/$target")
dictionary=()
[ -f "$root/tests/fuzz/$target.dict" ] && dictionary=("-dict=$root/tests/fuzz/$target.dict")
log=$folder/log
# The leak check at the end would crash on the thread-local storage of the many libraries that the image module brings.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}intercept_tls_get_addr=0
"$root/build/sanitize/tests/$target" -max_total_time="$seconds" -max_len=4000 -timeout=20 -rss_limit_mb=4096 \
  -artifact_prefix="$folder/findings/" "${dictionary[@]}" "$folder/corpus" "${seeds[@]}" >"$log" 2>&1 || {
  tail -n 40 "$log"
  echo "inkbench: error: $target found an input that breaks it; see $folder/findings" >&2
  exit 1
}
tail -n 1 "$log"
