# cmake -C cmake/presets/debug.cmake -B build/debug    AddressSanitizer, UndefinedBehaviorSanitizer and View bounds checks.
# -g1 gives a report its files and lines; the variables that -g adds for a debugger take 40 % of the compile time.
set(CMAKE_BUILD_TYPE Debug CACHE STRING "Build type")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all"
    CACHE STRING "Compiler options of a debug build")
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
set(Kokkos_ENABLE_DEBUG_BOUNDS_CHECK ON CACHE BOOL "Every View access is checked")
