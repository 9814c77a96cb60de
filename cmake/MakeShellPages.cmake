# Makes the manual pages and the completion of the program, by what it says of its own commands:
#   cmake -DOPENR=program -DGZIP=gzip -DCOMPLETION=file to write -DPAGES=folder to fill
#         -P MakeShellPages.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${PAGES}")
get_filename_component(folder "${COMPLETION}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}" "${PAGES}")
execute_process(COMMAND "${OPENR}" completion bash OUTPUT_FILE "${COMPLETION}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${OPENR}" man -o "${PAGES}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages "${PAGES}/*.1")
execute_process(COMMAND "${GZIP}" -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
