#include <osgLego/light/ProbeFilter.h>

#include <osgLego/light/LatitudeLongitude.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace osgLego
{

namespace
{

using std::numbers::pi;
constexpr int NORMALS_ACROSS = ProbeFormat::CONVOLVED_WIDTH;
/** Pixels next to each other in a row. Their sums are local arrays, which stay in registers even with sanitizers. */
constexpr int BLOCK_WIDTH = 8;
static_assert(ProbeFormat::CONVOLVED_WIDTH % BLOCK_WIDTH == 0);
static_assert((ProbeFormat::REFLECTION_WIDTH >> (ProbeFormat::REFLECTION_LEVELS - 1)) % BLOCK_WIDTH == 0);
using Block = float[BLOCK_WIDTH];
/** Relative to the peak of a lobe: smaller weights are ignored. This omits a hundredth of the narrowest lobe. */
constexpr double LEAST_WEIGHT = 1e-4;

/** The light of a cell, and its direction. */
struct DirectedLight
{
    float x, y, z;
    float red, green, blue;
};

/** The light of all cells, divided by pi. */
std::vector<DirectedLight> listLights(const RadianceGrid& grid)
{
    std::vector<DirectedLight> lights;
    for (int row = 0; row < grid.getHeight(); ++row)
    {
        const double weight = LatitudeLongitude::solidAngleOf(row, grid.getWidth(), grid.getHeight()) / pi;
        for (int column = 0; column < grid.getWidth(); ++column)
        {
            const RadianceGrid::Cell& cell = grid.getCell(column, row);
            const osg::Vec3f direction(cell.centroid);
            const osg::Vec3f light(cell.radiance * weight);
            lights.push_back({direction.x(), direction.y(), direction.z(), light.x(), light.y(), light.z()});
        }
    }
    return lights;
}

/** Write the irradiance of normals next to each other in a row. */
void addUp(const std::vector<DirectedLight>& lights, int column, int row, osg::Vec3f* pixels)
{
    Block x, y, z;
    Block red{}, green{}, blue{};
    for (int place = 0; place < BLOCK_WIDTH; ++place)
    {
        const osg::Vec3f normal(LatitudeLongitude::directionAt((column + place + 0.5) / NORMALS_ACROSS,
                                                               (row + 0.5) / (NORMALS_ACROSS / 2.0)));
        x[place] = normal.x();
        y[place] = normal.y();
        z[place] = normal.z();
    }
    for (const DirectedLight& cell : lights)
        for (int place = 0; place < BLOCK_WIDTH; ++place)
        {
            const float product = x[place] * cell.x + y[place] * cell.y + z[place] * cell.z;
            const float cosine = product > 0.0f ? product : 0.0f;
            red[place] += cosine * cell.red;
            green[place] += cosine * cell.green;
            blue[place] += cosine * cell.blue;
        }
    for (int place = 0; place < BLOCK_WIDTH; ++place)
        pixels[place].set(red[place], green[place], blue[place]);
}

/** The weights of the cells of a row for a pixel: of those next to each other that have weights. */
struct Kernel
{
    int firstColumn = 0; // from that at the centre of the pixel
    std::vector<float> weights;
    double sum = 0.0;
};

/** Computes the kernels of one roughness. They are the same for all pixels of a row. */
class LobeKernels
{
public:
    LobeKernels(double roughness, int columns, int columnsPerPixel) :
        _alphaSquared(std::pow(roughness, 4.0)), _firstColumn(-columns / 2)
    {
        const double shift = columnsPerPixel % 2 == 0 ? 0.5 : 0.0; // between the centres of pixels and of cells
        for (int column = _firstColumn; column < columns / 2; ++column)
            _cosines.push_back(std::cos(2.0 * pi * (column + shift) / columns));
    }

    void compute(double pixelLatitude, double cellLatitude, double solidAngle, Kernel& kernel) const
    {
        kernel.weights.clear();
        const double along = std::cos(pixelLatitude) * std::cos(cellLatitude);
        const double across = std::sin(pixelLatitude) * std::sin(cellLatitude);
        for (std::size_t index = 0; index < _cosines.size(); ++index)
        {
            const double weight = weightAt(across + along * _cosines[index]);
            if (weight < LEAST_WEIGHT) continue; // before or after all others, since weights rise to the middle
            if (kernel.weights.empty()) kernel.firstColumn = _firstColumn + static_cast<int>(index);
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
    int _firstColumn;
    std::vector<double> _cosines; // of the longitudes of cells from the pixel
};

/** A row of radiance, extended by half a turn at both ends. Cells that are a pixel apart are next to each other, so
 * that the compiler can vectorize over the pixels. */
class PaddedRow
{
public:
    PaddedRow(const RadianceGrid& grid, int row, int columnsPerPixel) :
        _columnsPerPixel(columnsPerPixel), _stride(2 * grid.getWidth() / columnsPerPixel)
    {
        const int width = grid.getWidth();
        for (std::vector<float>& channel : _channels)
            channel.resize(2 * static_cast<std::size_t>(width));
        for (int column = 0; column < 2 * width; ++column)
        {
            const osg::Vec3f radiance(grid.getCell((column + width / 2) % width, row).radiance);
            for (int channel = 0; channel < 3; ++channel)
                _channels[static_cast<std::size_t>(channel)][placeOf(column)] = radiance[channel];
        }
    }

    /** The values of a channel in a column, and in each that is a multiple of a pixel to the right of it. */
    const float* getColumn(std::size_t channel, int column) const { return &_channels[channel][placeOf(column)]; }

private:
    std::size_t placeOf(int column) const
    {
        return static_cast<std::size_t>(column % _columnsPerPixel * _stride + column / _columnsPerPixel);
    }

    int _columnsPerPixel;
    int _stride;
    std::array<std::vector<float>, 3> _channels;
};

/** The sums of a row of pixels, a channel after the other. */
using RowSums = std::array<std::vector<double>, 3>;

/** Add the light of a row of cells. @param middle the column of the cell at the centre of the first pixel, or just to
 * the right of it. */
void addLight(const PaddedRow& row, int middle, const Kernel& kernel, RowSums& sums)
{
    const int first = middle + kernel.firstColumn;
    for (std::size_t channel = 0; channel < sums.size(); ++channel)
        for (std::size_t pixel = 0; pixel < sums[channel].size(); pixel += BLOCK_WIDTH)
        {
            Block block{};
            int column = first;
            for (const float weight : kernel.weights)
            {
                const float* values = row.getColumn(channel, column++) + pixel;
                for (int place = 0; place < BLOCK_WIDTH; ++place)
                    block[place] += values[place] * weight;
            }
            for (std::size_t place = 0; place < BLOCK_WIDTH; ++place)
                sums[channel][pixel + place] += static_cast<double>(block[place]);
        }
}

double latitudeOf(int row, int height)
{
    return pi * ((row + 0.5) / height - 0.5);
}

} // namespace

osg::ref_ptr<osg::Image> convolveWithCosine(const RadianceGrid& grid)
{
    const std::vector<DirectedLight> lights = listLights(grid);
    osg::ref_ptr<osg::Image> image = createRadianceImage(NORMALS_ACROSS, NORMALS_ACROSS / 2);
    auto* pixels = reinterpret_cast<osg::Vec3f*>(image->data());
    for (int row = 0; row < NORMALS_ACROSS / 2; ++row)
        for (int column = 0; column < NORMALS_ACROSS; column += BLOCK_WIDTH)
        {
            addUp(lights, column, row, pixels);
            pixels += BLOCK_WIDTH;
        }
    return image;
}

osg::ref_ptr<osg::Image> filterByRoughness(const RadianceGrid& grid, double roughness, int width)
{
    const int height = width / 2;
    const int columnsPerPixel = grid.getWidth() / width;
    const LobeKernels kernels(roughness, grid.getWidth(), columnsPerPixel);
    std::vector<PaddedRow> rows;
    rows.reserve(static_cast<std::size_t>(grid.getHeight()));
    for (int row = 0; row < grid.getHeight(); ++row)
        rows.emplace_back(grid, row, columnsPerPixel);

    osg::ref_ptr<osg::Image> image = createRadianceImage(width, height);
    auto* pixels = reinterpret_cast<osg::Vec3f*>(image->data());
    const int middle = columnsPerPixel / 2 + grid.getWidth() / 2; // after half a turn of padding
    for (int row = 0; row < height; ++row)
    {
        RowSums sums;
        sums.fill(std::vector<double>(static_cast<std::size_t>(width), 0.0));
        Kernel kernel;
        for (int gridRow = 0; gridRow < grid.getHeight(); ++gridRow)
        {
            kernels.compute(latitudeOf(row, height), latitudeOf(gridRow, grid.getHeight()),
                            LatitudeLongitude::solidAngleOf(gridRow, grid.getWidth(), grid.getHeight()), kernel);
            addLight(rows[static_cast<std::size_t>(gridRow)], middle, kernel, sums);
        }
        for (std::size_t column = 0; column < sums[0].size(); ++column)
            *pixels++ = osg::Vec3d(sums[0][column], sums[1][column], sums[2][column]) / kernel.sum;
    }
    return image;
}

} // namespace osgLego
