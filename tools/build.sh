#!/usr/bin/env bash
# Configures and builds a preset, quietly: a line at the start and end, the log only on failure.
# Usage: tools/build.sh PRESET [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
targets=("${@:-all}")
echo "build: preset $preset in build/$preset"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
start=$SECONDS
if ! { cmake --preset "$preset" && cmake --build --preset "$preset" --target "${targets[@]}"; } >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "build: failed (its last lines are above)" >&2
    exit 1
fi
echo "build: done in $((SECONDS - start)) s"
