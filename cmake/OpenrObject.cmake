# openr_add_object: an OPEN-R object for the host.
#
#   openr_add_object(NAME JointMover            target
#                    STUB stub.cfg/JointMover.cfg
#                    OCF  JointMover.ocf
#                    SOURCES a.cc b.cc
#                    [BIN JOINTMOV.BIN]         8.3 name of the image; default: made of NAME
#                    [INCLUDES dir ...] [DEFINES X=1 ...] [LIBRARIES target ...])
#
# Without STUB the sources hold a stub written by hand (ObjectEntryTable).  Runs the stub generator,
# compiles the sources as old C++ with hidden symbols and links a shared object that only shows the
# tables the loader looks for.  The image lies in the folder images/ of the build; it is stripped,
# its debug information lies beside it (NAME.DBG), where the loader of the run folder links it.
#
#   openr_add_stick(NAME stick FOLDER MS OBJECTS helloWorld ... [OUTPUT dir])
#
# A target that copies the Memory Stick tree FOLDER and the images of OBJECTS to OUTPUT (default:
# NAME in the build folder), for: openr run --stick OUTPUT.  Images that come with openr-host
# (POWERMON.BIN) are there as well if OBJECT.CFG names them, unless FOLDER or OBJECTS bring others.
#
# Used in this tree and, by way of find_package(openr-host), in others.  Whoever includes this file
# sets: OPENR_STUBGEN2 and OPENR_SDK_TOOL (targets or programs), OPENR_HEADERS (folders),
# OPENR_OBJECT_FLAGS (compiler flags), OPENR_STICK_IMAGES (folder of images that come along).

# The class of a stub.cfg.
function(openr_class_of stub result)
  file(STRINGS ${stub} lines REGEX "^[ \t]*ObjectName[ \t]*:")
  string(REGEX REPLACE "^[ \t]*ObjectName[ \t]*:[ \t]*([A-Za-z0-9_]*).*$" "\\1" class "${lines}")
  set(${result} "${class}" PARENT_SCOPE)
endfunction()

function(openr_add_object)
  cmake_parse_arguments(O "" "NAME;BIN;STUB;OCF" "SOURCES;INCLUDES;DEFINES;LIBRARIES" ${ARGN})
  foreach(required NAME OCF SOURCES)
    if(NOT O_${required})
      message(FATAL_ERROR "openr_add_object: ${required} is missing")
    endif()
  endforeach()
  if(NOT O_BIN)
    string(SUBSTRING ${O_NAME} 0 8 O_BIN)
    string(TOUPPER ${O_BIN}.BIN O_BIN)
  endif()
  get_filename_component(ocf ${O_OCF} ABSOLUTE)
  set(gen ${CMAKE_CURRENT_BINARY_DIR}/${O_NAME}.gen)
  file(MAKE_DIRECTORY ${gen})
  set(stub_files)
  if(O_STUB)
    get_filename_component(stub ${O_STUB} ABSOLUTE)
    openr_class_of(${stub} class)
    set(stub_files ${gen}/def.h ${gen}/entry.h ${gen}/${class}Stub.h ${gen}/${class}Stub.cc)
    add_custom_command(OUTPUT ${stub_files}
      COMMAND ${OPENR_STUBGEN2} ${stub} -o ${gen}
      DEPENDS ${OPENR_STUBGEN2} ${stub} VERBATIM
      COMMENT "Generating the stub of ${O_NAME}")
  endif()
  # The text of the .ocf file travels in the image.
  add_custom_command(OUTPUT ${gen}/image_info.cc
    COMMAND ${OPENR_SDK_TOOL} image-info ${ocf} ${gen}/image_info.cc
    DEPENDS ${OPENR_SDK_TOOL} ${ocf} VERBATIM
    COMMENT "Describing ${O_NAME}")

  add_library(${O_NAME} MODULE ${O_SOURCES} ${stub_files} ${gen}/image_info.cc)  # image_info last
  string(REGEX REPLACE "\\.BIN$" "" base ${O_BIN})
  set_target_properties(${O_NAME} PROPERTIES
    PREFIX "" OUTPUT_NAME ${base} SUFFIX ".BIN"
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/images
    CXX_STANDARD 98 CXX_EXTENSIONS ON POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${O_NAME} PRIVATE ${gen} ${CMAKE_CURRENT_SOURCE_DIR} ${O_INCLUDES})
  target_include_directories(${O_NAME} ${OPENR_HEADERS_KIND} PRIVATE ${OPENR_HEADERS})
  target_compile_definitions(${O_NAME} PRIVATE ${O_DEFINES})
  target_compile_options(${O_NAME} PRIVATE ${OPENR_OBJECT_FLAGS})
  target_link_options(${O_NAME} PRIVATE -Wl,-Bsymbolic)
  target_link_libraries(${O_NAME} PRIVATE ${O_LIBRARIES})
  if(NOT OPENR_SANITIZE AND NOT OPENR_COVERAGE)
    add_custom_command(TARGET ${O_NAME} POST_BUILD
      COMMAND ${CMAKE_OBJCOPY} --only-keep-debug ${O_BIN} ${base}.DBG
      COMMAND ${CMAKE_OBJCOPY} --strip-debug --add-gnu-debuglink=${base}.DBG ${O_BIN}
      WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/images VERBATIM)
  endif()
endfunction()

function(openr_add_stick)
  cmake_parse_arguments(S "" "NAME;FOLDER;OUTPUT" "OBJECTS" ${ARGN})
  foreach(required NAME FOLDER OBJECTS)
    if(NOT S_${required})
      message(FATAL_ERROR "openr_add_stick: ${required} is missing")
    endif()
  endforeach()
  if(NOT S_OUTPUT)
    set(S_OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${S_NAME})
  endif()
  get_filename_component(folder ${S_FOLDER} ABSOLUTE)
  set(copy_images)
  set(copy_own)
  set(config ${folder}/OPEN-R/MW/CONF/OBJECT.CFG)
  set(names)  # paths on the robot, in capital letters because the robot ignores case
  if(EXISTS ${config})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${config})
    file(STRINGS ${config} names REGEX "^[ \t]*/")
    string(TOUPPER "${names}" names)
  endif()
  file(GLOB own_images ${OPENR_STICK_IMAGES}/*.BIN)
  foreach(image ${own_images})
    get_filename_component(name ${image} NAME)
    if(names MATCHES "/${name}[ \t\r]*(;|$)")
      # First, so that others take its place.
      list(APPEND copy_own COMMAND ${CMAKE_COMMAND} -E copy_if_different ${image}
        ${S_OUTPUT}/OPEN-R/MW/OBJS)
    endif()
  endforeach()
  foreach(object ${S_OBJECTS})
    list(APPEND copy_images COMMAND ${CMAKE_COMMAND} -E copy_if_different
      $<TARGET_FILE:${object}> $<TARGET_FILE_DIR:${object}>/$<TARGET_FILE_BASE_NAME:${object}>.DBG
      ${S_OUTPUT}/OPEN-R/MW/OBJS)
  endforeach()
  add_custom_target(${S_NAME} ALL
    COMMAND ${CMAKE_COMMAND} -E make_directory ${S_OUTPUT}/OPEN-R/MW/OBJS
            ${S_OUTPUT}/OPEN-R/MW/DATA/P
    ${copy_own}
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${folder} ${S_OUTPUT}
    ${copy_images}
    VERBATIM COMMENT "Assembling the Memory Stick ${S_NAME}")
  add_dependencies(${S_NAME} ${S_OBJECTS})
endfunction()
