# SPDX-License-Identifier: BSD-3-Clause

# sphk_kokkos_patch(tree): two calls in Kokkos 4.7.0 take other arguments since CUDA 13 (CUDA Runtime API, release notes
# of 13.0): cudaGraphAddDependencies an edge-data pointer, cudaMemPrefetchAsync a location and a flag. Older CUDA keeps
# the original lines.

function(sphk_replace_line file old new)
  file(READ "${file}" text)
  string(FIND "${text}" "${old}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "sphk: ${file} lacks the line\n${old}\nthat CUDA 13 needs changed; is this Kokkos 4.7.0?")
  endif()
  string(REPLACE "${old}" "#if CUDART_VERSION >= 13000\n${new}\n#else\n${old}\n#endif" text "${text}")
  file(WRITE "${file}" "${text}")
endfunction()

function(sphk_kokkos_patch tree)
  set(file "${tree}/core/src/Cuda/Kokkos_Cuda_Instance.hpp")
  sphk_replace_line("${file}"
    "    return cudaGraphAddDependencies(graph, from, to, numDependencies);"
    "    return cudaGraphAddDependencies(graph, from, to, nullptr, numDependencies);")
  sphk_replace_line("${file}"
    "    return cudaMemPrefetchAsync(devPtr, count, dstDevice, m_stream);"
    "    const auto kind = dstDevice == cudaCpuDeviceId ? cudaMemLocationTypeHost : cudaMemLocationTypeDevice;
    return cudaMemPrefetchAsync(devPtr, count, cudaMemLocation{kind, dstDevice}, 0, m_stream);")
endfunction()
