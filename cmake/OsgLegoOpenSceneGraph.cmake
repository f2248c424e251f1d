# Targets for OpenSceneGraph, whose own find module gives variables only: osgLego::OpenSceneGraph, which the library needs,
# and osgLego::OpenSceneGraphViewer, which programs need besides. Used by the build and by the installed package alike.
find_package(OpenSceneGraph 3.6 QUIET COMPONENTS osgViewer osgGA osgDB osgUtil)

if(OPENSCENEGRAPH_FOUND AND NOT TARGET osgLego::OpenSceneGraph)
    add_library(osgLego::OpenSceneGraph INTERFACE IMPORTED)
    target_include_directories(osgLego::OpenSceneGraph INTERFACE ${OPENSCENEGRAPH_INCLUDE_DIRS})
    target_link_libraries(osgLego::OpenSceneGraph INTERFACE ${OSGUTIL_LIBRARIES} ${OSGDB_LIBRARIES} ${OSG_LIBRARIES} ${OPENTHREADS_LIBRARIES})

    add_library(osgLego::OpenSceneGraphViewer INTERFACE IMPORTED)
    target_link_libraries(osgLego::OpenSceneGraphViewer INTERFACE
        ${OSGVIEWER_LIBRARIES} ${OSGGA_LIBRARIES} osgLego::OpenSceneGraph)
endif()
