#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_gpu.sh [OPTION...]: times every pass of every method by the graphics card's clock, draws with every shader there, and
# compares the pictures with the software renderer's. Options are gpu_benchmark's (--sizes, --runs, --tolerance, ...). Without a GPU it
# measures the software renderer and says so; INKBENCH_RENDERER=gpu makes that an error. Ends with 1 where something is missing or differs.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"
cmake --preset benchmarks >/dev/null
cmake --build build/benchmarks --target gpu_benchmark >/dev/null
benchmark=build/benchmarks/benchmarks/gpu_benchmark
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT
INKBENCH_RENDERER=software "$benchmark" --write "$pictures" >/dev/null
"$benchmark" "$@" --against "$pictures"
