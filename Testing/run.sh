#!/usr/bin/env bash
# Installs what is needed, builds everything and runs the tests; then the faster ones again, watched by
# sanitizers.
#
#     Testing/run.sh                      builds in build/, and in build-address/ and build-thread/
#     BUILD=/elsewhere Testing/run.sh
#     Testing/run.sh -R Silhouette        further arguments go to ctest; no sanitizers then
#     SANITIZERS=off Testing/run.sh       without them in any case
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build}

"$root/Testing/setup.sh"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$build" --parallel "$(nproc)"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
if [ "${SANITIZERS:-on}" = off ] || [ $# -gt 0 ]; then
  exit 0
fi

# sanitized NAME EXCEPT PROGRAM...: builds these test programs with Testing/Configurations/NAME.cmake
# and runs their tests, all but those that match EXCEPT.
sanitized()
{
  local name=$1 except=$2
  shift 2
  local folder
  folder=$build-$(tr '[:upper:]' '[:lower:]' <<<"${name%Sanitizer}")
  cmake -C "$root/Testing/Configurations/$name.cmake" -S "$root" -B "$folder" -G Ninja
  cmake --build "$folder" --parallel "$(nproc)" --target "$@"
  # A replay's tests bear the name of the fuzz target.
  local programs
  programs=$(IFS='|'; echo "${*#Replay}")
  ctest --test-dir "$folder" --output-on-failure --parallel "$(nproc)" --no-tests=error \
    -R "^($programs)\\." -E "$except"
}

filters=(TestSmoothLightSilhouette TestShadowVolumeExtruder TestFiniteVolumes TestSilhouetteSearch
  TestMeshDeviation TestVolumeNearEnd TestCastShadowContour TestShadowedReceiver)
slow='OnRealMeshes|OnRandomMeshes|WholeComponentsOnAnyMesh|RealMeshesOverReceivers|ThreeCasters'
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
export SMOOTHSHADOW_TEST_SCENES=100
sanitized AddressSanitizer "$slow" TestCore "${filters[@]}" TestRandomMeshes \
  TestContourScenes ReplayFuzzMeshBridge ReplayFuzzVolume TestShadowPassLights \
  TestShadowPassMasks TestShadowPassReuse TestShadowPlan TestVolumeUploads
# What runs on one thread has no races: of the core the caster alone is used by several. The ray
# cast's threads are the distribution's.
export VTK_SMP_BACKEND_IN_USE=STDThread
sanitized ThreadSanitizer \
  "$slow|HiddenContours|TestCore\\.[^C]|TestCore\\.C[^a]|IncompleteMethods" TestCore "${filters[@]}"
