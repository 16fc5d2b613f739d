#!/usr/bin/env bash
# Installs the Debian packages that the build, the tests and the demo need, those of them that
# are missing. Called by Testing/run.sh and Examples/demo.sh; calling it again costs nothing.
#
# Without root it goes through sudo; without apt it names what is missing and stops.
set -euo pipefail

packages=(
  # build
  cmake g++ ninja-build
  # what the library is made of
  libvtk9-dev libglm-dev libopenmesh-dev libosmesa6-dev libegl-dev
  # what VTK's own package needs to be found and wrapped
  python3-vtk9 python3-dev
  # the EGL device and the software rasteriser
  libegl1 libegl-mesa0 libgl1-mesa-dri
  # the tool
  libcli11-dev nlohmann-json3-dev
  # the tests and their ray-cast oracle
  libgtest-dev libembree-dev
  # the fuzz targets
  clang libclang-rt-14-dev
  # real meshes: the bunny, and the CGAL collection
  glmark2-data libcgal-demo
)

missing=()
for package in "${packages[@]}"; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$'; then
    missing+=("$package")
  fi
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "setup: error: no apt-get here; install by hand what these Debian packages hold, then run again:" >&2
  printf '  %s\n' "${missing[@]}" >&2
  exit 1
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: error: neither root nor sudo; have these Debian packages installed, then run again:" >&2
    printf '  %s\n' "${missing[@]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
