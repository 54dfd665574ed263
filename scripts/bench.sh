#!/bin/sh
# Installs, builds and runs the benchmarks: bench.sh [options of lrcs_bench], or bench.sh --fit [options of
# lrcs_fit_bench]. --short: the minute that CI spends on it, half a minute with --fit.
set -eu
cd "$(dirname "$0")/.."
program=lrcs_bench
[ "${1:-}" != --fit ] || { program=lrcs_fit_bench; shift; }
scripts/install-deps.sh
scripts/build.sh -DLRCS_BENCH=ON
build/bin/$program "$@"
