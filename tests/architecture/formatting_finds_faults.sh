#!/usr/bin/env bash
# The check of formatting is checked: it must refuse a C++ source and a script that are not
# formatted, and accept them when they are. Skipped (77) without clang-format.
# Usage: formatting_finds_faults.sh ROOT PRETTIER
set -euo pipefail
root=$1
prettier=$2
command -v clang-format >/dev/null || { echo "clang-format is not installed: skipped"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work"/{native,cases,adapters,reference,reports,app,tests}
cp "$root/.clang-format" "$root/.prettierrc.json" "$work"

# verdict SOURCE SCRIPT: what the check says of a tree with these two.
verdict() {
    printf '%s\n' "$1" >"$work/native/a.cpp"
    printf '%s\n' "$2" >"$work/reports/a.js"
    if "$root/tests/architecture/formatting.sh" "$work" "$prettier" >"$work/log" 2>&1; then
        echo accepted
    else
        echo refused
    fi
}
# expect VERDICT SOURCE SCRIPT
expect() {
    [[ $(verdict "$2" "$3") == "$1" ]] && return
    echo "not $1: $2 with $3"
    cat "$work/log"
    exit 1
}
expect accepted 'int a = 1;' 'const a = 1;'
expect refused 'int  a=1;' 'const a = 1;'
if [[ $prettier != none ]]; then
    expect refused 'int a = 1;' 'const  a=1'
    expect refused 'int a = 1;' 'const = 1;'
fi
