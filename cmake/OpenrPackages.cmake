# Debian packages, one for each component (OpenrInstall.cmake): `cpack` in the build folder, or
# tools/packages.sh, which tests them as well.
include_guard()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME openr-host)
set(CPACK_PACKAGE_VENDOR "openr-host")
set(CPACK_PACKAGE_CONTACT "The openr-host authors <maintainers@openr-host.invalid>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Runs software of Sony's AIBO ERS-210 on a PC")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL ${OPENR_COMPONENTS})
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# gzip packs several times as fast as xz.
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${OPENR_PACKAGE_runtime})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# The program loads these libraries when it first needs them (runtime/base/lazy_library.h), which
# dpkg-shlibdeps does not see.
set(late_packages)
foreach(library ddsc edit sndfile)
  find_library(OPENR_LATE_${library} ${library})
  file(REAL_PATH ${OPENR_LATE_${library}} late_file)
  execute_process(COMMAND dpkg-query --search ${late_file} OUTPUT_VARIABLE late_owner ERROR_QUIET)
  string(REGEX REPLACE ":.*" "" late_package "${late_owner}")
  list(APPEND late_packages ${late_package})
endforeach()
list(JOIN late_packages ", " CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS openr-host-dev)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "openr-host-doc, gdb, graphviz")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "The runtime for OPEN-R objects, the simulated robots, the default stick and the web panel.")

# Without what compiles an object there is nothing to develop; tests of objects are an extra.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME ${OPENR_PACKAGE_dev})
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "g++, binutils, make")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "cmake, pkg-config, libgtest-dev, libgmock-dev, libfmt-dev, \
libeigen3-dev, libpng-dev, libode-dev, libdw-dev")
set(CPACK_COMPONENT_DEV_DEPENDS runtime)
set(CPACK_COMPONENT_DEV_DESCRIPTION
  "Builds, checks and tests OPEN-R objects: headers, tools, libraries, the CMake package.
The recommended packages are those that openr::testing and openr::remote need.")

set(CPACK_DEBIAN_DOC_PACKAGE_NAME ${OPENR_PACKAGE_doc})
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_COMPONENT_DOC_DESCRIPTION "Documents and examples, in /usr/share/doc/openr-host.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME ${OPENR_PACKAGE_python})
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11)")
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module openr_host.")

include(CPack)
