#!/usr/bin/env bash
# Every C++ source is formatted as .clang-format says, every script of the pages as .prettierrc.json
# does. Skipped (77) without clang-format.
# Usage: formatting.sh ROOT [PRETTIER, default: that of build/release; "none" leaves scripts out]
set -euo pipefail
cd "$1"
prettier=${2:-build/release/tests/reports/web/npm/node_modules/.bin/prettier}
command -v clang-format >/dev/null || { echo "clang-format is not installed: skipped"; exit 77; }
folders=(native cases adapters reference reports app tests)
mapfile -t files < <(find "${folders[@]}" -name '*.cpp' -o -name '*.hpp')
[[ ${#files[@]} -gt 0 ]] || { echo "no sources found"; exit 1; }
clang-format --dry-run -Werror "${files[@]}"
echo "${#files[@]} C++ files are formatted"
if [[ $prettier == none ]]; then
    echo "scripts of the pages are not checked: this build has no pages"
    exit 0
fi
[[ -x $prettier ]] || {
    echo "prettier is not installed: ctest --preset release -R reports_web_modules does it" >&2
    exit 1
}
mapfile -t scripts < <(find "${folders[@]}" -name '*.js' -o -name '*.mjs')
[[ ${#scripts[@]} -gt 0 ]] || { echo "no scripts found"; exit 1; }
"$prettier" --log-level warn --check "${scripts[@]}"
echo "${#scripts[@]} scripts are formatted"
