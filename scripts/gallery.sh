#!/bin/sh
# Draws every picture of docs/gallery.md from the shipped examples: gallery.sh [FOLDER] (default docs/pictures/gallery).
# Needs a finished build; chromium for the page of the report, which is left out without it.
set -eu
cd "$(dirname "$0")/.."
out=${1:-docs/pictures/gallery}
lrcs=build/bin/lrcs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
for name in as1 tess turbine propeller; do
  $lrcs sweep "examples/$name/scene.yaml" -o "$work/$name" -q
done
for name in tess turbine; do
  cp "$work/$name/sweep.png" "$out/$name-sweep.png"
  cp "$work/$name/polar.png" "$out/$name-polar.png"
  cp "$work/$name/facets-0.png" "$out/$name-facets.png"
done

$lrcs view "$work/as1" --aspect 7 --png "$out/view-contribution.png"
$lrcs view "$work/as1" --aspect 7 --colour seen --png "$out/view-seen.png"
$lrcs view "$work/as1" --aspect 7 --colour incidence --png "$out/view-incidence.png"
$lrcs view "$work/as1" --colour part --png "$out/view-part.png"
$lrcs view "$work/as1" --colour material --png "$out/view-material.png"
$lrcs view "$work/tess" --aspect 8 --scale linear --per facet --png "$out/view-linear.png"
$lrcs view "$work/turbine" --aspect 10 --png "$out/view-bistatic.png"

$lrcs plot "$work/tess" --elevation 20 -o "$out/plot-cut.png"
sed 's/^accuracy:.*//; s|file: tess.obj|file: '"$PWD"'/examples/tess/tess.obj|' examples/tess/scene.yaml >"$work/sampled.yaml"
echo 'accuracy: {relative: 1e-2}' >>"$work/sampled.yaml"
$lrcs sweep "$work/sampled.yaml" -o "$work/sampled" -q
$lrcs plot "$work/tess" "$work/sampled" --elevation 0 --label exact --label "sampled, 1e-2" -o "$out/plot-compared.png"
$lrcs plot "$work/as1" --kind parts -o "$out/plot-parts.png" -q
$lrcs sweep examples/propeller/propeller.stl --unit mm --material lambert:0.8 --azimuth 0:355:5 --elevation=-90:90:5 \
  -o "$work/sphere" -q
$lrcs plot "$work/sphere" --kind map -o "$out/plot-map.png"
$lrcs plot "$work/sphere" --kind sphere -o "$out/plot-sphere.png"

$lrcs brdf metal-skin-9p --with painted-steel-9p --theta-i 0,30,60 -o "$out/brdf.png" \
  --shadowing "$out/brdf-shadowing.png" --surface "$out/brdf-surface.png" \
  --surface-shadowing "$out/brdf-surface-shadowing.png" -q >/dev/null
$lrcs fit examples/brdf/AnoBlackEC1onAlum.bsdf --model nine_parameter -o "$work/fit.yaml" -q >/dev/null
cp "$work/fit.png" "$out/fit.png"
cp "$work/fit-shadowing.png" "$out/fit-shadowing.png"

$lrcs report "$work/as1" -o "$work/as1.html" -q
if command -v chromium >/dev/null; then
  chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic \
    --no-first-run --disable-background-networking --disable-component-update --disable-sync --hide-scrollbars \
    --user-data-dir="$work/browser" --window-size=760,1850 --force-device-scale-factor=2 --virtual-time-budget=20000 \
    --screenshot="$PWD/$out/report.png" "file://$work/as1.html" >/dev/null 2>&1
fi
