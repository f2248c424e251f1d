# Installs the library, its public headers, and the package for find_package(osgLego).
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/osgLego)

install(TARGETS osgLego EXPORT osgLegoTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
get_target_property(public_headers osgLego OSGLEGO_PUBLIC_HEADERS)
install(FILES ${public_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/osgLego)
if(TARGET osgLegoBooklet)
    install(TARGETS osgLegoBooklet EXPORT osgLegoTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    get_target_property(booklet_headers osgLegoBooklet OSGLEGO_PUBLIC_HEADERS)
    install(FILES ${booklet_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/osgLegoBooklet)
endif()
install(EXPORT osgLegoTargets NAMESPACE osgLego:: DESTINATION ${package_folder})

configure_package_config_file(cmake/osgLegoConfig.cmake.in ${PROJECT_BINARY_DIR}/osgLegoConfig.cmake
    INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/osgLegoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/osgLegoConfig.cmake ${PROJECT_BINARY_DIR}/osgLegoConfigVersion.cmake
              cmake/OsgLegoOpenSceneGraph.cmake
        DESTINATION ${package_folder})
