# SPDX-License-Identifier: BSD-3-Clause

# sphk_kokkos_archive(out folder): an archive that holds the Kokkos source tree, in `folder`; `out` gets its path, and
# ${out}_SHA256 its hash. The roads are tried in the order of SPHK_KOKKOS_ROADS; a file whose hash differs is deleted.
# Script mode (cmake -P) may call it too, which is how the tests reach the roads one by one.

set(SPHK_KOKKOS_VERSION 4.7.0)
set(SPHK_KOKKOS_ROADS "installed;github;pypi" CACHE STRING "Where to look for Kokkos, in this order")

# The release as its authors publish it; the hash is that of Spack's recipe.
set(SPHK_KOKKOS_GITHUB_URL
    "https://github.com/kokkos/kokkos/releases/download/4.7.00/kokkos-4.7.00.tar.gz"
    CACHE STRING "Kokkos release archive")
set(SPHK_KOKKOS_GITHUB_SHA256 126b774a24dde8c1085c4aede7564c0b7492d6a07d85380f2b387a712cea1ff5
    CACHE STRING "Its SHA-256")

# The Python source distribution of pygenten carries the same tree under tpls/kokkos.
set(SPHK_KOKKOS_PYPI_PACKAGE pygenten==0.1.5 CACHE STRING "Python source distribution that carries Kokkos")
set(SPHK_KOKKOS_PYPI_SHA256 e620f05c742905e2db705d875f1cac92ef0ed453f9e6734e9beda26cc0f9cce7
    CACHE STRING "Its SHA-256")
set(SPHK_PIP "python3;-m;pip" CACHE STRING "The pip command")
mark_as_advanced(SPHK_KOKKOS_GITHUB_URL SPHK_KOKKOS_GITHUB_SHA256 SPHK_KOKKOS_PYPI_PACKAGE SPHK_KOKKOS_PYPI_SHA256
                 SPHK_PIP)

# Each road writes ${file} or sets ${why} to the reason why it could not.
function(sphk_kokkos_from_github file why)
  file(DOWNLOAD "${SPHK_KOKKOS_GITHUB_URL}" "${file}" STATUS status INACTIVITY_TIMEOUT 30)
  list(GET status 0 code)
  if(NOT code EQUAL 0)
    file(REMOVE "${file}")
    list(GET status 1 reason)
    set(${why} "${SPHK_KOKKOS_GITHUB_URL}: ${reason}" PARENT_SCOPE)
  endif()
endfunction()

function(sphk_kokkos_from_pypi file why)
  set(folder "${file}.pip")
  file(REMOVE_RECURSE "${folder}")
  string(REGEX REPLACE "=.*" "" name "${SPHK_KOKKOS_PYPI_PACKAGE}")
  execute_process(COMMAND ${SPHK_PIP} download --quiet --no-deps --no-binary ${name} --dest "${folder}"
                          ${SPHK_KOKKOS_PYPI_PACKAGE}
                  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  file(GLOB archive "${folder}/*.tar.gz")
  if(code EQUAL 0 AND archive)
    file(RENAME "${archive}" "${file}")
  else()
    string(STRIP "${output}" output)
    set(${why} "pip download ${SPHK_KOKKOS_PYPI_PACKAGE} failed (${code}): ${output}" PARENT_SCOPE)
  endif()
  file(REMOVE_RECURSE "${folder}")
endfunction()

# True when the file is there and has the hash; a file with another hash is deleted and `why` says so.
function(sphk_file_agrees agrees why file expected)
  set(${agrees} OFF PARENT_SCOPE)
  if(NOT EXISTS "${file}")
    return()
  endif()
  file(SHA256 "${file}" hash)
  if(hash STREQUAL expected)
    set(${agrees} ON PARENT_SCOPE)
  else()
    file(REMOVE "${file}")
    set(${why} "SHA-256 is ${hash}, expected ${expected}; the file was deleted" PARENT_SCOPE)
  endif()
endfunction()

function(sphk_kokkos_archive out folder)
  set(reasons "")
  list(JOIN SPHK_KOKKOS_ROADS ", " tried)
  foreach(road IN LISTS SPHK_KOKKOS_ROADS)
    if(NOT road MATCHES "^(github|pypi)$")
      continue()
    endif()
    string(TOUPPER "SPHK_KOKKOS_${road}_SHA256" expected)
    set(expected "${${expected}}")
    set(file "${folder}/kokkos-${SPHK_KOKKOS_VERSION}-${road}.tar.gz")
    set(why "")
    sphk_file_agrees(agrees ignored "${file}" ${expected})
    if(NOT agrees)
      message(STATUS "sphk: Kokkos from ${road}: downloading, up to a minute")
      cmake_language(CALL sphk_kokkos_from_${road} "${file}" why)
      sphk_file_agrees(agrees why "${file}" ${expected})
    endif()
    if(agrees)
      message(STATUS "sphk: Kokkos from ${road}: SHA-256 of ${file} agrees")
      set(${out} "${file}" PARENT_SCOPE)
      set(${out}_SHA256 ${expected} PARENT_SCOPE)
      return()
    endif()
    message(STATUS "sphk: Kokkos from ${road}: not to be had this way: ${why}")
    string(APPEND reasons "\n  ${road}: ${why}")
  endforeach()
  message(FATAL_ERROR
    "sphk: no road led to Kokkos ${SPHK_KOKKOS_VERSION} (tried: ${tried}).${reasons}\n"
    "Install Kokkos 4.7 and pass -DKokkos_ROOT=PREFIX, or unpack its source and pass -DSPHK_KOKKOS_SOURCE=FOLDER.")
endfunction()
