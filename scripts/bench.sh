#!/bin/sh
# Installs, builds and runs the benchmarks: bench.sh [options of lrcs_bench], bench.sh --fit [options of
# lrcs_fit_bench], or bench.sh --import [options of lrcs_import_bench]. --short: the minute that CI spends on it, half a
# minute with --fit; with --import one run of each instead of five.
set -eu
cd "$(dirname "$0")/.."
program=lrcs_bench
case ${1:-} in
  --fit) program=lrcs_fit_bench; shift ;;
  --import) program=lrcs_import_bench; shift ;;
esac
scripts/install-deps.sh
scripts/build.sh -DLRCS_BENCH=ON
build/bin/$program "$@"
