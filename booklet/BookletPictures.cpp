#include "BookletPictures.h"

#include "BookletFailure.h"
#include "HiddenParts.h"
#include "NewPartMask.h"
#include "NewPartOutline.h"

#include <common/PictureBuffer.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr double DENSITY = 1.5;          // pixels of pictures per pixel of CSS
constexpr double LARGEST_WIDTH = 1200;   // pixels
constexpr double LARGEST_HEIGHT = 1050;  // pixels
constexpr double LARGEST_PITCH = 90;     // pixels; larger bricks would look odd beside those of the parts lists
constexpr double PART_DENSITY = 2.0;     // pictures of parts are small, and printed as large
constexpr double PART_PITCH = 20.0;      // pixels of CSS
constexpr double LARGEST_PLATE = 333;    // pixels of the width of a base plate in lists
constexpr double MARGIN = 0.15;          // pitches around a model, for outlines and rounding
constexpr double LARGEST_SUBMODEL = 600; // pixels along each side of a submodel in lists
constexpr double ARROW_WIDTH = 0.45;     // pitches, of the shafts of arrows
constexpr double ARROW_SHARE = 1.0 / 90; // likewise, at least, of the width of the picture: letters must be readable
constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();

BookletFrame addMargin(const BookletFrame& frame)
{
    return frame.addMargin(MARGIN);
}

