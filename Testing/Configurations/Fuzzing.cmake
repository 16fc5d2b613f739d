# Fuzz targets, with what they test watched by AddressSanitizer and UndefinedBehaviorSanitizer.
#
#     cmake -C Testing/Configurations/Fuzzing.cmake -S . -B build-fuzzing -G Ninja
#     cmake --build build-fuzzing --target FuzzMeshBridge FuzzVolume

set(CMAKE_CXX_COMPILER "clang++" CACHE STRING "")
set(CMAKE_BUILD_TYPE "RelWithDebInfo" CACHE STRING "")
# With assertions, the library's and the standard library's.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -D_GLIBCXX_ASSERTIONS" CACHE STRING "")
set(SMOOTHSHADOW_BUILD_FUZZERS ON CACHE BOOL "")
set(SMOOTHSHADOW_WRAP_PYTHON OFF CACHE BOOL "")
set(SMOOTHSHADOW_BUILD_EXAMPLES OFF CACHE BOOL "")
