#!/usr/bin/env bash
# The lint is checked on a small repository: it must find a fault in a source, in a header that only
# another header includes, in a test, in a script and in a text, and tell when it cannot compile.
# Skipped (77) where one of its tools is missing. Usage: lint_finds_faults.sh ROOT
set -euo pipefail
root=$1
for tool in git clang-tidy shellcheck codespell; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed: skipped"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir -p tools native/base tests build/release
cp "$root/tools/lint.sh" "$root/tools/spelling.txt" tools
cp "$root/.clang-tidy" .
echo /build/ >.gitignore
echo '#pragma once' >native/base/inner.hpp
printf '#pragma once\n#include "native/base/inner.hpp"\n' >native/base/outer.hpp
for source in native/base/a tests/a_test; do
    echo '#include "native/base/outer.hpp"' >$source.cpp
done
cat >build/release/compile_commands.json <<JSON
[{"directory": "$work", "file": "native/base/a.cpp", "command": "g++ -I. -c native/base/a.cpp"},
 {"directory": "$work", "file": "tests/a_test.cpp", "command": "g++ -I. -c tests/a_test.cpp"}]
JSON
export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a \
    GIT_COMMITTER_EMAIL=a@b
git init -q
git add -A
git commit -qm base

# expect STATUS TEXT FILE LINE: lint's answer once LINE is added to FILE.
expect() {
    local status=0
    [[ -z $3 ]] || printf '%s\n' "$4" >>"$3"
    git add -A
    bash tools/lint.sh HEAD >build/log 2>&1 || status=$?
    git reset -q --hard
    [[ $status == "$1" ]] && grep -q -- "$2" build/log && return
    echo "status $status, not $1 with '$2', for $3: $4"
    cat build/log
    exit 1
}
same='inline bool same(int a) { return a == a; }'
expect 0 'no source has changed' '' ''
expect 0 'clang-tidy on 1 files' native/base/a.cpp 'int five() { return 5; }'
expect 1 'a.cpp.*DivideZero' native/base/a.cpp 'int half(int a) { return a / 0; }'
expect 1 'inner.hpp.*bugprone-integer-division' native/base/inner.hpp \
    'inline double half(int a) { return a / 2; }'
expect 0 'inner.hpp.*misc-redundant-expression' native/base/inner.hpp "$same"
expect 1 'a_test.cpp.*DivideZero' tests/a_test.cpp 'int half(int a) { return a / 0; }'
expect 1 'unknown_type' tests/a_test.cpp 'unknown_type x;'
expect 1 'no source includes native/base/lost.hpp' native/base/lost.hpp '#pragma once'
# shellcheck disable=SC2016  # the quotes are the fault's
expect 1 SC2086 tools/a.sh '#!/usr/bin/env bash
rm $1'
expect 1 'recieve ==> receive' README.md 'what we recieve'
