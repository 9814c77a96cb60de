# openr::testing of an installation or a build tree, for tests of objects (docs/testing.md).
#
# Included by openr-hostConfig.cmake, which sets OPENR_HOST_PREFIX, _LIBRARIES and _SDK.  What is
# missing is said when somebody links the library; objects can be built without it.
include(CMakeFindDependencyMacro)

set(openr_missing)
find_package(GTest QUIET)
find_package(fmt QUIET)
find_package(Eigen3 QUIET NO_MODULE)
find_package(PNG QUIET)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(OPENR_ODE QUIET IMPORTED_TARGET ode)
  pkg_check_modules(OPENR_LIBDW QUIET IMPORTED_TARGET libdw)
endif()
foreach(pair GTest:libgtest-dev GTest:libgmock-dev fmt:libfmt-dev Eigen3:libeigen3-dev
             PNG:libpng-dev PkgConfig:pkg-config OPENR_ODE:libode-dev
             OPENR_LIBDW:libdw-dev)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 package)
  if(NOT ${name}_FOUND)
    list(APPEND openr_missing ${package})
  endif()
endforeach()

if(openr_missing)
  list(JOIN openr_missing " " openr_missing)
  message(STATUS "openr-host: no openr::testing without these packages: ${openr_missing}")
elseif(NOT TARGET openr::testing)
  add_library(openr::testing INTERFACE IMPORTED)
  target_include_directories(openr::testing INTERFACE
    ${OPENR_HOST_PREFIX}/share/openr-host/testing/include ${OPENR_HOST_SDK}/OPEN_R/include)
  # As the library was built: Eigen's vector code changes the layout of its types.
  target_compile_definitions(openr::testing INTERFACE EIGEN_DONT_VECTORIZE)
  target_compile_features(openr::testing INTERFACE cxx_std_20)
  set(openr_libraries testing program cli virtualrobot objects_common)
  list(TRANSFORM openr_libraries REPLACE "(.+)" "${OPENR_HOST_LIBRARIES}/libopenr_\\1.a")
  target_link_libraries(openr::testing INTERFACE
    ${openr_libraries} ${OPENR_HOST_LIBRARIES}/libopenr_runtime.so
    GTest::gtest GTest::gmock fmt::fmt Eigen3::Eigen PNG::PNG PkgConfig::OPENR_ODE
    PkgConfig::OPENR_LIBDW ${CMAKE_DL_LIBS})
endif()
