# As a module: osglego_embed_texts(OUTPUT FUNCTION FOLDER FILE...) generates OUTPUT, a C++ source whose FUNCTION
# returns the texts of the files by path. Paths are relative to FOLDER, or to its parent for files outside FOLDER. Style
# sheets and scripts also have their SHA-256, in hexadecimal digits, by the path with .sha256.
# As a script, to generate it: cmake -D OUTPUT=... -D FUNCTION=... -D FOLDER=... -D "FILES=a|b" -P EmbedTexts.cmake
set(OSGLEGO_EMBED_TEXTS ${CMAKE_CURRENT_LIST_FILE})

function(osglego_embed_texts output function folder)
    list(JOIN ARGN "|" files)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D FUNCTION=${function} -D FOLDER=${folder} -D "FILES=${files}"
                -P ${OSGLEGO_EMBED_TEXTS}
        DEPENDS ${ARGN} ${OSGLEGO_EMBED_TEXTS}
        COMMENT "Embedding the texts of ${function}" VERBATIM)
    # scripts/tidy checks what is compiled together, and does not generate anything.
    set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
    return()
endif()

string(REPLACE "|" ";" FILES "${FILES}")
set(text "#include <map>\n#include <string_view>\n\nnamespace osgLego\n{\n\n")
string(APPEND text "const std::map<std::string_view, std::string_view>& ${FUNCTION}()\n{\n")
string(APPEND text "    static const std::map<std::string_view, std::string_view> texts{\n")
foreach(file IN LISTS FILES)
    file(RELATIVE_PATH name ${FOLDER} ${file})
    string(REGEX REPLACE "^\\.\\./" "" name ${name})
    file(READ ${file} source)
    string(APPEND text "{\"${name}\", R\"text(${source})text\"},\n")
    if(name MATCHES "\\.(css|js)$")
        string(SHA256 hash "${source}")
        string(APPEND text "{\"${name}.sha256\", \"${hash}\"},\n")
    endif()
endforeach()
string(APPEND text "    };\n    return texts;\n}\n\n} // namespace osgLego\n")
file(WRITE ${OUTPUT} "${text}")
