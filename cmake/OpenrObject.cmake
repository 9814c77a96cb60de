# openr_add_object: an OPEN-R object for the host.
#
#   openr_add_object(NAME JointMover            target and C++ class
#                    BIN  JOINTMOV.BIN          8.3 name of the image
#                    STUB stub.cfg/JointMover.cfg
#                    OCF  JointMover.ocf
#                    SOURCES a.cc b.cc
#                    [INCLUDES dir ...] [DEFINES X=1 ...] [LIBRARIES target ...])
#
# Runs the stub generator, compiles the sources as gnu++98 with hidden symbols and
# links a shared object that only shows the tables the loader looks for.  The image
# is stripped; its debug information lies beside it (NAME.DBG), where the loader of
# the run folder links it.
function(openr_add_object)
  cmake_parse_arguments(O "" "NAME;BIN;STUB;OCF" "SOURCES;INCLUDES;DEFINES;LIBRARIES" ${ARGN})
  foreach(required NAME BIN STUB OCF SOURCES)
    if(NOT O_${required})
      message(FATAL_ERROR "openr_add_object: ${required} is missing")
    endif()
  endforeach()
  get_filename_component(stub ${O_STUB} ABSOLUTE)
  get_filename_component(ocf ${O_OCF} ABSOLUTE)
  set(gen ${CMAKE_CURRENT_BINARY_DIR}/${O_NAME}.gen)
  file(MAKE_DIRECTORY ${gen})
  set(stub_files ${gen}/def.h ${gen}/entry.h ${gen}/${O_NAME}Stub.h ${gen}/${O_NAME}Stub.cc)
  add_custom_command(OUTPUT ${stub_files}
    COMMAND stubgen2 ${stub} -o ${gen}
    DEPENDS stubgen2 ${stub} VERBATIM
    COMMENT "Generating the stub of ${O_NAME}")
  # The text of the .ocf file travels in the image.
  add_custom_command(OUTPUT ${gen}/image_info.cc
    COMMAND ${CMAKE_COMMAND} -DOCF=${ocf} -DOUT=${gen}/image_info.cc
            -P ${PROJECT_SOURCE_DIR}/cmake/ImageInfo.cmake
    DEPENDS ${ocf} ${PROJECT_SOURCE_DIR}/cmake/ImageInfo.cmake VERBATIM)

  add_library(${O_NAME} MODULE ${O_SOURCES} ${stub_files} ${gen}/image_info.cc)  # image_info last
  string(REGEX REPLACE "\\.BIN$" "" base ${O_BIN})
  set_target_properties(${O_NAME} PROPERTIES
    PREFIX "" OUTPUT_NAME ${base} SUFFIX ".BIN"
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/images
    CXX_STANDARD 98 CXX_EXTENSIONS ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${O_NAME} PRIVATE ${gen} ${CMAKE_CURRENT_SOURCE_DIR} ${O_INCLUDES}
    ${PROJECT_SOURCE_DIR}/runtime/include)
  target_compile_definitions(${O_NAME} PRIVATE ${O_DEFINES})
  target_compile_options(${O_NAME} PRIVATE -Wall -Wextra -Werror -fno-strict-aliasing
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
  target_link_options(${O_NAME} PRIVATE -Wl,-Bsymbolic)
  target_link_libraries(${O_NAME} PRIVATE ${O_LIBRARIES})
  if(NOT OPENR_SANITIZE AND NOT OPENR_COVERAGE)
    add_custom_command(TARGET ${O_NAME} POST_BUILD
      COMMAND ${CMAKE_OBJCOPY} --only-keep-debug ${O_BIN} ${base}.DBG
      COMMAND ${CMAKE_OBJCOPY} --strip-debug --add-gnu-debuglink=${base}.DBG ${O_BIN}
      WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/images VERBATIM)
  endif()
endfunction()
