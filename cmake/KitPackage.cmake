# Files by which other build systems use the build tree or an installed prefix: the CMake package,
# the pkg-config file and the Makefile to include.
include(CMakePackageConfigHelpers)

set(OPENR_SHARE ${CMAKE_BINARY_DIR}/share/openr-host)
set(here ${PROJECT_SOURCE_DIR}/cmake)

configure_file(${here}/openr-hostConfig.cmake ${OPENR_SHARE}/cmake/openr-hostConfig.cmake COPYONLY)
configure_file(${here}/OpenrObject.cmake ${OPENR_SHARE}/cmake/OpenrObject.cmake COPYONLY)
configure_file(${here}/OpenrTesting.cmake ${OPENR_SHARE}/cmake/OpenrTesting.cmake COPYONLY)
configure_file(${here}/OpenrRemote.cmake ${OPENR_SHARE}/cmake/OpenrRemote.cmake COPYONLY)
write_basic_package_version_file(${OPENR_SHARE}/cmake/openr-hostConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
configure_file(${PROJECT_SOURCE_DIR}/kit/Makefile.openr-host
  ${OPENR_SHARE}/Makefile.openr-host COPYONLY)

# The flags for g++, on one line.
file(STRINGS ${here}/compile-flags.txt lines REGEX "^(all|c\\+\\+)(,gnu)?[ \t]")
list(TRANSFORM lines REPLACE "^[^ \t]+[ \t]+" "")
list(JOIN lines " " OPENR_PC_FLAGS)
configure_file(${here}/openr-host.pc.in ${CMAKE_BINARY_DIR}/share/pkgconfig/openr-host.pc @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${here}/compile-flags.txt)

install(DIRECTORY ${OPENR_SHARE}/cmake DESTINATION share/openr-host COMPONENT dev)
install(FILES ${OPENR_SHARE}/Makefile.openr-host DESTINATION share/openr-host COMPONENT dev)
install(FILES ${CMAKE_BINARY_DIR}/share/pkgconfig/openr-host.pc DESTINATION share/pkgconfig COMPONENT dev)
