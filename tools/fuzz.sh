#!/usr/bin/env bash
# Runs every fuzz target for a while, with address and undefined-behaviour sanitizers; needs clang.
# What they find is in build/fuzz/findings. Usage: tools/fuzz.sh [SECONDS EACH, default 60] [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
[[ $# -gt 0 ]] && shift
targets=("$@")
if [[ ${#targets[@]} -eq 0 ]]; then
    targets=(case scene sweep dump rule_table published_values prepared_state store_row)
fi
tools/setup.sh --fuzz
tools/build.sh fuzz "${targets[@]/#/fuzz_}"
mkdir -p build/fuzz/findings
failed=0
for target in "${targets[@]}"; do
    mkdir -p "build/fuzz/found/$target"
    log=build/fuzz/findings/$target.log
    # The first folder takes new inputs; those of the tree stay as they are.
    if "build/fuzz/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=3000 \
        -malloc_limit_mb=2000 -max_len=20000 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/findings/$target-" \
        "build/fuzz/found/$target" "tests/fuzz/corpus/$target" >"$log" 2>&1; then
        echo "fuzz: $target: no finding in $seconds s," \
            "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs"
    else
        failed=1
        echo "fuzz: $target: a finding, see $log" >&2
    fi
done
exit $failed
