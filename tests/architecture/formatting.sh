#!/usr/bin/env bash
# Every C++ source is formatted as .clang-format says. Skipped (77) without clang-format.
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is not installed: skipped"; exit 77; }
mapfile -t files < <(find native cases adapters reference reports app tests -name '*.cpp' -o -name '*.hpp')
[[ ${#files[@]} -gt 0 ]] || { echo "no sources found"; exit 1; }
clang-format --dry-run -Werror "${files[@]}"
echo "${#files[@]} files are formatted"
