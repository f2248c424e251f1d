# Settings that all targets of the project share: the language, the warnings, the folders of the build tree.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# Installed programs, libraries and plugins find the library by a relative path, so that the tree can be moved.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/..;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

find_program(OSGLEGO_CCACHE ccache)
if(OSGLEGO_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${OSGLEGO_CCACHE})
endif()

add_library(osgLegoOptions INTERFACE)
target_compile_options(osgLegoOptions INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
    -Wzero-as-null-pointer-constant
    # GCC 12 gives false warnings if its own std::string is in a precompiled header (bugs 105329 and 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow>
    # The first is part of Clang's -Wconversion, but not of GCC's; Clang 14 gives the second for defaulted operators <=>.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion -Wno-zero-as-null-pointer-constant>
    $<$<BOOL:${OSGLEGO_WARNINGS_AS_ERRORS}>:-Werror>)
if(OSGLEGO_SCALAR)
    target_compile_definitions(osgLegoOptions INTERFACE OSGLEGO_SCALAR)
endif()
if(OSGLEGO_SANITIZE STREQUAL "thread")
    target_compile_options(osgLegoOptions INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(osgLegoOptions INTERFACE -fsanitize=thread)
elseif(OSGLEGO_SANITIZE)
    target_compile_options(osgLegoOptions INTERFACE
        -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=undefined,float-cast-overflow
        -fno-omit-frame-pointer
        # GCC 12 gives false warnings for std::regex under -fsanitize=address (bug 105562).
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_compile_definitions(osgLegoOptions INTERFACE _GLIBCXX_ASSERTIONS)
    target_link_options(osgLegoOptions INTERFACE -fsanitize=address,undefined,float-cast-overflow)
endif()
if(OSGLEGO_BUILD_FUZZERS)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "OSGLEGO_BUILD_FUZZERS needs libFuzzer; expected Clang as the compiler")
    endif()
endif()

# Have the fuzzers count the branches that inputs reach in targets and single sources, and see the values that they are compared
# with. Other code needs no counters, which slow it and its compilation. The options of -fsanitize=fuzzer-no-link, but those that
# would need precompiled headers of their own.
function(osglego_count_branches)
    if(OSGLEGO_BUILD_FUZZERS)
        set(options -fsanitize-coverage=inline-8bit-counters,pc-table,indirect-calls,trace-cmp)
        foreach(name IN LISTS ARGN)
            if(TARGET ${name})
                target_compile_options(${name} PRIVATE ${options})
            elseif(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name})
                message(FATAL_ERROR "osglego_count_branches: '${name}' is neither a target nor a source")
            else()
                set_source_files_properties(${name} PROPERTIES COMPILE_OPTIONS "${options}")
            endif()
        endforeach()
    endif()
endfunction()
