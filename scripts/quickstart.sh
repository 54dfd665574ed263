#!/bin/sh
# Installs, builds, and runs the main job on a shipped target: the laser radar cross section of the TESS satellite.
set -eu
cd "$(dirname "$0")/.."
scripts/install-deps.sh
scripts/build.sh -DLRCS_TESTS=OFF
build/bin/lrcs sweep examples/tess/scene.yaml -o results/tess
echo "numbers:   $PWD/results/tess/sweep.csv"
echo "pictures:  $PWD/results/tess/sweep.png, polar.png, facets-0.png"
echo "facets:    $PWD/results/tess/facets-0.vtp (opens in ParaView)"
echo "run facts: $PWD/results/tess/manifest.json"
