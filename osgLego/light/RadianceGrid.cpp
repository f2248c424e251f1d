#include <osgLego/light/RadianceGrid.h>

#include <osgLego/light/LatitudeLongitude.h>

#include <algorithm>
#include <new>

namespace osgLego
{

namespace
{

/** Sums the light of a cell. */
struct CellSum
{
    double solidAngle = 0.0;
    osg::Vec3d flux;
    double brightness = 0.0;
    osg::Vec3d moment; // sum of the directions, weighted by brightness

    void add(const osg::Vec3d& radiance, const osg::Vec3d& direction, double weight)
    {
        const double light = weight * (radiance.x() + radiance.y() + radiance.z());
        solidAngle += weight;
        flux += radiance * weight;
        brightness += light;
        moment += direction * light;
    }

    RadianceGrid::Cell getMean(const osg::Vec3d& middle) const
    {
        return {flux / solidAngle, brightness > 0.0 ? moment / brightness : middle};
    }
};

} // namespace

RadianceGrid::RadianceGrid(int width, int height) :
    _width(width), _height(height), _cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
}

RadianceGrid::RadianceGrid(const RadiancePicture& picture, int width, int height) : RadianceGrid(width, height)
{
    std::vector<CellSum> sums(_cells.size());
    picture.visit(
        [&](const RadiancePicture::Piece& piece)
        {
            const int column = std::min(static_cast<int>(piece.place.x() * width), width - 1);
            const int row = std::min(static_cast<int>(piece.place.y() * height), height - 1);
            sums[indexOf(column, row)].add(piece.radiance, piece.direction, piece.solidAngle);
        });
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
        {
            const osg::Vec3d middle = LatitudeLongitude::directionAt((column + 0.5) / width, (row + 0.5) / height);
            CellSum& sum = sums[indexOf(column, row)];
            // Near the poles, cells are so narrow that all pieces of an angular map may miss them.
            if (sum.solidAngle == 0.0) sum.add(picture.getRadiance(middle), middle, 1.0);
            _cells[indexOf(column, row)] = sum.getMean(middle);
        }
}

std::size_t RadianceGrid::indexOf(int column, int row) const
{
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(_width) + static_cast<std::size_t>(column);
}

RadianceGrid RadianceGrid::halved() const
{
    RadianceGrid result(_width / 2, _height / 2);
    for (int row = 0; row < result._height; ++row)
        for (int column = 0; column < result._width; ++column)
        {
            CellSum sum;
            for (int part = 0; part < 4; ++part)
            {
                const int fineRow = 2 * row + part / 2;
                const Cell& cell = getCell(2 * column + part % 2, fineRow);
                sum.add(cell.radiance, cell.centroid, LatitudeLongitude::solidAngleOf(fineRow, _width, _height));
            }
            result._cells[result.indexOf(column, row)] = sum.getMean(
                LatitudeLongitude::directionAt((column + 0.5) / result._width, (row + 0.5) / result._height));
        }
    return result;
}

osg::ref_ptr<osg::Image> RadianceGrid::createImage() const
{
    osg::ref_ptr<osg::Image> image = createRadianceImage(_width, _height);
    auto* pixels = reinterpret_cast<osg::Vec3f*>(image->data());
    std::transform(_cells.begin(), _cells.end(), pixels, [](const Cell& cell) { return osg::Vec3f(cell.radiance); });
    return image;
}

osg::ref_ptr<osg::Image> createRadianceImage(int width, int height)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_FLOAT);
    if (!image->data()) throw std::bad_alloc();
    image->setInternalTextureFormat(GL_RGB32F_ARB);
    return image;
}

} // namespace osgLego
