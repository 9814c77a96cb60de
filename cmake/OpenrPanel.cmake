# The web panel: what builds its server (openr/panel) and its page (panel/).
#
# Each part is left out where what it needs is missing; all else is built and works.
option(OPENR_PANEL "Build the web panel: its server needs libwebsockets, its page node and npm" ON)

find_package(PkgConfig REQUIRED)
set(OPENR_PANEL_SERVER OFF)
if(OPENR_PANEL)
  pkg_check_modules(LIBWEBSOCKETS IMPORTED_TARGET libwebsockets)
  if(LIBWEBSOCKETS_FOUND)
    set(OPENR_PANEL_SERVER ON)
  else()
    message(STATUS "No panel: libwebsockets is missing (Debian package libwebsockets-dev); all else works")
  endif()
endif()

set(OPENR_PANEL_SOURCES ${PROJECT_SOURCE_DIR}/panel)
if(NOT OPENR_PANEL OR NOT EXISTS ${OPENR_PANEL_SOURCES}/package.json)
  return()
endif()
find_program(OPENR_NODE NAMES node nodejs)
find_program(OPENR_NPM npm)
if(NOT OPENR_NODE OR NOT OPENR_NPM)
  message(STATUS "No page of the panel: node or npm is missing (Debian packages nodejs and npm); all else works")
  return()
endif()

# The packages of the page lie beside its sources, for editors and for all build folders.
set(stamp ${OPENR_PANEL_SOURCES}/node_modules/.openr-installed)
add_custom_command(
  OUTPUT ${stamp}
  COMMAND ${CMAKE_COMMAND} -DNPM=${OPENR_NPM} -DSTAMP=${stamp}
          -P ${PROJECT_SOURCE_DIR}/cmake/install_page_packages.cmake
  DEPENDS ${OPENR_PANEL_SOURCES}/package-lock.json
  WORKING_DIRECTORY ${OPENR_PANEL_SOURCES}
  COMMENT "Installing the packages of the panel's page (npm ci)"
  VERBATIM)

file(GLOB_RECURSE OPENR_PAGE_FILES CONFIGURE_DEPENDS
  ${OPENR_PANEL_SOURCES}/src/* ${OPENR_PANEL_SOURCES}/public/*)
file(GLOB OPENR_PAGE_SETTINGS CONFIGURE_DEPENDS
  ${OPENR_PANEL_SOURCES}/*.html ${OPENR_PANEL_SOURCES}/*.ts ${OPENR_PANEL_SOURCES}/*.json
  ${OPENR_PANEL_SOURCES}/*.js ${OPENR_PANEL_SOURCES}/*.mjs)
set(page ${CMAKE_BINARY_DIR}/panel/index.html)
add_custom_command(
  OUTPUT ${page}
  COMMAND ${OPENR_NPM} run --silent build -- --outDir ${CMAKE_BINARY_DIR}/panel --emptyOutDir
  COMMAND ${CMAKE_COMMAND} -E touch ${page}
  DEPENDS ${stamp} ${OPENR_PAGE_FILES} ${OPENR_PAGE_SETTINGS}
  WORKING_DIRECTORY ${OPENR_PANEL_SOURCES}
  COMMENT "Building the panel's page"
  VERBATIM)
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(panel_page ALL DEPENDS ${page})
else()
  add_custom_target(panel_page DEPENDS ${page})
endif()
