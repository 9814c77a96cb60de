# Copies the sources that `openr stick robot` compiles (kit/robot_stick.h) into one folder:
#   cmake -DTO=folder to fill -DSOURCE=this source tree -DGENERATED=folder of RobotConstants
#         -P CopyRobotSources.cmake
cmake_minimum_required(VERSION 3.25)
set(COPIED)
function(copy_files from to)
  foreach(pattern ${ARGN})
    file(GLOB_RECURSE files RELATIVE ${from} ${from}/${pattern})
    foreach(file ${files})
      get_filename_component(folder ${to}/${file} DIRECTORY)
      file(MAKE_DIRECTORY ${folder})
      file(COPY_FILE ${from}/${file} ${to}/${file} ONLY_IF_DIFFERENT)
      list(APPEND COPIED ${to}/${file})
    endforeach()
  endforeach()
  set(COPIED ${COPIED} PARENT_SCOPE)
endfunction()

copy_files(${SOURCE}/objects ${TO} *.cc *.c *.h *.ocf)
copy_files(${GENERATED} ${TO}/common RobotConstants.cc RobotConstants.h)
copy_files(${SOURCE}/stub.cfg ${TO}/stub.cfg *.cfg *.CFG *.TXT)

# A source that is gone from the tree would still be compiled.
file(GLOB_RECURSE there ${TO}/*)
foreach(file ${there})
  if(NOT file IN_LIST COPIED)
    file(REMOVE ${file})
  endif()
endforeach()