/** Widen a frame to a width, about the middle of another one. */
BookletFrame widen(BookletFrame frame, double width, const BookletFrame& other)
{
    const double middle = 0.5 * (other.lowest.x + other.highest.x);
    frame.lowest.x = middle - 0.5 * width;
    frame.highest.x = middle + 0.5 * width;
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
// parts has 10 MB in place of 35. WebP has transparency, and a fifth of the bytes of PNG, but takes ten times as long.
constexpr PictureFormat OPAQUE_FORMAT{"picture.jpg", "image/jpeg", "jpeg:88"};
constexpr PictureFormat SMALL_FORMAT{"picture.png", "image/png", "zip:6"};
constexpr PictureFormat LARGE_FORMAT{"picture.webp", "image/webp", "webp:90"};
constexpr int LARGE = 500000; // pixels

const PictureFormat& chooseFormat(const osg::Image& image)
{
    if (image.getPixelFormat() != GL_RGBA) return OPAQUE_FORMAT;
    return image.s() * image.t() < LARGE ? SMALL_FORMAT : LARGE_FORMAT;
}

BookletPicture encode(const osg::Image& image, double density, double pitch)
{
    const PictureFormat& format = chooseFormat(image);
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
    encoded.pitch = pitch;
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

BookletPictures::BookletPictures(const BookletModel& model, BookletRenderer& renderer, const BuildingView& front) :
    _model(model), _renderer(renderer), _front(front), _shown(NONE)
{
    if (model.getBasePlate())
    {
        _plate = model.getBasePlate()->createModel(false);
        _fadedPlate = model.getBasePlate()->createModel(true);
    }
    for (const BookletChapter& chapter : model.getChapters())
        _scales.push_back(findScale(chapter));
}

/** Whether the base plate, if there is one, is below the parts of a chapter: submodels are built beside it. */
bool BookletPictures::isOnPlate(const BookletChapter& chapter) const
{
    return _plate && &chapter == &_model.getMainChapter();
}

BookletFrame BookletPictures::findWholeFrame(const BookletChapter& chapter, const BookletCamera& camera) const
{
    const BookletFrame frame = camera.findFrame(*chapter.model);
    return isOnPlate(chapter) ? frame.unite(camera.findFrame(*_plate)) : frame;
}

/** The part of the picture with the parts in place: as wide as the finished model, so that the model stays where it is
 * from step to step. */
BookletFrame BookletPictures::findPlacedFrame(const BookletChapter& chapter, const BookletStep& step,
                                              const BookletCamera& camera) const
{
    std::vector<Part> placed;
    for (std::size_t rank = 0; rank < step.numPlaced; ++rank)
        placed.push_back(chapter.model->getParts()[chapter.plan->getOrder()[rank]]);
    const BookletFrame whole = findWholeFrame(chapter, camera);
    BookletFrame frame = camera.findFrame(placed);
    if (isOnPlate(chapter)) frame = frame.unite(camera.findFrame(*_plate));
    frame.lowest.x = whole.lowest.x;
    frame.highest.x = whole.highest.x;
    return frame;
}

/** The part of the picture that a step needs, with its arrows, and with the model in its middle. */
BookletFrame BookletPictures::findFrame(const BookletChapter& chapter, const BookletStep& step,
                                        const BookletCamera& camera) const
{
    const BookletFrame placed = findPlacedFrame(chapter, step, camera);
    const std::optional<BookletFrame>& arrows = findArrows(chapter, step, camera).getFrame();
    if (!arrows) return addMargin(placed);
    const BookletFrame frame = placed.unite(*arrows);
    const double beside = std::max(placed.lowest.x - frame.lowest.x, frame.highest.x - placed.highest.x);
    return addMargin(widen(frame, placed.getSize().x + 2.0 * beside, placed));
}

/** The new parts of a step that others hide, as indices into the parts of the chapter's model. */
std::vector<std::uint32_t> BookletPictures::findHidden(const BookletChapter& chapter, const BookletStep& step,
                                                       const BookletCamera& camera)
{
    const std::span<const std::uint32_t> placed = std::span(chapter.plan->getOrder()).first(step.numPlaced);
    return findHiddenParts(*chapter.model, placed, placed.last(step.numNew).first(step.numDirect), camera.getToEye());
}

/** The arrows to the submodels that a step attaches, and to its hidden parts, in pitches in the plane of the picture.
 */
const ArrowPlacement& BookletPictures::findArrows(const BookletChapter& chapter, const BookletStep& step,
                                                  const BookletCamera& camera) const
{
    if (const auto known = _arrows.find(&step); known != _arrows.end()) return known->second;
    const BookletFrame area = findPlacedFrame(chapter, step, camera);
    const double width = std::max(ARROW_WIDTH, ARROW_SHARE * area.getSize().x);
    const auto frameOf = [&camera](const Part& part) { return camera.findFrame(std::span(&part, 1)); };
    std::vector<ArrowTarget> targets;
    std::vector<BookletFrame> shown;
    for (const std::size_t submodel : step.submodels)
    {
        const BookletChapter& own = _model.getChapters()[submodel];
        const BookletFrame frame = camera.findFrame(own.model->getParts());
        targets.push_back({{0.5 * (frame.lowest.x + frame.highest.x), frame.highest.y + width},
                           step.hasLetters() ? own.letter.size() : 0});
        std::transform(own.model->getParts().begin(), own.model->getParts().end(), std::back_inserter(shown), frameOf);
    }
    const std::vector<std::uint32_t> hidden = findHidden(chapter, step, camera);
    const auto placed = std::span(chapter.plan->getOrder()).first(step.numPlaced);
    for (const std::uint32_t part : placed.last(step.numNew).first(step.numDirect))
    {
        const BookletFrame frame = frameOf(chapter.model->getParts()[part]);
        if (std::find(hidden.begin(), hidden.end(), part) == hidden.end())
            shown.push_back(frame);
        else
            targets.push_back({0.5 * (frame.lowest + frame.highest)});
    }
    return _arrows.try_emplace(&step, targets, width, area, shown).first->second;
}

BookletPictures::Scale BookletPictures::findScale(const BookletChapter& chapter) const
{
    Scale scale;
    for (const BookletStep& step : chapter.steps)
    {
        const BookletCamera camera = createCamera(chapter, step);
        scale.size = glm::max(scale.size, findFrame(chapter, step, camera).getSize());
    }
    scale.pixels = std::min({LARGEST_WIDTH / scale.size.x, LARGEST_HEIGHT / scale.size.y, LARGEST_PITCH});
    return scale;
}

BookletCamera BookletPictures::createCamera(const BookletChapter& chapter, const BookletStep& step) const
{
    return {chapter.model->getGrid(), {step.turns, step.isUpsideDown, _front}};
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
    _renderer.setBase(nullptr);
    _renderer.setFullLook(false);
    _shown = NONE;
    const BookletCamera camera(model->getGrid(), {});
    BookletFrame frame = addMargin(camera.findFrame(model->getParts()));
    const glm::ivec2 size = roundToPixels(frame, PART_PITCH * PART_DENSITY);
    return encode(*_renderer.drawTransparent(camera, frame, size), PART_DENSITY, PART_PITCH * PART_DENSITY);
}

BookletPicture BookletPictures::drawBasePlate()
{
    const BrickModel& plate = *_plate;
    // One plate of several is enough.
    const osg::ref_ptr<const BrickModel> one = BrickModel::createOfParts(plate.getGrid(), {plate.getParts().front()});
    _renderer.setModel(*one, *createPlanOfOnePart());
    _renderer.setPlaced(1, 0);
    _renderer.setBase(nullptr);
    _renderer.setFullLook(false);
    _shown = NONE;
    const BookletCamera camera(one->getGrid(), {});
    BookletFrame frame = addMargin(camera.findFrame(*one));
    const double pixels = std::min(LARGEST_PLATE / frame.getSize().x, PART_PITCH * PART_DENSITY);
    const glm::ivec2 size = roundToPixels(frame, pixels);
    return encode(*_renderer.drawTransparent(camera, frame, size), PART_DENSITY, pixels);
}

BookletPicture BookletPictures::drawFinished(std::size_t chapter)
{
    // The cover and the last page show the same, which takes most of the time of a small booklet.
    if (chapter > 0) return drawWhole(chapter);
    if (!_finished) _finished = drawWhole(chapter);
    return *_finished;
}

BookletPictures::Whole BookletPictures::findWhole(std::size_t chapter) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const bool isSubmodel = chapter > 0;
    Whole whole{BookletCamera(own.model->getGrid(), {0, false, _front}), {}};
    whole.frame = addMargin(findWholeFrame(own, whole.camera));
    const glm::dvec2 largest = isSubmodel ? glm::dvec2(LARGEST_SUBMODEL) : glm::dvec2(LARGEST_WIDTH, LARGEST_HEIGHT);
    const glm::dvec2 fitting = largest / whole.frame.getSize();
    whole.pixels = std::min({fitting.x, fitting.y, isSubmodel ? PART_PITCH * PART_DENSITY : LARGEST_PITCH});
    whole.size = roundToPixels(whole.frame, whole.pixels);
    return whole;
}

BookletPicture BookletPictures::drawWhole(std::size_t chapter)
{
    show(chapter);
    const BookletChapter& own = _model.getChapters()[chapter];
    _renderer.setPlaced(own.model->getParts().size(), 0);
    _renderer.setBase(isOnPlate(own) ? _plate.get() : nullptr);
    _renderer.setFullLook(chapter == 0);
    const Whole whole = findWhole(chapter);
    return encode(*_renderer.drawTransparent(whole.camera, whole.frame, whole.size),
                  chapter > 0 ? PART_DENSITY : DENSITY, whole.pixels);
}

glm::dvec2 BookletPictures::measureFinished(std::size_t chapter) const
{
    return glm::dvec2(findWhole(chapter).size) / (chapter > 0 ? PART_DENSITY : DENSITY);
}

glm::dvec2 BookletPictures::measureStep(std::size_t chapter, std::size_t step) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& shown = own.steps[step];
    return {_scales[chapter].size.x, findFrame(own, shown, createCamera(own, shown)).getSize().y};
}

