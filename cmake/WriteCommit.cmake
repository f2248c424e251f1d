# Writes a header with the current commit of a folder, in every build, but changes the file only if the commit differs.
# Usage: cmake -D SOURCE=FOLDER -D OUTPUT=FILE -P WriteCommit.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git describe --always --dirty --tags WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n\n#define OSGLEGO_COMMIT \"@commit@\"\n" @ONLY)
