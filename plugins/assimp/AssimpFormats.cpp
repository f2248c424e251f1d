#include "AssimpFormats.h"

#include <algorithm>
#include <array>

namespace
{

// Assimp turns models of most formats with Z upwards to Y upwards itself. It reads .amf and .off as they are: the first
// has Z upwards by its specification, and .off has no upward axis, as .ply and .stl, which OSG does not turn either.
//
// Formats whose importers in Assimp 5.2 crash or hang on damaged files are left out: .3mf, .ase, .blend, .cob, .ifc,
// .lxo, .md5mesh, .ogex, .smd and .zae.
constexpr std::array<AssimpFormat, 16> FORMATS{{
    {"amf", "Additive Manufacturing File", false},
    {"b3d", "Blitz3D model", true},
    {"fbx", "Autodesk FBX", true},
    {"glb", "Binary glTF", true},
    {"gltf", "glTF", true},
    {"hmp", "3D GameStudio terrain", true},
    {"iqm", "Inter-Quake model", true},
    {"mdc", "Return to Castle Wolfenstein model", true},
    {"ms3d", "MilkShape 3D model", true},
    {"nff", "Neutral File Format, Sense8 WorldToolKit", true},
    {"off", "Object File Format", false},
    {"q3o", "Quick3D object", true},
    {"q3s", "Quick3D scene", true},
    {"sib", "Silo model", true},
    {"x3d", "Extensible 3D", true},
    {"xgl", "XGL", true},
}};

} // namespace

std::span<const AssimpFormat> getAssimpFormats()
{
    return FORMATS;
}

const AssimpFormat* findAssimpFormat(std::string_view extension)
{
    const auto* const found =
        std::find_if(FORMATS.begin(), FORMATS.end(),
                     [extension](const AssimpFormat& format) { return format.extension == extension; });
    return found == FORMATS.end() ? nullptr : found;
}
