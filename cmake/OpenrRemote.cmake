# openr::remote of an installation or a build tree, for clients of the remote control
# (docs/remote-control.md).
#
# Included by openr-hostConfig.cmake, which sets OPENR_HOST_PREFIX and OPENR_HOST_LIBRARIES.
find_package(fmt QUIET)
if(NOT fmt_FOUND)
  message(STATUS "openr-host: no openr::remote without the package libfmt-dev")
elseif(NOT EXISTS ${OPENR_HOST_LIBRARIES}/libopenr_remote.a)
  message(STATUS "openr-host: no openr::remote, since it is not built; build it with: "
    "cmake --build ${OPENR_HOST_PREFIX} --target openr_remote")
elseif(NOT TARGET openr::remote)
  add_library(openr::remote INTERFACE IMPORTED)
  target_include_directories(openr::remote INTERFACE
    ${OPENR_HOST_PREFIX}/share/openr-host/remote/include
    ${OPENR_HOST_PREFIX}/share/openr-host/remote/include/objects)
  target_compile_features(openr::remote INTERFACE cxx_std_20)
  target_link_libraries(openr::remote INTERFACE ${OPENR_HOST_LIBRARIES}/libopenr_remote.a
    ${OPENR_HOST_LIBRARIES}/libopenr_objects_common.a fmt::fmt)
endif()
