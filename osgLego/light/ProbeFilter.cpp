#include <osgLego/light/ProbeFilter.h>

#include <osgLego/light/LatitudeLongitude.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace osgLego
{

namespace
{

using std::numbers::pi;
constexpr int NORMALS_ACROSS = ProbeFormat::CONVOLVED_WIDTH;
constexpr std::size_t NORMALS = NORMALS_ACROSS * NORMALS_ACROSS / 2;
/** Relative to the peak of a lobe: smaller weights are ignored. This omits a hundredth of the narrowest lobe. */
constexpr double LEAST_WEIGHT = 1e-4;

/** Normals and their irradiance in single precision, with an array per coordinate so that the compiler can vectorize.
 */
struct Normals
{
    std::array<float, NORMALS> x, y, z;
    std::array<float, NORMALS> red, green, blue;

    Normals()
    {
        for (std::size_t index = 0; index < NORMALS; ++index)
        {
            const std::size_t column = index % NORMALS_ACROSS;
            const std::size_t row = index / NORMALS_ACROSS;
            const osg::Vec3f normal(
                LatitudeLongitude::directionAt((static_cast<double>(column) + 0.5) / NORMALS_ACROSS,
                                               (static_cast<double>(row) + 0.5) / (NORMALS_ACROSS / 2.0)));
            x[index] = normal.x();
            y[index] = normal.y();
            z[index] = normal.z();
            red[index] = green[index] = blue[index] = 0.0f;
        }
    }

    void addLight(const osg::Vec3f& direction, const osg::Vec3f& light)
    {
        for (std::size_t index = 0; index < NORMALS; ++index)
        {
            const float product = x[index] * direction.x() + y[index] * direction.y() + z[index] * direction.z();
            const float cosine = product > 0.0f ? product : 0.0f;
            red[index] += cosine * light.x();
            green[index] += cosine * light.y();
            blue[index] += cosine * light.z();
        }
    }
};

/** The weights of the cells of a row for a pixel, by distance in columns. */
struct Kernel
{
    std::vector<int> columns;
    std::vector<float> weights;
    double sum = 0.0;
};

/** Computes the kernels of one roughness. They are the same for all pixels of a row. */
class LobeKernels
{
public:
    LobeKernels(double roughness, int columns, int columnsPerPixel) :
        _alphaSquared(std::pow(roughness, 4.0)), _columns(columns), _shift(columnsPerPixel % 2 == 0 ? 0.5 : 0.0)
    {
    }

    void compute(double pixelLatitude, double cellLatitude, double solidAngle, Kernel& kernel) const
    {
        kernel.columns.clear();
        kernel.weights.clear();
        const double along = std::cos(pixelLatitude) * std::cos(cellLatitude);
        const double across = std::sin(pixelLatitude) * std::sin(cellLatitude);
        for (int column = -_columns / 2; column < _columns / 2; ++column)
        {
            const double longitude = 2.0 * pi * (column + _shift) / _columns;
            const double weight = weightAt(across + along * std::cos(longitude));
            if (weight < LEAST_WEIGHT) continue;
            kernel.columns.push_back(column);
            kernel.weights.push_back(static_cast<float>(weight * solidAngle));
            kernel.sum += weight * solidAngle;
        }
    }

private:
    /** The distribution times the cosine, 1 in the centre of the lobe. */
    double weightAt(double cosine) const
    {
        if (cosine <= 0.0) return 0.0;
        // The half vector is halfway between the directions to the viewer and to the light.
        const double halfCosineSquared = 0.5 * (1.0 + cosine);
        const double spread = _alphaSquared / (halfCosineSquared * (_alphaSquared - 1.0) + 1.0);
        return cosine * spread * spread;
    }

    double _alphaSquared;
    int _columns;
    double _shift; // between the centres of pixels and of cells, in columns
};

/** A row of radiance, extended by half a turn at both ends. */
std::vector<osg::Vec3f> paddedRowOf(const RadianceGrid& grid, int row)
{
    const int width = grid.getWidth();
    std::vector<osg::Vec3f> result;
    result.reserve(2 * static_cast<std::size_t>(width));
    for (int column = 0; column < 2 * width; ++column)
        result.emplace_back(grid.getCell((column + width / 2) % width, row).radiance);
    return result;
}

double latitudeOf(int row, int height)
{
    return pi * ((row + 0.5) / height - 0.5);
}

} // namespace

osg::ref_ptr<osg::Image> convolveWithCosine(const RadianceGrid& grid)
{
    const auto normals = std::make_unique<Normals>();
    for (int row = 0; row < grid.getHeight(); ++row)
    {
        const double weight = LatitudeLongitude::solidAngleOf(row, grid.getWidth(), grid.getHeight()) / pi;
        for (int column = 0; column < grid.getWidth(); ++column)
        {
            const RadianceGrid::Cell& cell = grid.getCell(column, row);
            normals->addLight(cell.centroid, cell.radiance * weight);
        }
    }

    osg::ref_ptr<osg::Image> image = createRadianceImage(NORMALS_ACROSS, NORMALS_ACROSS / 2);
    auto* pixels = reinterpret_cast<osg::Vec3f*>(image->data());
    for (std::size_t index = 0; index < NORMALS; ++index)
        pixels[index].set(normals->red[index], normals->green[index], normals->blue[index]);
    return image;
}

osg::ref_ptr<osg::Image> filterByRoughness(const RadianceGrid& grid, double roughness, int width)
{
    const int height = width / 2;
    const int columnsPerPixel = grid.getWidth() / width;
    const LobeKernels kernels(roughness, grid.getWidth(), columnsPerPixel);
    std::vector<std::vector<osg::Vec3f>> rows;
    rows.reserve(static_cast<std::size_t>(grid.getHeight()));
    for (int row = 0; row < grid.getHeight(); ++row)
        rows.push_back(paddedRowOf(grid, row));

    osg::ref_ptr<osg::Image> image = createRadianceImage(width, height);
    auto* pixels = reinterpret_cast<osg::Vec3f*>(image->data());
    for (int row = 0; row < height; ++row)
    {
        std::vector<osg::Vec3d> sums(static_cast<std::size_t>(width));
        Kernel kernel;
        for (int gridRow = 0; gridRow < grid.getHeight(); ++gridRow)
        {
            kernels.compute(latitudeOf(row, height), latitudeOf(gridRow, grid.getHeight()),
                            LatitudeLongitude::solidAngleOf(gridRow, grid.getWidth(), grid.getHeight()), kernel);
            for (int column = 0; column < width; ++column)
            {
                // The cell at the centre of the pixel, or just to the right of it, after half a turn of padding.
                const int middle = column * columnsPerPixel + columnsPerPixel / 2 + grid.getWidth() / 2;
                const osg::Vec3f* cells = rows[static_cast<std::size_t>(gridRow)].data() + middle;
                osg::Vec3f sum;
                for (std::size_t index = 0; index < kernel.columns.size(); ++index)
                    sum += cells[kernel.columns[index]] * kernel.weights[index];
                sums[static_cast<std::size_t>(column)] += sum;
            }
        }
        for (const osg::Vec3d& sum : sums)
            *pixels++ = sum / kernel.sum;
    }
    return image;
}

} // namespace osgLego
