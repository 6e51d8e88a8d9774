#!/usr/bin/env bash
# What tools/new.sh makes is built and tested in a copy of the tree, without pages: the program
# finds all four skeletons, their tests pass, and so do those of the house. npm and node are never
# called. Bad use is refused and leaves the tree as it is. Skipped (77) without git or ccache, which
# keeps it short: what has not changed is taken from other builds.
# Usage: skeletons_test.sh ROOT WORK
set -euo pipefail
root=$1
work=$2
for tool in git ccache; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed: skipped"; exit 77; }
done
cd "$root"
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "no checkout: skipped"; exit 77; }

# The same place each time, so that ccache knows it; built anew each time.
tree=$work/tree
rm -rf "$tree"
mkdir -p "$tree" "$work/bin"
git ls-files -co --exclude-standard -z | while IFS= read -r -d '' file; do
    [[ ! -f $file ]] || printf '%s\0' "$file"
done | tar -cf - --null -T - | tar -xf - -C "$tree"
cd "$tree"

fail() {
    echo "$1"
    exit 1
}
digest() {
    find . -path ./build -prune -o -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum
}
# refused TEXT ARGUMENTS...
refused() {
    local text=$1 before after status=0
    shift
    before=$(digest)
    bash tools/new.sh "$@" >"$work/log" 2>&1 || status=$?
    after=$(digest)
    [[ $status == 2 ]] && grep -q -- "$text" "$work/log" && [[ $before == "$after" ]] && return
    cat "$work/log"
    fail "not refused (status $status, text '$text'): new.sh $*"
}

refused usage
refused usage code
refused 'no kind' foam demo
refused 'no name' code Demo
refused 'no name' case ../demo
refused 'word of C++' oracle double
refused taken code native-dem
refused taken observable estimator-of
refused exists observable momentum
refused exists oracle plate_bounce
refused exists case bed-fluid
bash tools/new.sh code demo
bash tools/new.sh observable mean-demo
bash tools/new.sh oracle demo_time
bash tools/new.sh case demo-pair
refused exists code demo

for program in npm npx node nodejs; do
    # shellcheck disable=SC2016  # the quotes are for the program
    printf '#!/bin/sh\necho "$0 was called" >>"%s"\nexit 1\n' "$work/called" >"$work/bin/$program"
    chmod +x "$work/bin/$program"
done
rm -f "$work/called"
export PATH=$work/bin:$PATH
cmake --preset release -DCROSSGRAIN_PAGES=OFF >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
grep -q 'Without report pages' "$work/log" || fail 'configuring does not tell of pages'
tests=(demo_code measure_mean_demo analytic_demo_time catalog_shipped_cases reports_pages)
cmake --build --preset release --target program "${tests[@]/#/test_}" >"$work/log" 2>&1 ||
    { tail -n 60 "$work/log"; exit 1; }
pattern=$(IFS='|'; echo "${tests[*]}")
ctest --preset release -R "^($pattern|include_rule|formatting)\$"
[[ $(ctest --preset release -N -R "^($pattern)\$" | grep -c 'Test *#') == "${#tests[@]}" ]] ||
    fail "a test of a skeleton is not registered"

crossgrain=build/release/crossgrain
lists() {
    "$crossgrain" "$1" >"$work/log"
    grep -qE "$2" "$work/log" || fail "crossgrain $1 does not list $2"
}
lists codes '^demo +ok '
lists observables '^mean-demo +grains '
lists observables '^oracles: .*analytic:demo_time'
lists cases '^demo-pair '
"$crossgrain" --results "$work/results" --quiet run demo-pair --code native-dem --fresh |
    grep -q '1 agree' || fail "the skeleton of a case does not run"
[[ ! -e $work/called ]] || fail "$(cat "$work/called")"
echo "four skeletons are built, tested and found"
