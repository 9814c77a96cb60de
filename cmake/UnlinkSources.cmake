# Rewrites links of installed documents.  A link to a file that only the sources have becomes its
# text, followed by the path of the file where the text does not name it.
#
#   SOURCES    folder of the sources
#   DOCUMENTS  folder of the installed documents, which have the same paths in the sources

# Sets `result` to what stands in place of the link [label](target) of a document in `folder`, a
# folder of the documents.
function(openr_linked result folder label target)
  set(link "[${label}](${target})")
  string(REGEX REPLACE "#.*" "" file "${target}")
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${SOURCES}/${folder}" NORMALIZE OUTPUT_VARIABLE source)
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${DOCUMENTS}/${folder}" NORMALIZE OUTPUT_VARIABLE installed)
  if(file STREQUAL "" OR NOT EXISTS "${source}" OR EXISTS "${installed}")
    set(${result} "${link}" PARENT_SCOPE)
    return()
  endif()
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${SOURCES}" OUTPUT_VARIABLE path)
  cmake_path(GET source FILENAME name)
  string(FIND "${label}" "${name}" at)
  if(at EQUAL -1)
    string(APPEND label " (${path} of the sources)")
  endif()
  set(${result} "${label}" PARENT_SCOPE)
endfunction()

function(openr_unlink document)
  cmake_path(GET document PARENT_PATH folder)
  file(READ "${SOURCES}/${document}" rest)
  set(text "")
  while(rest MATCHES "\\[([^][\n]*)\\]\\(([^() \n]+)\\)")
    set(whole "${CMAKE_MATCH_0}")
    openr_linked(link "${folder}" "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
    string(FIND "${rest}" "${whole}" at)
    string(SUBSTRING "${rest}" 0 ${at} before)
    string(LENGTH "${whole}" length)
    math(EXPR after "${at} + ${length}")
    string(SUBSTRING "${rest}" ${after} -1 rest)
    string(APPEND text "${before}${link}")
  endwhile()
  file(WRITE "${DOCUMENTS}/${document}" "${text}${rest}")
endfunction()

file(GLOB_RECURSE documents RELATIVE "${DOCUMENTS}" "${DOCUMENTS}/*.md")
foreach(document IN LISTS documents)
  if(EXISTS "${SOURCES}/${document}")
    openr_unlink("${document}")
  endif()
endforeach()
