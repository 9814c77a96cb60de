# Language level and flags that hold for everything in the tree.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# A changed function of a shared library needs no new program.
set(CMAKE_LINK_DEPENDS_NO_SHARED ON)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo)
endif()
# Line numbers; what a debugger needs beyond them takes a quarter of the compiler's time.  A preset
# with other flags sets OPENR_OPTIMISATION: CMAKE_CXX_FLAGS_RELWITHDEBINFO of a preset has no effect.
set(OPENR_OPTIMISATION "-O2 -g1" CACHE STRING "Flags for optimisation and debug information")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "${OPENR_OPTIMISATION}")  # assertions are ours and stay on

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# g++ collects garbage again and again once its heap has 128 MB.  Without that, batches need a sixth
# more memory and compile in nine tenths of the time.
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=4000000>)

# Bits must not depend on the compiler's taste for fused multiply-add.
add_compile_options(-ffp-contract=off)

if(OPENR_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  # g++ 12 sees uninitialised members in the C++ library's <regex> when sanitizers change the flow.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # The name by which our sources know AddressSanitizer; g++ defines it, clang does not.
  add_compile_definitions($<$<CXX_COMPILER_ID:Clang>:__SANITIZE_ADDRESS__=1>)
  add_link_options(-fsanitize=address,undefined)
endif()
if(OPENR_SANITIZE_THREADS)
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  # The name by which our sources know ThreadSanitizer; g++ defines it, clang does not.
  add_compile_definitions($<$<CXX_COMPILER_ID:Clang>:__SANITIZE_THREAD__=1>)
  add_link_options(-fsanitize=thread)
endif()
if(OPENR_FUZZ)
  # Counters of branches, by which libFuzzer sees how far an input has come.
  add_compile_options(-fsanitize=fuzzer-no-link)
  # Two checks that take a fifth of the compiler's time.  AddressSanitizer sees what object-size would
  # see, and an unaligned word is an error on the robot only, so the robot's code keeps the other one.
  # The preset asan has both.
  add_compile_options(-fno-sanitize=object-size,alignment)
  add_compile_options(-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/clang-unchecked.txt
    -fsanitize-coverage-ignorelist=${PROJECT_SOURCE_DIR}/cmake/clang-uncounted.txt
    -Wno-unused-command-line-argument)  # the tests have no counters
  # Neither ninja nor ccache reads these lists, so each object has their hash in its command.
  set(lists ${PROJECT_SOURCE_DIR}/cmake/clang-unchecked.txt ${PROJECT_SOURCE_DIR}/cmake/clang-uncounted.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lists})
  set(hashes)
  foreach(list IN LISTS lists)
    file(SHA256 ${list} hash)
    string(SUBSTRING ${hash} 0 8 hash)
    string(APPEND hashes ${hash})
  endforeach()
  add_compile_definitions(OPENR_CLANG_LISTS=0x${hashes})
endif()
if(OPENR_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

# For code that runs once for a command, a request or a build: compiles in three quarters of the time.
# Only where the level is the default one; presets with another level mean all code.
if(OPENR_OPTIMISATION STREQUAL "-O2 -g1")
  set(OPENR_RARELY_RUN $<$<CONFIG:RelWithDebInfo>:-Og>)
endif()

# Warnings for our own C++20; objects/ has its own list in OpenrObject.cmake.
set(OPENR_WARNINGS -Wall -Wextra -Werror $<$<COMPILE_LANGUAGE:CXX>:-Wsuggest-override>)

# Variables that openr_add_object() reads (OpenrObject.cmake).
set(OPENR_STUBGEN2 stubgen2)
set(OPENR_SDK_TOOL openr_sdk)
set(OPENR_HEADERS ${PROJECT_SOURCE_DIR}/runtime/include)
set(OPENR_OBJECT_FLAGS -g -Wall -Wextra -Werror -fno-strict-aliasing -ftrivial-auto-var-init=zero
  # clang's UBSan ends the process where a robot goes on with a number it does not have; the runtime
  # reports these conversions itself.
  $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=float-cast-overflow>
  $<$<BOOL:${OPENR_FUZZ}>:-fsanitize=alignment>
  # Objects have no threads.
  $<$<BOOL:${OPENR_SANITIZE_THREADS}>:-fno-sanitize=thread>
  $<$<CXX_COMPILER_ID:Clang>:-enable-trivial-auto-var-init-zero-knowing-it-will-be-removed-from-clang>
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)

# Most of a compiler's work is what the sources include: for these targets it reads several
# sources at a time.  Large batches build faster from nothing, small ones after an edit.
option(OPENR_BATCHES "Compile several sources at a time" ON)
set(OPENR_BATCH_SIZE 24 CACHE STRING "The sources that are compiled at a time")
set(OPENR_ALONE "" CACHE STRING "Sources that are compiled alone: names in the source folder")
list(TRANSFORM OPENR_ALONE PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE OPENR_ALONE_PATHS)
function(openr_in_batches)
  set_source_files_properties(${OPENR_ALONE_PATHS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${OPENR_BATCHES}
    UNITY_BUILD_BATCH_SIZE ${OPENR_BATCH_SIZE})
endfunction()
