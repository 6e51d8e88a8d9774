#!/usr/bin/env bash
# Set-up, build, and the main job: every case of the quick suite in all codes, verdicts, report.
# Further arguments go to `crossgrain validate`.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
tools/build.sh release program
exec build/release/crossgrain validate --suite quick "$@"
