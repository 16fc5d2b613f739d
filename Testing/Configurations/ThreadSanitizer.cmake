# The library and its tests, watched by ThreadSanitizer.
#
#     cmake -C Testing/Configurations/ThreadSanitizer.cmake -S . -B build-thread -G Ninja
#
# Distributions' TBB is not watched, so that what its tasks hand over looks like a race. VTK can take
# threads of the standard library, whose locks are seen: run with VTK_SMP_BACKEND_IN_USE=STDThread.

set(CMAKE_BUILD_TYPE "RelWithDebInfo" CACHE STRING "")
set(CMAKE_CXX_FLAGS "-fsanitize=thread -fno-omit-frame-pointer" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1" CACHE STRING "")
set(SMOOTHSHADOW_WRAP_PYTHON OFF CACHE BOOL "")
set(SMOOTHSHADOW_BUILD_EXAMPLES OFF CACHE BOOL "")
