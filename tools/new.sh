#!/usr/bin/env bash
# Makes the skeleton of a case, an observable, a closed form or a code: files that build, register
# and pass their test, to be filled in where they say TODO. The lines in lists of the project go
# above comments that name this script. Usage: tools/new.sh case|observable|oracle|code NAME
# Exit code: 0 made, 1 a list has lost its mark, 2 bad use (nothing has been written).
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C

# Where things are; skeletons are in tools/skeletons.
cases=cases/catalog
observables=cases/measure/collision
observables_list=cases/measure/CMakeLists.txt
observables_tests=tests/cases/measure
observables_registry=cases/observables/observables_bed.cpp
oracles=reference/analytic
oracles_tests=tests/reference/analytic
oracles_registry=reference/oracles/oracles.cpp
codes=adapters
codes_tests=tests/adapters
codes_registry=adapters/registry/codes.cpp
program_list=adapters/registry/CMakeLists.txt
include_rule=tests/architecture/include_rule.cmake

refuse() {
    echo "new: $1" >&2
    exit 2
}
[[ $# -eq 2 ]] || refuse "usage: tools/new.sh case|observable|oracle|code NAME"
kind=$1
name=$2
[[ $kind =~ ^(case|observable|oracle|code)$ ]] ||
    refuse "'$kind' is no kind: case, observable, oracle or code"
[[ $name =~ ^[a-z][a-z0-9]*([-_][a-z0-9]+)*$ && ${#name} -le 40 ]] ||
    refuse "'$name' is no name: small letters and digits in words joined by - or _, at most 40"
snake=${name//-/_}
camel=$(sed -E 's/(^|[-_])(.)/\u\2/g' <<<"$name")

# Types and functions are named after it.
if [[ $kind != case ]] && command -v c++ >/dev/null; then
    c++ -x c++ -fsyntax-only - <<<"struct $camel {}; int $snake;" 2>/dev/null ||
        refuse "'$name' is a word of C++: choose another name"
fi

# make_file SKELETON FILE FOLDER
made=()
make_file() {
    mkdir -p "$(dirname "$2")"
    sed "s/@name@/$name/g; s/@snake@/$snake/g; s/@Name@/$camel/g; s#@folder@#$3#g" \
        "tools/skeletons/$1.in" >"$2"
    made+=("$2")
}
# absent FILE...: refuses names whose files exist.
absent() {
    local file
    for file in "$@"; do
        [[ ! -e $file ]] || refuse "$file exists: choose another name"
    done
}
# untaken TEXT FILE...: refuses a name that something else of the program has.
untaken() {
    local text=$1
    shift
    ! grep -rqF "$text" "$@" || refuse "$text is taken: $(grep -rlF "$text" "$@" | head -n 1)"
}

# add FILE LINES: above the comment of FILE that names this script and the kind, indented like it.
add() {
    local mark="tools/new.sh $kind:"
    [[ $(grep -cF "$mark" "$1") == 1 ]] || {
        echo "new: $1 must have the comment '$mark ...' once" >&2
        exit 1
    }
    MARK=$mark LINES_TO_ADD=$2 awk '
        index($0, ENVIRON["MARK"]) {
            indent = $0
            sub(/[^ ].*/, "", indent)
            count = split(ENVIRON["LINES_TO_ADD"], lines, "\n")
            for (i = 1; i <= count; ++i) print indent lines[i]
        }
        { print }' "$1" >"$1.new"
    mv "$1.new" "$1"
}

# add_include FILE HEADER: into the block of headers of the same top folder, in order.
add_include() {
    HEADER=$2 awk '
        BEGIN { line = "#include \"" ENVIRON["HEADER"] "\""; top = line; sub(/\/.*/, "/", top) }
        !done && seen && (index($0, top) != 1 || $0 > line) { print line; done = 1 }
        index($0, top) == 1 { if (!done && !seen && $0 > line) { print line; done = 1 } seen = 1 }
        { print }' "$1" >"$1.new"
    mv "$1.new" "$1"
    grep -qF "#include \"$2\"" "$1" || {
        echo "new: $1 includes nothing of ${2%%/*}: add '$2' by hand" >&2
        exit 1
    }
}

case $kind in
case)
    absent "$cases/$name.toml"
    make_file case.toml "$cases/$name.toml" "$cases"
    hint="$cases/README.md has a row per case"
    ;;
observable)
    absent "$observables/$snake".{hpp,cpp} "$observables_tests/${observables##*/}/${snake}_test.cpp"
    untaken "\"$name\"," cases/observables
    untaken "class $camel " cases/measure
    untaken "struct $camel " cases/measure
    for part in hpp cpp; do
        make_file "observable.$part" "$observables/$snake.$part" "$observables"
    done
    make_file observable_test.cpp \
        "$observables_tests/${observables##*/}/${snake}_test.cpp" "$observables"
    add "$observables_list" "${observables##*/}/$snake.cpp"
    add "$observables_tests/CMakeLists.txt" "measure_tests(${observables##*/} $snake)"
    add_include "$observables_registry" "$observables/$snake.hpp"
    add "$observables_registry" "GrainObservable::of<measure::$camel>(
    \"$name\", \"${observables##*/}\",
    \"$snake: TODO, until then the mean kinetic energy of a grain\"),"
    hint="a case asks for it by [[observable]] name = \"$name\""
    ;;
oracle)
    absent "$oracles/$snake".{hpp,cpp} "$oracles_tests/${snake}_test.cpp"
    untaken "\"analytic:$snake\"" reference/oracles
    untaken "struct $camel " "$oracles"
    for part in hpp cpp; do
        make_file "oracle.$part" "$oracles/$snake.$part" "$oracles"
    done
    make_file oracle_test.cpp "$oracles_tests/${snake}_test.cpp" "$oracles"
    add "$oracles/CMakeLists.txt" "$snake.cpp"
    add "$oracles_tests/CMakeLists.txt" "$snake"
    add_include "$oracles_registry" "$oracles/$snake.hpp"
    add "$oracles_registry" "{\"analytic:$snake\",
 [](const Scene& s) {
     return analytic::$snake({.height = s.initial.y.at(0),
                              .velocity = s.initial.vy.at(0),
                              .gravity = s.gravity});
 }},"
    hint="a check asks for it by against = \"analytic:$snake\""
    ;;
code)
    folder=$codes/$snake
    absent "$folder" "$codes_tests/$snake"
    untaken "return \"$name\"; }" "$codes"
    for part in hpp cpp; do
        make_file "code.$part" "$folder/${snake}_code.$part" "$folder"
    done
    make_file code_CMakeLists.txt "$folder/CMakeLists.txt" "$folder"
    make_file code_test.cpp "$codes_tests/$snake/${snake}_code_test.cpp" "$folder"
    make_file code_test_CMakeLists.txt "$codes_tests/$snake/CMakeLists.txt" "$folder"
    add "$codes/CMakeLists.txt" "add_subdirectory($snake)"
    add "$codes_tests/CMakeLists.txt" "add_subdirectory($snake)"
    add "$include_rule" "set(rule_$folder native/base cases/scene $codes)
list(APPEND rule_adapters/registry $folder)"
    add "$program_list" "$folder"
    add_include "$codes_registry" "$folder/${snake}_code.hpp"
    add "$codes_registry" \
        "list.push_back(engine<${camel}Code>({\"$folder\"}));"
    hint="README.md and ARCHITECTURE.md have tables of codes and of folders"
    ;;
esac

# Long names make other line breaks.
if command -v clang-format >/dev/null; then
    mapfile -t sources < <(printf '%s\n' "${made[@]}" "$observables_registry" "$oracles_registry" \
        "$codes_registry" | grep -E '[.][ch]pp$' || true)
    clang-format -i "${sources[@]}"
fi
printf 'new: %s\n' "${made[@]}" "$hint"
