#include "BookletPictures.h"

#include "BookletFailure.h"

#include <common/PictureBuffer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr double DENSITY = 2.0;          // pixels of pictures per pixel of CSS
constexpr double LARGEST_WIDTH = 1600;   // pixels
constexpr double LARGEST_HEIGHT = 1400;  // pixels
constexpr double LARGEST_PITCH = 120;    // pixels; larger bricks would look odd beside those of the parts lists
constexpr double PART_DENSITY = 3.0;     // pictures of parts are small, and printed as large
constexpr double PART_PITCH = 20.0;      // pixels of CSS
constexpr double MARGIN = 0.15;          // pitches around a model, for outlines and rounding
constexpr double LARGEST_SUBMODEL = 900; // pixels along each side of a submodel in lists
constexpr double ARROW_LENGTH = 3.0;     // pitches
constexpr double ARROW_WIDTH = 0.45;     // pitches
constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();

BookletFrame addMargin(BookletFrame frame)
{
    frame.lowest -= MARGIN;
    frame.highest += MARGIN;
    return frame;
}

/** Widen a frame about its middle. */
BookletFrame widen(BookletFrame frame, double width)
{
    const double more = 0.5 * (width - frame.getSize().x);
    frame.lowest.x -= more;
    frame.highest.x += more;
    return frame;
}

/** Round the size of a frame up to whole pixels. */
glm::ivec2 roundToPixels(BookletFrame& frame, double pixels)
{
    const glm::ivec2 size = glm::max(glm::ivec2(glm::ceil(frame.getSize() * pixels - 1e-6)), glm::ivec2(1));
    frame.highest = frame.lowest + glm::dvec2(size) / pixels;
    return size;
}

/** A file format, and its quality for OpenImageIO. */
struct PictureFormat
{
    const char* fileName;
    const char* mediaType;
    const char* compression;
};

// Browsers copy JPEG into PDF as it is, and store pictures in all other formats without losses there: the PDF of 370
// parts has 10 MB in place of 35. WebP has transparency, and a fifth of the bytes of PNG.
constexpr PictureFormat OPAQUE_FORMAT{"picture.jpg", "image/jpeg", "jpeg:88"};
constexpr PictureFormat TRANSPARENT_FORMAT{"picture.webp", "image/webp", "webp:90"};

BookletPicture encode(const osg::Image& image, double density)
{
    const PictureFormat& format = image.getPixelFormat() == GL_RGBA ? TRANSPARENT_FORMAT : OPAQUE_FORMAT;
    OIIO::ImageBuf picture = toImageBuf(image);
    picture.specmod().attribute("compression", format.compression);
    OIIO::Filesystem::IOVecOutput bytes;
    picture.set_write_ioproxy(&bytes);
    if (!picture.write(format.fileName)) throw BookletFailure(BookletError::Reason::BAD_FILE, picture.geterror());
    BookletPicture encoded;
    encoded.bytes.assign(bytes.buffer().begin(), bytes.buffer().end());
    encoded.mediaType = format.mediaType;
    encoded.width = image.s();
    encoded.height = image.t();
    encoded.density = density;
    return encoded;
}

osg::ref_ptr<const BuildingPlan> createPlanOfOnePart()
{
    std::vector<BuildingStep> steps(1);
    steps.front().parts = {0};
    return BuildingPlan::create(1, std::move(steps));
}

/** A part of a kind, with its long side to the right, in a separate grid. */
osg::ref_ptr<const BrickModel> createModelOfKind(const PartsList::Row& row)
{
    constexpr double BRICK_HEIGHT = 1.2; // pitches
    const bool isPlate = row.type->family == PartFamily::PLATE;
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, isPlate ? BRICK_HEIGHT / 3.0 : BRICK_HEIGHT};
    grid.dimensions = {row.type->length, row.type->width, 1};
    Part part;
    part.size = {static_cast<std::uint8_t>(row.type->length), static_cast<std::uint8_t>(row.type->width), 1};
    part.color = row.color.color;
    part.colorCode = row.color.code;
    return BrickModel::createOfParts(grid, {part});
}

} // namespace

BookletPictures::BookletPictures(const BookletModel& model, BookletRenderer& renderer) :
    _model(model), _renderer(renderer), _shown(NONE)
{
    for (const BookletChapter& chapter : model.getChapters())
        _scales.push_back(findScale(chapter));
}

/** The part of the picture that a step needs: as high as the parts in place and the arrows, and as wide as the finished
 * model, so that the model stays where it is from step to step. */
BookletFrame BookletPictures::findFrame(const BookletChapter& chapter, const BookletStep& step,
                                        const BookletCamera& camera) const
{
    std::vector<Part> placed;
    for (std::size_t rank = 0; rank < step.numPlaced; ++rank)
        placed.push_back(chapter.model->getParts()[chapter.plan->getOrder()[rank]]);
    const BookletFrame whole = camera.findFrame(chapter.model->getParts());
    BookletFrame frame = camera.findFrame(placed);
    frame.lowest.x = whole.lowest.x;
    frame.highest.x = whole.highest.x;
    for (const BookletArrow& arrow : findArrows(step, camera))
    {
        frame.lowest = glm::min(frame.lowest, arrow.tail);
        frame.highest = glm::max(frame.highest, arrow.tail);
    }
    return addMargin(frame);
}

