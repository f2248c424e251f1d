# Precompiled headers, which halve the time of a build: one for libraries, one for programs, and one for tests. The last
# two are compiled with -fPIE, like executables. Every source still includes all headers that it uses.

set(OSGLEGO_PRECOMPILED_HEADERS
    <algorithm> <array> <cmath> <functional> <map> <memory> <mutex> <string> <utility> <vector>
    <glm/glm.hpp> <osg/Camera> <osg/Drawable> <osg/GLExtensions> <osg/Geode> <osg/Geometry> <osg/Group> <osg/Notify>
    <osg/Program> <osg/State> <osg/StateSet> <osg/Texture2D> <osg/Uniform> <osgUtil/CullVisitor>)

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

osglego_add_precompiled(osgLegoPrecompiledLibrary STATIC HEADERS ${OSGLEGO_PRECOMPILED_HEADERS})

# Make a library of the project use the precompiled header.
function(osglego_precompile target)
    target_precompile_headers(${target} REUSE_FROM osgLegoPrecompiledLibrary)
endfunction()

# Make a program, or objects that are linked only into programs, use the header that applications/ precompiles for them.
function(osglego_precompile_program target)
    target_compile_options(${target} PRIVATE -fPIE)
    target_precompile_headers(${target} REUSE_FROM osgLegoPrecompiledProgram)
endfunction()
