#!/bin/sh
# Installs, builds, and runs every test: test.sh [CMake options].
set -eu
cd "$(dirname "$0")/.."
scripts/install-deps.sh
scripts/build.sh -DLRCS_TESTS=ON "$@"
ctest --test-dir build --output-on-failure -j"$(nproc)"
