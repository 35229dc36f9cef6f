# Where Kokkos comes from.

find_package(Kokkos 4.7 REQUIRED)
