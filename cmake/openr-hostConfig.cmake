# find_package(openr-host): openr_add_object() and openr_add_stick(), see OpenrObject.cmake beside;
# the libraries openr::remote and openr::testing.
#
# Works from an installed prefix and from a build tree alike: both hold share/openr-host.
get_filename_component(OPENR_HOST_PREFIX ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(OPENR_HOST_SDK ${OPENR_HOST_PREFIX}/share/openr-host/sdk)
# An installation has its libraries in a folder of their own.
set(OPENR_HOST_LIBRARIES ${OPENR_HOST_PREFIX}/lib)
if(EXISTS ${OPENR_HOST_PREFIX}/lib/openr-host)
  set(OPENR_HOST_LIBRARIES ${OPENR_HOST_PREFIX}/lib/openr-host)
endif()
set(OPENR_HOST_PROGRAM ${OPENR_HOST_PREFIX}/bin/openr)

set(OPENR_STUBGEN2 ${OPENR_HOST_PREFIX}/bin/stubgen2)
set(OPENR_SDK_TOOL ${OPENR_HOST_PREFIX}/bin/openr-sdk)
set(OPENR_HEADERS ${OPENR_HOST_SDK}/OPEN_R/include ${OPENR_HOST_SDK}/compat)
set(OPENR_HEADERS_KIND SYSTEM)
set(OPENR_STICK_IMAGES ${OPENR_HOST_SDK}/images)

# Lines of compile-flags.txt are "LANGUAGE[,COMPILER] FLAG".
set(OPENR_OBJECT_FLAGS)
file(STRINGS ${OPENR_HOST_SDK}/compile-flags.txt openr_lines REGEX "^[a-z]")
foreach(line ${openr_lines})
  string(REGEX MATCH "^([a-z+]+),?([a-z]*)[ \t]+([^ \t]+)" matched "${line}")
  set(language ${CMAKE_MATCH_1})
  set(compiler ${CMAKE_MATCH_2})
  set(flag ${CMAKE_MATCH_3})
  string(REPLACE "gnu" "GNU" compiler "${compiler}")
  string(REPLACE "clang" "Clang" compiler "${compiler}")
  set(languages CXX C)
  if(language STREQUAL "c++")
    set(languages CXX)
  elseif(language STREQUAL "c")
    set(languages C)
  endif()
  foreach(language ${languages})
    if(compiler)
      list(APPEND OPENR_OBJECT_FLAGS $<$<COMPILE_LANG_AND_ID:${language},${compiler}>:${flag}>)
    else()
      list(APPEND OPENR_OBJECT_FLAGS $<$<COMPILE_LANGUAGE:${language}>:${flag}>)
    endif()
  endforeach()
endforeach()

include(${CMAKE_CURRENT_LIST_DIR}/OpenrObject.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OpenrRemote.cmake)
if(EXISTS ${OPENR_HOST_LIBRARIES}/libopenr_testing.a)
  include(${CMAKE_CURRENT_LIST_DIR}/OpenrTesting.cmake)
elseif(EXISTS ${OPENR_HOST_PREFIX}/CMakeCache.txt)
  message(STATUS "openr-host: no openr::testing, since it is not built; build it with: "
    "cmake --build ${OPENR_HOST_PREFIX} --target openr_testing")
else()
  message(STATUS "openr-host: no openr::testing, since ${OPENR_HOST_PREFIX} was installed without; "
    "build openr-host with OPENR_TESTING=ON and install it again")
endif()
