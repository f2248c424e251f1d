# Run by cpack on the installed files of each package: adds the files that Debian's policy requires, and compresses manual pages.
if(NOT CPACK_GENERATOR STREQUAL DEB)
    return()
endif()

get_filename_component(source ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)

function(compress file)
    execute_process(COMMAND gzip -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A version of the project has one date, whenever its packages are made.
file(STRINGS ${source}/CHANGELOG.md releases REGEX "^## [0-9.]+, [0-9-]+$")
list(GET releases 0 release)
string(REGEX MATCH "[0-9-]+$" day ${release})
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date --utc --date ${day} --rfc-email
    OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
file(READ ${source}/LICENSE license)
file(READ ${source}/NOTICE notice)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
    set(documents ${tree}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    file(WRITE ${documents}/copyright "${notice}\n${license}")
    file(COPY_FILE ${source}/CHANGELOG.md ${documents}/changelog)
    file(WRITE ${documents}/changelog.Debian "${CPACK_DEBIAN_PACKAGE_SOURCE} (${version}) unstable; urgency=medium\n\n"
        "  * Package osgLego, whose changelog lists the changes.\n\n -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
    file(GLOB pages ${tree}/man/man1/*.1)
    foreach(file IN LISTS pages ITEMS ${documents}/changelog ${documents}/changelog.Debian)
        compress(${file})
    endforeach()
endforeach()
