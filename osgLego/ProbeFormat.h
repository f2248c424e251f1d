#pragma once

namespace osgLego
{

/** The projections of a light probe's picture, and the sizes of the pictures that are computed from it. LightProbe
 * describes them. */
struct ProbeFormat
{
    /** The projection of a picture. */
    enum Mapping
    {
        AUTO,               //!< by shape: LATITUDE_LONGITUDE if twice as wide as high, ANGULAR if square
        LATITUDE_LONGITUDE, //!< any shape, if requested explicitly
        ANGULAR             //!< square; pixels outside the circle are ignored
    };

    static constexpr int REFLECTION_LEVELS = 6;
    static constexpr int REFLECTION_WIDTH = 256; //!< pixels, of level 0; twice the height
    static constexpr int CONVOLVED_WIDTH = 64;   //!< pixels, of the convolved map; twice the height
};

} // namespace osgLego
