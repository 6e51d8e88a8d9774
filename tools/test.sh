#!/usr/bin/env bash
# Set-up, build, and all tests. Further arguments go to ctest, e.g. -L unit or -R dump.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh --tests
tools/build.sh release
exec ctest --preset release --parallel "$(nproc)" "$@"
