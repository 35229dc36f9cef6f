# SPDX-License-Identifier: BSD-3-Clause

# cmake -C cmake/presets/thread.cmake -B build/thread    ThreadSanitizer, with clang: its OpenMP runtime (libomp-dev) loads
# libarcher, which says where threads wait for each other; gcc's says nothing, and every loop would pass for a race. Then
# export TSAN_OPTIONS="ignore_noninstrumented_modules=1 suppressions=$PWD/cmake/presets/thread.supp" OMP_NUM_THREADS=2
# and run the tests or sphk on as many idle cores: a thread that comes too late finds no work to race for.
set(CMAKE_C_COMPILER clang CACHE STRING "C compiler")
set(CMAKE_CXX_COMPILER clang++ CACHE STRING "C++ compiler")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "Build type")
set(CMAKE_CXX_FLAGS "-O1 -g1 -fsanitize=thread" CACHE STRING "Compiler options, for Kokkos as well")
set(CMAKE_CXX_FLAGS_DEBUG "" CACHE STRING "Compiler options of a debug build")
set(SPHK_SANITIZER thread CACHE STRING "Sanitizer of this build")
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
