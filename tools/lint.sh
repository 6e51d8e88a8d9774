#!/usr/bin/env bash
# clang-tidy over the sources, headers and tests that a change touches (default: the last commit),
# by the compile commands of build/release; shellcheck over all shell scripts; codespell over all
# that is written. Usage: tools/lint.sh [BASE]
# Exit code: 0 nothing that counts as an error, 1 a finding, 2 a tool or the build is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

base=${1:-HEAD~1}
for tool in clang-tidy shellcheck codespell; do
    command -v "$tool" >/dev/null || {
        echo "lint: $tool is not installed: run tools/setup.sh --tests" >&2
        exit 2
    }
done
failed=0

# The source through which a header is read: one that includes it, or that includes one that does.
source_of() {
    local includers includer
    [[ $1 != *.hpp ]] && { echo "$1"; return; }
    mapfile -t includers < <(git grep -lF "#include \"$1\"" -- '*.cpp' '*.hpp' | sort -t. -k2)
    for includer in "${includers[@]}"; do
        source_of "$includer" && return
    done
    return 1
}

# What clang-tidy says on either stream, without its counts of warnings in the headers of others.
# shellcheck disable=SC2317  # xargs calls it
tidy() {
    clang-tidy -p build/release --quiet "--line-filter=$1" "$2" 2>&1 |
        sed -E '/^([0-9]+ warnings?( and [0-9]+ errors?)? (generated|treated as errors?)\.?|Suppressed [0-9]+ warnings? .*|Use -header-filter=.*)$/d'
}
export -f tidy

lint_sources() {
    local file source changed=() sources=() filter=""
    mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp')
    if [[ ${#changed[@]} -eq 0 ]]; then
        echo "lint: no source has changed since $base"
        return 0
    fi
    [[ -f build/release/compile_commands.json ]] || {
        echo "lint: build/release is not configured: run tools/build.sh release" >&2
        exit 2
    }
    for file in "${changed[@]}"; do
        source=$(source_of "$file") || {
            echo "lint: no source includes $file: include it where it is needed, or delete it" >&2
            return 1
        }
        sources+=("$source")
        filter+="${filter:+,}{\"name\":\"$file\"}"
    done
    echo "lint: clang-tidy on ${#changed[@]} files changed since $base"
    printf '%s\n' "${sources[@]}" | sort -u |
        xargs -P "$(nproc)" -I{} bash -c 'set -o pipefail; tidy "$@"' tidy "[$filter]" {}
}

if git rev-parse -q --verify "$base^{commit}" >/dev/null; then
    lint_sources || failed=1
else
    echo "lint: $base is not a commit here: nothing to compare sources with"
fi

mapfile -t scripts < <(git grep -lIE '^#!.*\b(ba)?sh$' -- . | sort)
echo "lint: shellcheck on ${#scripts[@]} scripts"
shellcheck "${scripts[@]}" || failed=1

# Inputs of fuzz targets and hostile dumps are no texts; package-lock.json is full of digests.
mapfile -t texts < <(git ls-files -- . ':!tests/fuzz/corpus' ':!tests/hostile/dumps' \
    ':!*package-lock.json' ':!tools/spelling.txt')
echo "lint: codespell on ${#texts[@]} files"
codespell --ignore-words tools/spelling.txt "${texts[@]}" || failed=1
exit $failed
