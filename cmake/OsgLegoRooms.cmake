# The library is divided into rooms: folders of osgLego/ that implement one idea each and are built as static libraries.
# A room may include its own headers, those of the rooms that it names here, and those of the rooms that these name. The
# target osgLegoIncludeOrder, which every build runs, fails if a source, a header or a shader includes anything else.

set_property(GLOBAL PROPERTY OSGLEGO_ROOMS "")

# osglego_add_room(NAME [PLAIN] [PUBLIC CLASS...] [USES ROOM...] [LINKS TARGET...])
#   PLAIN   the room includes few of OSG's headers: it needs the small precompiled header
#   PUBLIC  the classes of the room whose headers are public; their files are in osgLego/, all others in osgLego/NAME/
#   USES    the rooms whose headers it may include
#   LINKS   targets of other projects to link
function(osglego_add_room name)
    cmake_parse_arguments(PARSE_ARGV 1 ROOM "PLAIN" "" "PUBLIC;USES;LINKS")
    set(folder ${PROJECT_SOURCE_DIR}/osgLego)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/${name}/*.cpp)
    foreach(class IN LISTS ROOM_PUBLIC)
        if(EXISTS ${folder}/${class}.cpp)
            list(APPEND sources ${folder}/${class}.cpp)
        endif()
    endforeach()
    set(target osgLego_${name})
    if(sources)
        set(scope PUBLIC)
        add_library(${target} STATIC ${sources})
        target_link_libraries(${target} PRIVATE osgLegoOptions)
        osglego_inline_checks(${target})
        if(ROOM_PLAIN)
            osglego_precompile(${target} PLAIN)
        else()
            osglego_precompile(${target})
        endif()
    else()
        set(scope INTERFACE)
        add_library(${target} INTERFACE)
    endif()
    list(TRANSFORM ROOM_USES PREPEND osgLego_ OUTPUT_VARIABLE used)
    target_link_libraries(${target} ${scope} ${used} ${ROOM_LINKS} osgLego::OpenSceneGraph glm::glm)
    target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR})
    set_property(GLOBAL APPEND PROPERTY OSGLEGO_ROOMS ${name})
    set_property(GLOBAL PROPERTY OSGLEGO_ROOM_${name}_PUBLIC "${ROOM_PUBLIC}")
    set_property(GLOBAL PROPERTY OSGLEGO_ROOM_${name}_USES "${ROOM_USES}")
endfunction()

# Make every build check the includes of all rooms. Call it after the last room.
function(osglego_check_include_order)
    get_property(rooms GLOBAL PROPERTY OSGLEGO_ROOMS)
    set(rules "")
    foreach(room IN LISTS rooms)
        get_property(public GLOBAL PROPERTY OSGLEGO_ROOM_${room}_PUBLIC)
        get_property(uses GLOBAL PROPERTY OSGLEGO_ROOM_${room}_USES)
        string(APPEND rules "set(PUBLIC_${room} ${public})\nset(USES_${room} ${uses})\n")
    endforeach()
    set(file ${PROJECT_BINARY_DIR}/IncludeRules.cmake)
    file(CONFIGURE OUTPUT ${file} CONTENT "set(ROOMS @rooms@)\n@rules@" @ONLY)
    add_custom_target(osgLegoIncludeOrder ALL
        COMMAND ${CMAKE_COMMAND} -D RULES=${file} -D SOURCE=${PROJECT_SOURCE_DIR} -P
                ${PROJECT_SOURCE_DIR}/cmake/CheckIncludes.cmake
        COMMENT "Checking the order of includes" VERBATIM)
endfunction()
