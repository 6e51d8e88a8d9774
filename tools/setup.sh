#!/usr/bin/env bash
# Installs what a Debian 12 machine lacks to build, run and (with --tests) test crossgrain, or (with
# --fuzz) to fuzz it.
# Idempotent; works as root or with sudo; says what it does and stays silent when there is nothing
# to do. The list of packages is tools/packages.txt.
set -euo pipefail
cd "$(dirname "$0")/.."

purposes="build run"
[[ ${1:-} == --tests ]] && purposes="build run test"
[[ ${1:-} == --fuzz ]] && purposes="build fuzz"

missing=()
while read -r package purpose command; do
    [[ -z $package || $package == \#* || " $purposes " != *" $purpose "* ]] && continue
    [[ -n ${command:-} ]] && command -v "$command" >/dev/null && continue
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] && continue
    missing+=("$package")
done <tools/packages.txt

if [[ ${#missing[@]} -eq 0 ]]; then
    exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null || {
        echo "setup: these packages are missing and need root to install: ${missing[*]}" >&2
        exit 1
    }
    as_root=(sudo)
fi

echo "setup: installing ${#missing[@]} Debian packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() {
    "${as_root[@]}" apt-get update -q &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
            apt-get install -yq --no-install-recommends "${missing[@]}"
}
if ! install >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "setup: apt-get failed (its last lines are above)" >&2
    exit 1
fi
echo "setup: done"
