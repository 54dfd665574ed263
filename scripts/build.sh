#!/bin/sh
# Configures and builds into build/: build.sh [CMake options]. Release unless told otherwise, and several sources at a
# time: a third of the work.
set -eu
cd "$(dirname "$0")/.."
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 "$@" >build.log 2>&1 || { cat build.log >&2; rm -f build.log; exit 1; }
rm -f build.log
cmake --build build -j"$(nproc)"
