#!/usr/bin/env bash
# clang-tidy over the sources that a change touches (default: the last commit). It needs the compile
# commands of build/release. Usage: tools/lint.sh [BASE]
set -euo pipefail
cd "$(dirname "$0")/.."

base=${1:-HEAD~1}
git rev-parse -q --verify "$base" >/dev/null || {
    echo "lint: $base is not a commit here: nothing to compare with"
    exit 0
}
mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' ':!tests')
if [[ ${#changed[@]} -eq 0 ]]; then
    echo "lint: no source has changed since $base"
    exit 0
fi
echo "lint: clang-tidy on ${#changed[@]} files changed since $base"
printf '%s\n' "${changed[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/release --quiet 2>/dev/null
