# Writes OUTPUT, a C++ source that holds the files of the list FILES (separated by "|") as string literals.
# Called as a script: cmake -D OUTPUT=... -D "FILES=a|b" -P EmbedShaders.cmake
string(REPLACE "|" ";" FILES "${FILES}")
set(text "#include <map>\n#include <string_view>\n\nnamespace osgLego\n{\n\n")
string(APPEND text "const std::map<std::string_view, std::string_view>& getEmbeddedShaders()\n{\n")
string(APPEND text "    static const std::map<std::string_view, std::string_view> shaders{\n")
foreach(file IN LISTS FILES)
    get_filename_component(name ${file} NAME)
    file(READ ${file} source)
    string(APPEND text "{\"${name}\", R\"glsl(${source})glsl\"},\n")
endforeach()
string(APPEND text "    };\n    return shaders;\n}\n\n} // namespace osgLego\n")
file(WRITE ${OUTPUT} "${text}")
