# The library and its tests, watched by AddressSanitizer and UndefinedBehaviorSanitizer; what either
# finds ends the program.
#
#     cmake -C Testing/Configurations/AddressSanitizer.cmake -S . -B build-address -G Ninja
#
# VTK and drivers leak by themselves: run with ASAN_OPTIONS=detect_leaks=0.

set(CMAKE_BUILD_TYPE "RelWithDebInfo" CACHE STRING "")
set(CMAKE_CXX_FLAGS
  "-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer"
  CACHE STRING "")
# With assertions, the library's and the standard library's.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1 -D_GLIBCXX_ASSERTIONS" CACHE STRING "")
set(SMOOTHSHADOW_WRAP_PYTHON OFF CACHE BOOL "")
set(SMOOTHSHADOW_BUILD_EXAMPLES OFF CACHE BOOL "")
