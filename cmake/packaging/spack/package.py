# SPDX-License-Identifier: BSD-3-Clause
"""sphk for Spack. From the root of a clone:

spack repo create mine && mkdir -p mine/packages/sphk && cp cmake/packaging/spack/package.py mine/packages/sphk
spack repo add mine && spack dev-build sphk@main
"""

from spack.package import *


class Sphk(CMakePackage, CudaPackage):
    """Smoothed-particle hydrodynamics for compressible gas on Kokkos: test problems with exact solutions, the schemes of
    three papers and GADGET-2's, as a command and as a C++ library."""

    license("BSD-3-Clause")

    version("main")  # of the folder that dev-build is called in

    variant("openmp", default=True, description="Threads by OpenMP; else serial")
    variant("tests", default=False, description="Build the tests")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.24:", type="build")
    depends_on("kokkos@4.7: +serial cxxstd=20")
    depends_on("kokkos +openmp", when="+openmp")
    depends_on("kokkos ~openmp", when="~openmp")
    depends_on("hdf5 ~mpi")
    depends_on("fmt")
    depends_on("cli11", type="build")
    depends_on("toml11", type="build")
    depends_on("nlohmann-json", type="build")
    depends_on("eigen@3.4:3", type="build")
    depends_on("googletest", type="build", when="+tests")
    depends_on("python", type=("build", "run"))
    depends_on("py-matplotlib", type="run")
    depends_on("py-h5py", type="run")

    for arch in CudaPackage.cuda_arch_values:
        depends_on(f"kokkos +cuda +wrapper cuda_arch={arch}", when=f"+cuda cuda_arch={arch}")
    conflicts("+cuda", when="cuda_arch=none", msg="sphk +cuda wants a cuda_arch")
    conflicts("%gcc@:11", msg="sphk is C++20 as g++ 12 knows it")

    def cmake_args(self):
        return [
            self.define("SPHK_KOKKOS_ROADS", "installed"),
            self.define("SPHK_BENCH", False),
            self.define_from_variant("SPHK_TESTS", "tests"),
            self.define_from_variant("Kokkos_ENABLE_OPENMP", "openmp"),
            self.define_from_variant("Kokkos_ENABLE_CUDA", "cuda"),
        ]
