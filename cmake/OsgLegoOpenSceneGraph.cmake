# Targets for OpenSceneGraph, whose own find module only sets variables: osgLego::OpenSceneGraph for the library, and
# osgLego::OpenSceneGraphViewer for programs with a viewer. Used by both the build and the installed package.
find_package(OpenSceneGraph 3.6 QUIET COMPONENTS osgViewer osgGA osgDB osgUtil)

if(OPENSCENEGRAPH_FOUND AND NOT TARGET osgLego::OpenSceneGraph)
    add_library(osgLego::OpenSceneGraph INTERFACE IMPORTED)
    target_include_directories(osgLego::OpenSceneGraph INTERFACE ${OPENSCENEGRAPH_INCLUDE_DIRS})
    target_link_libraries(osgLego::OpenSceneGraph INTERFACE ${OSGUTIL_LIBRARIES} ${OSGDB_LIBRARIES} ${OSG_LIBRARIES} ${OPENTHREADS_LIBRARIES})

    add_library(osgLego::OpenSceneGraphViewer INTERFACE IMPORTED)
    target_link_libraries(osgLego::OpenSceneGraphViewer INTERFACE
        ${OSGVIEWER_LIBRARIES} ${OSGGA_LIBRARIES} osgLego::OpenSceneGraph)
endif()
