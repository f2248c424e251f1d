# Everything that depends on the compiler, the linker or the system: no other file of CMake names their options, which
# tests/scripts/portability-test checks. osgLego is built and tested with GCC and Clang on Linux; the branches for other
# compilers and systems hold their known differences, and are untested.

if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR NOT CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang)$")
    message(WARNING "osgLego has not been tested with ${CMAKE_CXX_COMPILER_ID} on ${CMAKE_SYSTEM_NAME}; expected GCC or "
        "Clang on Linux")
endif()

# Installed programs, libraries and plugins find the library by a relative path, so that the tree can be moved.
if(APPLE)
    set(OSGLEGO_OWN_FOLDER "@loader_path")
else()
    set(OSGLEGO_OWN_FOLDER "$ORIGIN")
endif()
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
set(CMAKE_INSTALL_RPATH
    "${OSGLEGO_OWN_FOLDER};${OSGLEGO_OWN_FOLDER}/..;${OSGLEGO_OWN_FOLDER}/../${CMAKE_INSTALL_LIBDIR}")

add_library(osgLegoOptions INTERFACE)
if(MSVC)
    target_compile_options(osgLegoOptions INTERFACE
        /W4 /permissive- /utf-8 /bigobj /EHsc /Zc:__cplusplus /Zc:preprocessor $<$<BOOL:${OSGLEGO_WARNINGS_AS_ERRORS}>:/WX>)
    # The first keeps windows.h from defining min and max.
    target_compile_definitions(osgLegoOptions INTERFACE NOMINMAX _CRT_SECURE_NO_WARNINGS)
else()
    target_compile_options(osgLegoOptions INTERFACE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
        -Wzero-as-null-pointer-constant
        # GCC 12 gives false warnings if its own std::string is in a precompiled header (bugs 105329 and 105651).
        $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow>
        # The first is part of Clang's -Wconversion, but not of GCC's; Clang 14 gives the second for defaulted operators <=>.
        $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion -Wno-zero-as-null-pointer-constant>
        # Without times, Clang's precompiled headers are the same in each new clone, so that ccache finds what they compiled.
        $<$<CXX_COMPILER_ID:Clang,AppleClang>:SHELL:-Xclang -fno-pch-timestamp>
        $<$<BOOL:${OSGLEGO_WARNINGS_AS_ERRORS}>:-Werror>)
endif()
if(OSGLEGO_SCALAR)
    target_compile_definitions(osgLegoOptions INTERFACE OSGLEGO_SCALAR)
endif()
if(OSGLEGO_SANITIZE AND MSVC)
    message(FATAL_ERROR "OSGLEGO_SANITIZE needs the sanitizers of GCC or Clang; expected one of these compilers")
elseif(OSGLEGO_SANITIZE STREQUAL "thread")
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

# Have the optimizer inline the checks of sanitizers: with them, even operator[] exceeds Clang's default limit.
function(osglego_inline_checks target)
    if(OSGLEGO_SANITIZE AND NOT OSGLEGO_SANITIZE STREQUAL "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        target_compile_options(${target} PRIVATE "SHELL:-mllvm -inline-threshold=1000")
    endif()
endfunction()

# Compile objects that are linked only into programs like the precompiled headers of programs.
function(osglego_compile_for_programs)
    if(NOT MSVC)
        foreach(target IN LISTS ARGN)
            target_compile_options(${target} PRIVATE -fPIE)
        endforeach()
    endif()
endfunction()

# Tests run briefly: less optimization saves more time of compilation than it costs in the tests.
set(OSGLEGO_TEST_COMPILE_OPTIONS $<$<AND:$<NOT:$<BOOL:${MSVC}>>,$<CONFIG:Release,RelWithDebInfo>>:-O1>)

# Link OSMesa before all other libraries, even if a program calls none of its functions.
function(osglego_link_osmesa_first target)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux") # other linkers keep libraries of which nothing is called
        target_link_options(${target} INTERFACE -Wl,--push-state,--no-as-needed -lOSMesa -Wl,--pop-state)
    else()
        target_link_options(${target} INTERFACE -lOSMesa)
    endif()
endfunction()

# Link a program with libFuzzer, which has its main().
function(osglego_link_fuzzer target)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
endfunction()
