#!/usr/bin/env bash
# Runs unit tests with sanitizers: address and undefined behaviour, or (preset tsan) threads.
# Usage: tools/sanitize.sh [asan-ubsan|tsan] [core|all]
# `core` are the tests of what reads from outside, starts programs, shares files, or manages memory
# by hand; `all` takes about three times as long to build.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-asan-ubsan}
core='^(base|toml|cases|fuzz|store)_|^catalog_(case_file|sweep|variants)$'
core+='|^adapters_(dump|dump_number|process|guard|identity|probe|program|scratch|temporary)'
core+='|^(dem_simd|dem_neighbour_list|friction_kernels|hopper_fast_engine|lga_engines_agree)$'
select=(-L unit -LE 'web|external')
targets=(all)
if [[ ${2:-core} == core ]]; then
    select+=(-R "$core")
    cmake --preset "$preset" >/dev/null
    mapfile -t targets < <(ctest --preset "$preset" -N "${select[@]}" |
        sed -nE 's/^ *Test +#[0-9]+: (fuzz_)?(.*)$/\1\2/p' | sed -E '/^fuzz_/!s/^/test_/')
fi
tools/build.sh "$preset" "${targets[@]}"
ctest --preset "$preset" --parallel "$(nproc)" "${select[@]}"
