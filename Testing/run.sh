#!/usr/bin/env bash
# Installs what is needed, builds everything and runs the tests.
#
#     Testing/run.sh                      builds in build/
#     BUILD=/elsewhere Testing/run.sh
#     Testing/run.sh -R Silhouette        further arguments go to ctest
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build}

"$root/Testing/setup.sh"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$build" --parallel "$(nproc)"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
