#!/bin/sh
# Installs, builds and runs the benchmark: bench.sh [options of lrcs_bench]. --short: the minute that CI spends on it.
set -eu
cd "$(dirname "$0")/.."
scripts/install-deps.sh
scripts/build.sh -DLRCS_BENCH=ON
build/bin/lrcs_bench "$@"