/** The arrows to the submodels that a step attaches, in pitches in the plane of the picture. */
std::vector<BookletArrow> BookletPictures::findArrows(const BookletStep& step, const BookletCamera& camera) const
{
    std::vector<BookletArrow> arrows;
    for (const std::size_t submodel : step.submodels)
    {
        const BookletFrame frame = camera.findFrame(_model.getChapters()[submodel].model->getParts());
        BookletArrow arrow;
        arrow.width = ARROW_WIDTH;
        arrow.tip.x = arrow.tail.x = 0.5 * (frame.lowest.x + frame.highest.x);
        arrow.tip.y = frame.highest.y + ARROW_WIDTH;
        arrow.tail.y = arrow.tip.y + ARROW_LENGTH;
        arrows.push_back(arrow);
    }
    return arrows;
}

BookletPictures::Scale BookletPictures::findScale(const BookletChapter& chapter) const
{
    Scale scale;
    for (const BookletStep& step : chapter.steps)
    {
        const BookletCamera camera(chapter.model->getGrid(), {step.turns, step.isUpsideDown});
        scale.size = glm::max(scale.size, findFrame(chapter, step, camera).getSize());
    }
    scale.pixels = std::min({LARGEST_WIDTH / scale.size.x, LARGEST_HEIGHT / scale.size.y, LARGEST_PITCH});
    return scale;
}

void BookletPictures::show(std::size_t chapter)
{
    if (_shown == chapter) return;
    const BookletChapter& own = _model.getChapters()[chapter];
    _renderer.setModel(*own.model, *own.plan);
    _shown = chapter;
}

BookletPicture BookletPictures::drawKind(std::size_t kind)
{
    const osg::ref_ptr<const BrickModel> model = createModelOfKind(_model.getKinds()[kind]);
    _renderer.setModel(*model, *createPlanOfOnePart());
    _renderer.setPlaced(1, 0);
    _renderer.setUpsideDown(false);
    _renderer.setOcclusion(false);
    _shown = NONE;
    const BookletCamera camera(model->getGrid(), {});
    BookletFrame frame = addMargin(camera.findFrame(model->getParts()));
    const glm::ivec2 size = roundToPixels(frame, PART_PITCH * PART_DENSITY);
    return encode(*_renderer.drawTransparent(camera, frame, size), PART_DENSITY);
}

BookletPicture BookletPictures::drawFinished(std::size_t chapter)
{
    // The cover and the last page show the same, which takes most of the time of a small booklet.
    if (chapter > 0) return drawWhole(chapter);
    if (!_finished) _finished = drawWhole(chapter);
    return *_finished;
}

BookletPicture BookletPictures::drawWhole(std::size_t chapter)
{
    show(chapter);
    const BookletChapter& own = _model.getChapters()[chapter];
    _renderer.setPlaced(own.model->getParts().size(), 0);
    _renderer.setUpsideDown(false);
    const bool isSubmodel = chapter > 0;
    _renderer.setOcclusion(!isSubmodel);
    const BookletCamera camera(own.model->getGrid(), {});
    BookletFrame frame = addMargin(camera.findFrame(own.model->getParts()));
    const glm::dvec2 largest = isSubmodel ? glm::dvec2(LARGEST_SUBMODEL) : glm::dvec2(LARGEST_WIDTH, LARGEST_HEIGHT);
    const glm::dvec2 fitting = largest / frame.getSize();
    const double pixels = std::min({fitting.x, fitting.y, isSubmodel ? PART_PITCH * PART_DENSITY : LARGEST_PITCH});
    const glm::ivec2 size = roundToPixels(frame, pixels);
    return encode(*_renderer.drawTransparent(camera, frame, size), isSubmodel ? PART_DENSITY : DENSITY);
}

BookletPicture BookletPictures::drawStep(std::size_t chapter, std::size_t step)
{
    show(chapter);
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& shown = own.steps[step];
    _renderer.setPlaced(shown.numPlaced, shown.numNew);
    _renderer.setUpsideDown(shown.isUpsideDown);
    _renderer.setOcclusion(false);

    const BookletCamera camera(own.model->getGrid(), {shown.turns, shown.isUpsideDown});
    const double pixels = _scales[chapter].pixels;
    BookletFrame frame = widen(findFrame(own, shown, camera), _scales[chapter].size.x);
    const glm::ivec2 size = roundToPixels(frame, pixels);
    BookletPicture picture = encode(*_renderer.draw(camera, frame, size), DENSITY);
    const auto toPixels = [&](const glm::dvec2& place)
    { return glm::dvec2(place.x - frame.lowest.x, frame.highest.y - place.y) * pixels; };
    for (const BookletArrow& arrow : findArrows(shown, camera))
        picture.arrows.push_back({toPixels(arrow.tail), toPixels(arrow.tip), arrow.width * pixels});
    return picture;
}

double BookletPictures::getAspect(std::size_t chapter) const
{
    return _scales[chapter].size.x / _scales[chapter].size.y;
}

} // namespace osgLego
