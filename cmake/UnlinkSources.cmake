# Rewrites links and pictures of installed documents.  A link to a file that only the sources have
# becomes its text, followed by the path of the file where the text does not name it.  So does a
# picture with its description.
#
#   SOURCES    folder of the sources
#   DOCUMENTS  folder of the installed documents, which have the same paths in the sources

# Sets `result` to what stands in place of `link`, a link or a picture with this label and target of
# a document in `folder`, a folder of the documents.
function(openr_linked result folder link label target)
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

# Sets `result` to `rest`, text of a document in `folder`, with its links and pictures rewritten.
# The label of a link may have pictures, [![description](picture)](target), and a target may have a
# title, [label](target "title").
function(openr_unlinked result folder rest)
  set(picture "!\\[[^][\n]*\\]\\([^()\n]*\\)")
  set(title "\"[^\"\n]*\"|'[^'\n]*'")
  set(text "")
  while(rest MATCHES "(!?)\\[(([^][\n]|${picture})*)\\]\\(([^() \n]+)( +(${title}))?\\)")
    set(link "${CMAKE_MATCH_0}")
    set(mark "${CMAKE_MATCH_1}")  # "!" of a picture
    set(label "${CMAKE_MATCH_2}")
    set(target "${CMAKE_MATCH_4}")
    set(after_target "${CMAKE_MATCH_5}")
    string(FIND "${rest}" "${link}" at)
    string(LENGTH "${link}" length)
    if(label MATCHES "${picture}")
      openr_unlinked(label "${folder}" "${label}")
    endif()
    openr_linked(link "${folder}" "${mark}[${label}](${target}${after_target})" "${label}" "${target}")
    string(SUBSTRING "${rest}" 0 ${at} before)
    math(EXPR after "${at} + ${length}")
    string(SUBSTRING "${rest}" ${after} -1 rest)
    string(APPEND text "${before}${link}")
  endwhile()
  set(${result} "${text}${rest}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE documents RELATIVE "${DOCUMENTS}" "${DOCUMENTS}/*.md")
foreach(document IN LISTS documents)
  if(EXISTS "${SOURCES}/${document}")
    cmake_path(GET document PARENT_PATH folder)
    file(READ "${SOURCES}/${document}" text)
    openr_unlinked(text "${folder}" "${text}")
    file(WRITE "${DOCUMENTS}/${document}" "${text}")
  endif()
endforeach()
