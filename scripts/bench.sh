#!/bin/sh
# Builds and runs the benchmark on the shipped targets: bench.sh [options of build/bin/lrcs_bench]; --short takes seconds.
set -eu
cd "$(dirname "$0")/.."
scripts/install-deps.sh --bench
scripts/build.sh -DLRCS_BENCH=ON
build/bin/lrcs_bench examples/tess/tess.obj examples/turbine/turbine.off examples/propeller/propeller.stl "$@"
