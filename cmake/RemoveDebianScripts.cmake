# Run by cpack on finished packages: removes the scripts in which CPack calls ldconfig. The trigger of the packages suffices, and dpkg
# keeps a script of a removed package until that is purged.
if(NOT CPACK_GENERATOR STREQUAL DEB)
    return()
endif()

foreach(package IN LISTS CPACK_PACKAGE_FILES)
    set(tree ${package}.tree)
    execute_process(COMMAND dpkg-deb --raw-extract ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
    execute_process(COMMAND dpkg-deb --root-owner-group --build ${tree} ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE_RECURSE ${tree})
endforeach()