bool BookletPictures::showsAllParts(std::size_t chapter)
{
    constexpr double LEAST_SHARE = 0.25; // of the faces of a part towards the eye
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletCamera camera(own.model->getGrid(), {0, false, _front});
    return findHiddenParts(*own.model, own.plan->getOrder(), own.plan->getOrder(), camera.getToEye(), LEAST_SHARE)
        .empty();
}

BookletPicture BookletPictures::drawStep(std::size_t chapter, std::size_t step)
{
    show(chapter);
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& shown = own.steps[step];
    _renderer.setPlaced(shown.numPlaced, shown.numNew);
    _renderer.setBase(isOnPlate(own) ? _fadedPlate.get() : nullptr);
    _renderer.setFullLook(false);

    const BookletCamera camera = createCamera(own, shown);
    const double pixels = _scales[chapter].pixels;
    BookletFrame frame = findFrame(own, shown, camera);
    frame = widen(frame, _scales[chapter].size.x, frame);
    const glm::ivec2 size = roundToPixels(frame, pixels);
    const osg::ref_ptr<osg::Image> image = _renderer.draw(camera, frame, size);
    const std::span<const std::uint32_t> placed = std::span(own.plan->getOrder()).first(shown.numPlaced);
    NewPartOutline(NewPartMask::create(*own.model, placed, shown.numNew, camera, frame, size, NewPartOutline::MARGIN))
        .draw(*image);
    BookletPicture picture = encode(*image, DENSITY, pixels);
    const auto toPixels = [&](const glm::dvec2& place)
    { return glm::dvec2(place.x - frame.lowest.x, frame.highest.y - place.y) * pixels; };
    for (const BookletArrow& arrow : findArrows(own, shown, camera).getArrows())
        picture.arrows.push_back(
            {toPixels(arrow.tail), toPixels(arrow.tip), arrow.width * pixels, toPixels(arrow.letter)});
    return picture;
}

double BookletPictures::getAspect(std::size_t chapter) const
{
    return _scales[chapter].size.x / _scales[chapter].size.y;
}

} // namespace osgLego
