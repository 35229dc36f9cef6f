# SPDX-License-Identifier: BSD-3-Clause

# cmake --toolchain cmake/aarch64-linux-gnu.cmake -B build/aarch64    For 64-bit ARM with NEON, on a machine of another kind,
# with Debian's cross compiler (g++-aarch64-linux-gnu); tests run under qemu-user, where that is installed. The libraries
# are those of the machine, installed for arm64, or of the folder that SPHK_SYSROOT (-D or environment) names, which
#   mmdebstrap --variant=extract --architectures=arm64 --include=PACKAGES bookworm FOLDER
# fills (tests/setup/arm64.sh has the packages and makes its links relative). Another processor than ARMv8.0: add
# -DKokkos_ARCH_ARMV80=OFF -DKokkos_ARCH_ARMV84=ON (the names are Kokkos' own).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(Kokkos_ARCH_ARMV80 ON CACHE BOOL "CPU architecture")

# The environment takes it to the checks of the compiler and to the build of Kokkos, the cache to the next configuration.
if(SPHK_SYSROOT)
  set(ENV{SPHK_SYSROOT} "${SPHK_SYSROOT}")
endif()
set(SPHK_SYSROOT "$ENV{SPHK_SYSROOT}" CACHE PATH "Folder with the libraries for arm64")
set(sphk_loader /usr/aarch64-linux-gnu)
if(SPHK_SYSROOT)
  set(CMAKE_SYSROOT "${SPHK_SYSROOT}")
  set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(sphk_loader "${CMAKE_SYSROOT}")
endif()
find_program(SPHK_QEMU_AARCH64 NAMES qemu-aarch64 qemu-aarch64-static)
if(SPHK_QEMU_AARCH64)
  set(CMAKE_CROSSCOMPILING_EMULATOR "${SPHK_QEMU_AARCH64};-L;${sphk_loader}")
endif()
# The compiler wrapper h5cc that CMake asks is this machine's own and names its libraries.
set(HDF5_C_COMPILER_EXECUTABLE "" CACHE FILEPATH "Not asked")
set(HDF5_ROOT "${CMAKE_SYSROOT}/usr/lib/aarch64-linux-gnu/hdf5/serial" CACHE PATH "HDF5 for arm64")
