# Precompiled headers, which halve the time of a build. Every source still includes all headers that it uses.
#
# GCC instantiates the templates that inline functions of a precompiled header use again in each source, which takes up to
# two seconds. Therefore there are two sets of headers: sources that don't draw use the first one. Programs and tests have
# precompiled headers of their own, which are compiled with -fPIE, like executables.

set(OSGLEGO_PLAIN_HEADERS
    <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <mutex> <optional> <set> <span> <string> <utility>
    <vector> <glm/glm.hpp> <osg/Notify> <osg/Referenced> <osg/ref_ptr>)
set(OSGLEGO_SCENE_HEADERS ${OSGLEGO_PLAIN_HEADERS}
    <osg/Camera> <osg/Drawable> <osg/GLExtensions> <osg/Geode> <osg/Geometry> <osg/Group> <osg/Program> <osg/State>
    <osg/StateSet> <osg/Texture2D> <osg/Uniform> <osgUtil/CullVisitor>)

# Add a target that only provides a precompiled header. osglego_add_precompiled(NAME TYPE HEADERS... [LINKS TARGET...])
function(osglego_add_precompiled name type)
    cmake_parse_arguments(PARSE_ARGV 2 PRECOMPILED "" "" "HEADERS;LINKS")
    set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
    if(type STREQUAL EXECUTABLE)
        file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n")
        add_executable(${name} ${source})
    else()
        file(CONFIGURE OUTPUT ${source} CONTENT "")
        add_library(${name} STATIC ${source})
    endif()
    target_link_libraries(${name} PRIVATE osgLegoOptions osgLego::OpenSceneGraph glm::glm ${PRECOMPILED_LINKS})
    target_precompile_headers(${name} PRIVATE ${PRECOMPILED_HEADERS})
endfunction()

osglego_add_precompiled(osgLegoPrecompiledPlain STATIC HEADERS ${OSGLEGO_PLAIN_HEADERS})
osglego_add_precompiled(osgLegoPrecompiledScene STATIC HEADERS ${OSGLEGO_SCENE_HEADERS})

# Make a library of the project use a precompiled header. osglego_precompile(TARGET [PLAIN])
function(osglego_precompile target)
    if("PLAIN" IN_LIST ARGN)
        target_precompile_headers(${target} REUSE_FROM osgLegoPrecompiledPlain)
    else()
        target_precompile_headers(${target} REUSE_FROM osgLegoPrecompiledScene)
    endif()
endfunction()

# Make a program, or objects that are linked only into programs, use the header that applications/ precompiles for them.
function(osglego_precompile_program target)
    osglego_compile_for_programs(${target})
    target_precompile_headers(${target} REUSE_FROM osgLegoPrecompiledProgram)
endfunction()
