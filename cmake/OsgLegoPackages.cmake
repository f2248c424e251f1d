# Debian packages, which `cpack` makes of the components that are installed. The preset `package` gives folders and a library
# search as Debian expects them.
set(OSGLEGO_PACKAGE_CONTACT "osgLego developers <developers@osglego.invalid>" CACHE STRING
    "Who maintains the packages, with an address for e-mail")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME osglego)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # would be the first line of every description
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/AddDebianFiles.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/RemoveDebianScripts.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE osglego)
set(CPACK_DEBIAN_PACKAGE_RELEASE 0upstream1) # older than 1, which would be Debian's own
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${OSGLEGO_PACKAGE_CONTACT})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENTS_ALL "")

# osglego_add_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION [DEPENDS COMPONENT...]): a package of a component.
macro(osglego_add_package component name section summary description)
    cmake_parse_arguments(PACKAGE "" "" "DEPENDS" ${ARGN})
    string(TOUPPER ${component} upper)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}")
    set(CPACK_COMPONENT_${upper}_DEPENDS ${PACKAGE_DEPENDS})
endmacro()

# osglego_add_library_package(COMPONENT LIBRARY SUMMARY DESCRIPTION [DEPENDS COMPONENT...]): the same for a shared library. CPack's own
# list of shared libraries (GENERATE_SHLIBS) warns of every plugin, and lacks the trigger.
macro(osglego_add_library_package component library)
    string(TOLOWER ${library}${OSGLEGO_SOVERSION} name)
    osglego_add_package(${component} ${name} libs ${ARGN})
    set(control ${PROJECT_BINARY_DIR}/debian/${component})
    file(WRITE ${control}/shlibs "${library} ${OSGLEGO_SOVERSION} ${name} (>= ${PROJECT_VERSION})\n")
    file(WRITE ${control}/triggers "activate-noawait ldconfig\n")
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${control}/shlibs ${control}/triggers)
endmacro()

set(purpose "osgLego is a node kit for OpenSceneGraph that turns coloured meshes into
bricks, live, and into models of real parts that can be ordered and built.
.
This package contains")
osglego_add_library_package(library libosgLego
    "meshes in bricks for OpenSceneGraph, shared library" "${purpose} the library.")
if(TARGET osgLegoBooklet)
    osglego_add_library_package(booklet libosgLegoBooklet
        "building instructions of osgLego's models, shared library"
        "${purpose} the library that writes booklets." DEPENDS library)
    set(booklet booklet)
endif()
osglego_add_package(development libosglego-dev libdevel
    "meshes in bricks for OpenSceneGraph, development files"
    "${purpose} the headers, and the files for CMake and pkg-config."
    DEPENDS library ${booklet})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libglm-dev, libopenscenegraph-dev (>= 3.6)")
if(OSGLEGO_BUILD_PLUGINS)
    osglego_add_package(plugins openscenegraph-plugin-osglego libs
        "meshes in bricks for OpenSceneGraph, plugins"
        "${purpose} the pseudo-loader .legolize for osgviewer
and osgconv, and plugins for LDraw, glTF and other formats."
        DEPENDS library)
    set(CPACK_DEBIAN_PLUGINS_PACKAGE_ENHANCES openscenegraph)
    set(plugins plugins)
endif()
if(OSGLEGO_BUILD_APPLICATIONS)
    osglego_add_package(tools osglego-tools graphics
        "meshes in bricks for OpenSceneGraph, programs"
        "${purpose} osglegocapture, which draws bricks without a
display, chooses the best model of a mesh, and writes parts lists and
building instructions."
        DEPENDS library ${booklet} ${plugins})
    # Prints booklets to PDF.
    set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS chromium)
endif()
include(CPack)
