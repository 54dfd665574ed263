#!/bin/sh
# Runs every example: all scenes, and the C++ program against an installed copy of the library. Needs a finished build.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for scene in examples/*/scene.yaml; do
  name=$(basename "$(dirname "$scene")")
  build/bin/lrcs check "$scene"
  build/bin/lrcs sweep "$scene" -o "$work/$name"
  for file in sweep.csv manifest.json sweep.png polar.png facets-0.vtp facets-0.png; do
    [ -s "$work/$name/$file" ] || { echo "$scene: no $file" >&2; exit 1; }
  done
done
build/bin/lrcs fit examples/brdf/AnoBlackEC1onAlum.bsdf --model nine_parameter -o "$work/anoblack.yaml"
for file in anoblack.yaml anoblack.json anoblack.png anoblack-shadowing.png; do
  [ -s "$work/$file" ] || { echo "lrcs fit: no $file" >&2; exit 1; }
done
build/bin/lrcs brdf "$work/anoblack.yaml" >/dev/null
cmake --install build --prefix "$work/lrcs" >/dev/null
cmake -S examples/cpp -B "$work/cpp" -G Ninja -DCMAKE_PREFIX_PATH="$work/lrcs" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/cpp" >/dev/null
"$work/cpp/sphere"
