# Installs the libraries, their public headers, the packages for find_package(osgLego) and pkg-config, the licence, and the manual
# page of osglegocapture.
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/osgLego)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

install(TARGETS osgLego EXPORT osgLegoTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
get_target_property(public_headers osgLego OSGLEGO_PUBLIC_HEADERS)
install(FILES ${public_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/osgLego)
if(TARGET osgLegoBooklet)
    install(TARGETS osgLegoBooklet EXPORT osgLegoTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT booklet NAMELINK_COMPONENT development)
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

# The folder of the .pc file gives the prefix, so that the tree can be moved; with absolute folders, it can't.
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR} OR IS_ABSOLUTE ${CMAKE_INSTALL_INCLUDEDIR})
    set(OSGLEGO_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
    set(OSGLEGO_PC_LIBDIR ${CMAKE_INSTALL_FULL_LIBDIR})
    set(OSGLEGO_PC_INCLUDEDIR ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
    file(RELATIVE_PATH OSGLEGO_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" OSGLEGO_PC_PREFIX "\${pcfiledir}/${OSGLEGO_PC_PREFIX}")
    set(OSGLEGO_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(OSGLEGO_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(cmake/osgLego.pc.in ${PROJECT_BINARY_DIR}/osgLego.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/osgLego.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(TARGET osgLegoBooklet)
    configure_file(cmake/osgLegoBooklet.pc.in ${PROJECT_BINARY_DIR}/osgLegoBooklet.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/osgLegoBooklet.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# Debian's packages have another file with these texts.
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)

# Only builds of all targets make the manual page.
find_program(OSGLEGO_HELP2MAN help2man)
if(OSGLEGO_BUILD_APPLICATIONS AND OSGLEGO_HELP2MAN AND NOT OSGLEGO_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
    set(manual_page ${PROJECT_BINARY_DIR}/man/osglegocapture.1)
    add_custom_command(
        OUTPUT ${manual_page}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
        COMMAND ${OSGLEGO_HELP2MAN} --no-info --name "draw a scene in bricks to a picture, without a display"
                --output ${manual_page} $<TARGET_FILE:osglegocapture>
        DEPENDS osglegocapture COMMENT "Writing the manual page of osglegocapture" VERBATIM)
    add_custom_target(osgLegoManualPage ALL DEPENDS ${manual_page})
    install(FILES ${manual_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools OPTIONAL)
endif()
