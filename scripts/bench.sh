#!/bin/sh
# Installs, builds and runs the benchmarks: bench.sh [options of lrcs_bench], or with --fit, --curved or --import first
# those of lrcs_fit_bench, lrcs_curved_bench or lrcs_import_bench. --short: what CI does of it, a minute or less.
set -eu
cd "$(dirname "$0")/.."
program=lrcs_bench
case "${1:-}" in --fit | --curved | --import) program=lrcs_${1#--}_bench; shift ;; esac
scripts/install-deps.sh
scripts/build.sh -DLRCS_BENCH=ON
build/bin/$program "$@"
