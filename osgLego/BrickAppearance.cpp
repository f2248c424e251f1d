#include <osgLego/BrickAppearance.h>

#include <sstream>

namespace osgLego
{

namespace
{

constexpr int MAXIMUM_RELIEF_SIZE = 2048;

std::string rangeError(const char* name, double value, double minimum, double maximum)
{
    if (value >= minimum && value <= maximum) return {};
    std::ostringstream text;
    text << "bad value '" << value << "' for " << name << "; expected " << minimum << " to " << maximum;
    return text.str();
}

} // namespace

std::string BrickAppearance::check() const
{
    for (const std::string& error :
         {rangeError("reliefHeight", reliefHeight, 0.0, 0.2), rangeError("roughness", roughness, 0.05, 1.0),
          rangeError("variation", variation, 0.0, 5.0), rangeError("outline", outline, 0.0, 8.0)})
        if (!error.empty()) return error;
    if (!reliefImage) return {};
    const bool hasPixels = reliefImage->data() && !reliefImage->isCompressed() && reliefImage->s() > 0 &&
                           reliefImage->t() > 0 && reliefImage->r() == 1;
    if (!hasPixels || reliefImage->s() > MAXIMUM_RELIEF_SIZE || reliefImage->t() > MAXIMUM_RELIEF_SIZE)
        return "the image of the relief can't be used; expected a flat one, not compressed, of 1 to 2048 pixels along "
               "each side";
    return {};
}

} // namespace osgLego
