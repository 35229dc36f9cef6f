# cmake -C cmake/presets/thread.cmake -B build/thread    ThreadSanitizer, with clang: its OpenMP runtime (libomp-dev) says
# through libarcher where threads wait for each other; gcc's says nothing, and every loop would pass for a race.
# TSAN_OPTIONS=ignore_noninstrumented_modules=1 OMP_TOOL_LIBRARIES=/usr/lib/llvm-14/lib/libarcher.so ctest --test-dir build/thread
set(CMAKE_C_COMPILER clang CACHE STRING "C compiler")
set(CMAKE_CXX_COMPILER clang++ CACHE STRING "C++ compiler")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "Build type")
set(CMAKE_CXX_FLAGS "-O1 -g1 -fsanitize=thread" CACHE STRING "Compiler options, for Kokkos as well")
set(CMAKE_CXX_FLAGS_DEBUG "" CACHE STRING "Compiler options of a debug build")
set(SPHK_SANITIZER thread CACHE STRING "Sanitizer of this build")
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
