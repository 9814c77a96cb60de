# Installing: where libraries go, what has to be built before, documents and examples.
#
# Every file belongs to a component, of which cmake/OpenrPackages.cmake makes a Debian package:
#   runtime  the program, its libraries, the default stick, the panel
#   dev      what builds and tests objects: SDK tree, tools, libraries, CMake package, headers
#   doc      documents and examples
#   python   the Python module, if this tree has it
include_guard()

# Folder of installed libraries; no library is for the linker's default folder.
set(OPENR_LIBRARIES lib/openr-host)
# Finds them from bin/.
set(OPENR_PROGRAM_RPATH "$ORIGIN/../${OPENR_LIBRARIES}")

# Parts of an installation that must have been built: files of the build folder.
set(OPENR_PARTS bin/openr bin/stubgen2 bin/openr-sdk lib/libopenr_runtime.so lib/libopenr_render.so
  lib/libopenr_controller.so lib/libopenr_remote.a lib/libopenr_objects_common.a stick/OPEN-R
  share/openr-host/sdk/compile-flags.txt share/openr-host/objects
  share/bash-completion/completions/openr share/man/man1/openr.1.gz)
if(OPENR_TESTING OR OPENR_TESTS)
  list(APPEND OPENR_PARTS lib/libopenr_testing.a)
endif()
if(OPENR_PANEL_SERVER)
  list(APPEND OPENR_PARTS lib/libopenr_panel.so)
endif()
if(TARGET panel_page)
  list(APPEND OPENR_PARTS panel/index.html)
endif()

# Builds what is missing, however little was built before.  First of all install rules: those that
# follow would only name a file that is not there.
install(CODE "
  function(openr_first_missing result)
    set(\${result} \"\" PARENT_SCOPE)
    foreach(part ${OPENR_PARTS})
      if(NOT EXISTS \"${CMAKE_BINARY_DIR}/\${part}\")
        set(\${result} \${part} PARENT_SCOPE)
        return()
      endif()
    endforeach()
  endfunction()
  openr_first_missing(missing)
  if(missing)
    message(STATUS \"Building what is installed: \${missing} is not built yet\")
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${CMAKE_BINARY_DIR}\" --target install_parts)
    openr_first_missing(missing)
  endif()
  if(missing)
    message(FATAL_ERROR \"\${missing} is not built yet, and building it failed; build everything that \"
      \"is installed with: cmake --build ${CMAKE_BINARY_DIR} --target install_parts\")
  endif()" ALL_COMPONENTS)

# Completion and manual pages, made by the program of its own description of its commands.
set(OPENR_PAGES ${CMAKE_BINARY_DIR}/share/man/man1)
set(OPENR_COMPLETION ${CMAKE_BINARY_DIR}/share/bash-completion/completions)
install(DIRECTORY ${OPENR_PAGES} DESTINATION share/man COMPONENT runtime FILES_MATCHING PATTERN "*.gz")
install(FILES ${OPENR_COMPLETION}/openr DESTINATION share/bash-completion/completions COMPONENT runtime)

# Documents and examples under the paths that they have in this tree, so that their links lead on.
# Links to files that are not installed become text.
set(OPENR_DOC share/doc/openr-host)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION ${OPENR_DOC} COMPONENT doc)
install(DIRECTORY docs examples DESTINATION ${OPENR_DOC} COMPONENT doc
  PATTERN "*.BIN" EXCLUDE PATTERN "*.DBG" EXCLUDE PATTERN "build" EXCLUDE
  PATTERN ".*" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(CODE "
  set(SOURCES \"${PROJECT_SOURCE_DIR}\")
  set(DOCUMENTS \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${OPENR_DOC}\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/UnlinkSources.cmake\")" COMPONENT doc)

# The licence, where Debian looks for that of a package.
set(OPENR_PACKAGE_runtime openr-host)
set(OPENR_PACKAGE_dev openr-host-dev)
set(OPENR_PACKAGE_doc openr-host-doc)
set(OPENR_PACKAGE_python python3-openr-host)
set(OPENR_COMPONENTS runtime dev doc)
if(EXISTS ${PROJECT_SOURCE_DIR}/python/openr_host)
  list(APPEND OPENR_COMPONENTS python)
endif()
foreach(component ${OPENR_COMPONENTS})
  install(FILES LICENSE RENAME copyright DESTINATION share/doc/${OPENR_PACKAGE_${component}}
    COMPONENT ${component})
endforeach()
