#!/usr/bin/env bash
# Installs what is needed, builds the tool and draws the bunny, a coarse sphere and a coarse torus
# over a ground, lit by a point light, with each kind of shadow side by side; and the bunny as a
# sketch, of its outlines and the contours of its shadow. Ends with where the pictures are and what
# was measured. A second run reuses the build.
#
#     Examples/demo.sh                  builds in build/, writes to build/demo/
#     BUILD=/elsewhere Examples/demo.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build}
out=$build/demo
bunny=/usr/share/glmark2/models/bunny.obj
kinds=(none discrete accurate smooth)

"$root/Testing/setup.sh"
if [ ! -e "$build/CMakeCache.txt" ]; then
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
fi
cmake --build "$build" --parallel "$(nproc)" \
  --target smoothshadow ArchitecturalSketch CoarseShapes SideBySide

mkdir -p "$out"
"$build/bin/CoarseShapes" "$out/sphere.vtp" "$out/torus.vtp"

# A picture for each kind of shadow, and all of them in a strip.
draw() # mesh file, name
{
  local mesh=$1 name=$2 kind strip=()
  for kind in "${kinds[@]}"; do
    "$build/bin/smoothshadow" render "$mesh" --ground --kind "$kind" --size 480x480 \
      --supersample 2 --frames 3 -o "$out/$name-$kind.png" --json >"$out/$name-$kind.json"
    strip+=("$out/$name-$kind.png" "$kind")
  done
  "$build/bin/SideBySide" "$out/$name.png" "${strip[@]}"
}

# The time of a light move: silhouette and shadow volume anew, for the light of the picture.
move_light() # mesh file, name
{
  local mesh=$1 name=$2 kind light
  light=$(/usr/bin/python3 -c 'import json, sys
print(*json.load(open(sys.argv[1]))["lights"][0]["position"], sep=",")' "$out/$name-smooth.json")
  for kind in "${kinds[@]:1}"; do
    "$build/bin/smoothshadow" volume "$mesh" --light "$light" --kind "$kind" --repeat 9 \
      -o "$out/$name-$kind.vtp" --json >"$out/$name-$kind-volume.json"
  done
}

echo
echo "measuring ..."
for name in bunny sphere torus; do
  mesh=$out/$name.vtp
  if [ "$name" = bunny ]; then
    mesh=$bunny
  fi
  draw "$mesh" "$name"
  move_light "$mesh" "$name"
done

/usr/bin/python3 - "$out" <<'TABLE'
import json
import os
import sys

folder = sys.argv[1]
row = "{:8} {:>9}  {:9} {:>14} {:>10} {:>16}"
print(row.format("mesh", "triangles", "shadow", "light move ms", "frame ms", "shadowed pixels"))
for name in ("bunny", "sphere", "torus"):
    for kind in ("none", "discrete", "accurate", "smooth"):
        base = os.path.join(folder, f"{name}-{kind}")
        picture = json.load(open(base + ".json"))
        move = "-"
        if kind != "none":
            move = "{:.1f}".format(json.load(open(base + "-volume.json"))["milliseconds"])
        print(row.format(name, picture["meshes"][0]["triangles"], kind, move,
                         "{:.0f}".format(picture["frameMilliseconds"]),
                         "{:.0f}".format(picture["lights"][0]["shadowedPixels"])))
drawn = picture["width"] * picture["supersample"], picture["height"] * picture["supersample"]
print(f"\nlight move: silhouette and shadow volume anew, median of 9; frame: {drawn[0]} x {drawn[1]} "
      f"pixels, median of 3,\nlight and camera at rest; drawn by {picture['renderer']}; "
      f"shadowed pixels of the 480 x 480 picture")
TABLE

"$build/bin/ArchitecturalSketch" "$out/sketch.png" "$out/sketch.svg" "$bunny" >/dev/null

echo
echo "pictures:"
for name in bunny sphere torus; do
  echo "  $out/$name.png"
done
echo "the bunny on a chair, drawn with cast contours:"
echo "  $out/sketch.png"
echo "  $out/sketch.svg   (layers, for Inkscape)"
echo "shadow volumes, for ParaView: $out/*.vtp; all figures: $out/*.json"
