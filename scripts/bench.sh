#!/bin/sh
# Installs, builds and runs the benchmarks: bench.sh [options of lrcs_bench], bench.sh --fit [options of
# lrcs_fit_bench], or bench.sh --curved [options of lrcs_curved_bench]. --short: what CI does of it, a minute or less.
set -eu
cd "$(dirname "$0")/.."
program=lrcs_bench
case "${1:-}" in --fit | --curved) program=lrcs_${1#--}_bench; shift ;; esac
scripts/install-deps.sh
scripts/build.sh -DLRCS_BENCH=ON
build/bin/$program "$@"
