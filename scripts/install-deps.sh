#!/bin/sh
# Installs what lrcs needs to be built, run and tested on Debian 12: install-deps.sh [--checks]
# --checks: also what .ci/run needs: for the style checks, to bundle the page of reports and drive it in a
# browser, to open sweep.h5 with xarray.
# As root or through sudo. Silent where nothing is missing.
set -eu
packages="g++ cmake ninja-build ccache
  libeigen3-dev libcgal-dev libopenmesh-dev libvtk9-dev libyaml-cpp-dev libtbb-dev libfmt-dev
  libcli11-dev libembree-dev libceres-dev libpagmo-dev libboost-dev libocct-data-exchange-dev libassimp-dev libzip-dev zlib1g-dev nlohmann-json3-dev libssl-dev libhdf5-dev libgmp-dev libmpfr-dev libgtest-dev libgmock-dev
  libfreetype-dev libfontconfig-dev fonts-droid-fallback xvfb libgl1-mesa-dri libxtst-dev"
for more in "$@"; do
  case $more in
    --checks)
      packages="$packages clang-format-14 clang-tidy-14 chromium python3-xarray python3-h5netcdf"
      # Those that are there may be newer than Debian's, and not be Debian's.
      command -v node >/dev/null && command -v npm >/dev/null || packages="$packages nodejs npm"
      ;;
    *) echo "install-deps.sh: expected --checks, found $more" >&2; exit 2 ;;
  esac
done

missing=
for p in $packages; do
  [ "$(dpkg-query -W -f='${Status}' "$p" 2>/dev/null)" = "install ok installed" ] || missing="$missing $p"
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null || { echo "install-deps.sh: run as root, or install sudo; missing:$missing" >&2; exit 1; }
  as_root="sudo -n"
  $as_root true 2>/dev/null || as_root=sudo
fi
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# shellcheck disable=SC2086  # a list of words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
