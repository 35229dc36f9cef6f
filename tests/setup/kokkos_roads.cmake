# SPDX-License-Identifier: BSD-3-Clause

# cmake -DSOURCE=... -DWORK=... -P kokkos_roads.cmake
# The roads to Kokkos with a tiny archive: file:// stands for the release page, a stand-in for pip copies the archive.
cmake_minimum_required(VERSION 3.24)

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/tree/core/src")
file(WRITE "${WORK}/tree/core/src/Kokkos_Core.hpp" "")
file(ARCHIVE_CREATE OUTPUT "${WORK}/good.tar.gz" PATHS "${WORK}/tree" FORMAT gnutar COMPRESSION GZip)
file(SHA256 "${WORK}/good.tar.gz" good)
string(REPEAT 0 64 bad)
file(WRITE "${WORK}/pip.cmake" "
math(EXPR last \"\${CMAKE_ARGC} - 2\")
set(folder \"\${CMAKE_ARGV\${last}}\")
file(COPY \"${WORK}/good.tar.gz\" DESTINATION \"\${folder}\")
")
file(WRITE "${WORK}/no_pip.cmake" "message(FATAL_ERROR \"no network\")")

# expect(NAME ...): the roads with these settings, in a process of their own; SAYS lists what the log has to contain.
function(expect name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FAILS" "URL;GITHUB_SHA256;PYPI_SHA256;PIP;KEPT" "SAYS")
  set(cache "${WORK}/${name}")
  file(MAKE_DIRECTORY "${cache}")
  if(arg_KEPT)
    file(WRITE "${cache}/kokkos-4.7.0-github.tar.gz" "${arg_KEPT}")
  endif()
  file(WRITE "${WORK}/${name}.cmake" "
cmake_minimum_required(VERSION 3.24)
set(SPHK_KOKKOS_GITHUB_URL \"${arg_URL}\")
set(SPHK_KOKKOS_GITHUB_SHA256 ${arg_GITHUB_SHA256})
set(SPHK_KOKKOS_PYPI_SHA256 ${arg_PYPI_SHA256})
set(SPHK_PIP \"${CMAKE_COMMAND};-P;${WORK}/${arg_PIP}\")
include(\"${SOURCE}/cmake/sphk_kokkos_archive.cmake\")
sphk_kokkos_archive(archive \"${cache}\")
file(SHA256 \"\${archive}\" hash)
message(STATUS \"archive \${hash} \${archive_SHA256}\")
")
  execute_process(COMMAND "${CMAKE_COMMAND}" -P "${WORK}/${name}.cmake"
                  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  set(says "${arg_SAYS}")
  if(arg_FAILS)
    list(APPEND says "no road led to Kokkos 4.7.0" "-DSPHK_KOKKOS_SOURCE=FOLDER")
  else()
    list(APPEND says "archive ${good} ${good}")
  endif()
  if((arg_FAILS AND code EQUAL 0) OR (NOT arg_FAILS AND NOT code EQUAL 0))
    message(SEND_ERROR "${name}: unexpected exit code ${code}\n${output}")
  endif()
  foreach(sentence IN LISTS says)
    string(FIND "${output}" "${sentence}" position)
    if(position EQUAL -1)
      message(SEND_ERROR "${name}: does not say '${sentence}' but\n${output}")
    endif()
  endforeach()
endfunction()

set(unresolved "https://kokkos.invalid/kokkos.tar.gz")  # RFC 2606: .invalid never resolves
set(local "file://${WORK}/good.tar.gz")

expect(release_page URL "${local}" GITHUB_SHA256 ${good} PYPI_SHA256 ${bad} PIP no_pip.cmake
       SAYS "Kokkos from github: SHA-256 of")
expect(name_does_not_resolve URL "${unresolved}" GITHUB_SHA256 ${good} PYPI_SHA256 ${good} PIP pip.cmake
       SAYS "Kokkos from github: not to be had this way: ${unresolved}" "Kokkos from pypi: SHA-256 of")
expect(wrong_hash URL "${local}" GITHUB_SHA256 ${bad} PYPI_SHA256 ${good} PIP pip.cmake
       SAYS "SHA-256 is ${good}, expected ${bad}; the file was deleted" "Kokkos from pypi: SHA-256 of")
expect(damaged_download_is_fetched_again URL "${local}" GITHUB_SHA256 ${good} PYPI_SHA256 ${bad} PIP no_pip.cmake
       KEPT "damaged" SAYS "Kokkos from github: downloading" "Kokkos from github: SHA-256 of")
expect(no_road FAILS URL "${unresolved}" GITHUB_SHA256 ${good} PYPI_SHA256 ${good} PIP no_pip.cmake
       SAYS "github: ${unresolved}" "pip download pygenten==0.1.5 failed" "no network")
expect(wrong_hash_everywhere FAILS URL "${local}" GITHUB_SHA256 ${bad} PYPI_SHA256 ${bad} PIP pip.cmake
       SAYS "Kokkos from pypi: not to be had this way: SHA-256 is ${good}, expected ${bad}")

# A built Kokkos is used again only when its recipe, the hash included, is the one asked for.
list(APPEND CMAKE_MODULE_PATH "${SOURCE}/cmake")
set(SPHK_CACHE "${WORK}/builds")
include(sphk_kokkos_archive)
include(sphk_kokkos_build)
sphk_kokkos_folder(folder ready "recipe ${good}")
if(ready)
  message(SEND_ERROR "a folder that does not exist passed for a built Kokkos")
endif()
file(WRITE "${folder}/recipe.txt" "recipe ${good}")
sphk_kokkos_folder(folder ready "recipe ${good}")
if(NOT ready)
  message(SEND_ERROR "a built Kokkos whose recipe agrees was not used")
endif()
file(WRITE "${folder}/recipe.txt" "recipe ${bad}")
sphk_kokkos_folder(folder ready "recipe ${good}")
if(ready)
  message(SEND_ERROR "a built Kokkos with another hash was used")
endif()
