#include "BookletPictures.h"

#include "BookletFailure.h"
#include "HiddenParts.h"
#include "NewPartMask.h"
#include "NewPartOutline.h"
#include "TableGrid.h"

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

constexpr double DENSITY = 1.5;               // pixels of pictures per pixel of CSS
constexpr double LARGEST_WIDTH = 1200;        // pixels
constexpr double LARGEST_HEIGHT = 1050;       // pixels
constexpr double LARGEST_PITCH = 90;          // pixels; larger bricks would look odd beside those of the parts lists
constexpr double PART_DENSITY = 2.0;          // pictures of parts are small, and printed as large
constexpr double PART_PITCH = 20.0;           // pixels of CSS
constexpr double LARGEST_PLATE = 333;         // pixels of the width of a base plate in lists
constexpr double MARGIN = 0.15;               // pitches around a model, for outlines and rounding
constexpr double LARGEST_SUBMODEL = 600;      // pixels along each side of a submodel in lists
constexpr double FADING = 2.5;                // pitches at the lower edge of pictures that are cut there
constexpr glm::dvec2 LARGEST_PLACE{360, 210}; // pixels of the model in headers
constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();

BookletFrame addMargin(const BookletFrame& frame)
{
    return frame.addMargin(MARGIN);
}

/** Round the size of a frame up to whole pixels. */
glm::ivec2 roundToPixels(BookletFrame& frame, double pixels)
{
    const glm::ivec2 size = glm::max(glm::ivec2(glm::ceil(frame.getSize() * pixels - 1e-6)), glm::ivec2(1));
    frame.highest = frame.lowest + glm::dvec2(size) / pixels;
    return size;
}

/** The numbers of new parts of a step that it places one by one, if any, and of those that each submodel places. */
std::vector<std::size_t> countPartsOfGroups(const BookletModel& model, const BookletStep& step)
{
    std::vector<std::size_t> groups;
    if (step.numDirect > 0) groups.push_back(step.numDirect);
    for (const std::size_t submodel : step.submodels)
        groups.push_back(model.getChapters()[submodel].model->getParts().size());
    return groups;
}

/** Outline the new parts of a step in its picture, with lines between those of different groups: they would look like
 * one submodel. */
void drawOutlines(const BookletChapter& chapter, const BookletStep& step, const std::vector<std::size_t>& groups,
                  const BookletCamera& camera, const BookletFrame& frame, osg::Image& picture)
{
    const auto createOutline = [&](std::span<const std::uint32_t> placed, std::size_t numNew)
    {
        return NewPartOutline(NewPartMask::create(*chapter.model, placed, numNew, camera, frame,
                                                  {picture.s(), picture.t()}, NewPartOutline::MARGIN));
    };
    const std::span<const std::uint32_t> placed = std::span(chapter.plan->getOrder()).first(step.numPlaced);
    std::vector<NewPartOutline> outlines{createOutline(placed, step.numNew)};
    std::vector<std::uint32_t> groupLast(placed.begin(), placed.end());
    for (std::size_t group = 0; group + 1 < groups.size(); ++group)
    {
        const auto first = groupLast.end() - static_cast<std::ptrdiff_t>(step.numNew);
        std::rotate(first, first + static_cast<std::ptrdiff_t>(groups[group]), groupLast.end());
        outlines.push_back(createOutline(groupLast, groups[group]));
    }
    const PixelColor color = NewPartOutline::chooseColor(outlines, picture);
    for (const NewPartOutline& outline : outlines)
        outline.draw(picture, color);
}

/** A file format, and its quality for OpenImageIO. */
struct PictureFormat
{
    const char* fileName;
    const char* mediaType;
    const char* compression;
};

// Browsers copy JPEG into PDF as it is, and store pictures in all other formats without losses there: the PDF of 370
// parts has 10 MB in place of 35. WebP has transparency, and a fifth of the bytes of PNG, but takes longer, and dark
// colours get blotches of other hues.
constexpr PictureFormat OPAQUE_FORMAT{"picture.jpg", "image/jpeg", "jpeg:88"};
constexpr PictureFormat TRANSPARENT_FORMAT{"picture.png", "image/png", "zip:6"};

BookletPicture encode(const osg::Image& image, double density, double pitch)
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
    encoded.pitch = pitch;
    return encoded;
}

osg::ref_ptr<const BuildingPlan> createPlanOfOnePart()
{
    std::vector<BuildingStep> steps(1);
    steps.front().parts = {0};
    return BuildingPlan::create(1, std::move(steps));
}

/** Let the lowest rows of a picture become white, to show that it goes on there. */
void fadeBottom(osg::Image& image, int numRows)
{
    constexpr int WHITE = 255;
    for (int row = 0; row < std::min(numRows, image.t()); ++row)
    {
        const std::span<unsigned char> bytes(image.data(0, static_cast<unsigned>(row)), image.getRowSizeInBytes());
        for (unsigned char& byte : bytes)
            byte = static_cast<unsigned char>(WHITE - (WHITE - byte) * row / numRows);
    }
}

/** @return null without a base plate. */
osg::ref_ptr<const BrickModel> createPlate(const BookletModel& model, bool isFaded)
{
    return model.getBasePlate() ? model.getBasePlate()->createModel(isFaded) : nullptr;
}

/** The squares of the table below the parts in place. */
osg::ref_ptr<osg::Node> createTable(const BookletChapter& chapter, const BookletStep& step)
{
    std::vector<Part> placed;
    for (const std::uint32_t part : std::span(chapter.plan->getOrder()).first(step.numPlaced))
        placed.push_back(chapter.model->getParts()[part]);
    return createTableGrid(chapter.model->getGrid(), placed, step.isUpsideDown);
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
    _model(model), _renderer(renderer), _front(front), _plate(createPlate(model, false)),
    _fadedPlate(createPlate(model, true)), _frames(model, _plate.get(), front), _shown(NONE)
{
}

void BookletPictures::setSection(std::size_t chapter, std::span<const BookletBlock> blocks)
{
    _frames.setSection(chapter, blocks);
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

BookletPicture BookletPictures::drawPlace(std::size_t chapter, std::span<const BookletBlock> blocks)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    // The parts of the section come last, so that all others are faded.
    std::vector<BuildingStep> steps(2);
    std::vector<bool> isMarked(own.model->getParts().size(), false);
    for (const BookletBlock& block : blocks)
    {
        if (block.chapter != chapter || block.isContents) continue;
        const BookletStep& step = own.steps[block.step];
        for (const std::uint32_t part : std::span(own.plan->getOrder()).first(step.numPlaced).last(step.numNew))
            isMarked[part] = true;
    }
    for (std::uint32_t part = 0; part < isMarked.size(); ++part)
        steps[isMarked[part] ? 1 : 0].parts.push_back(part);
    const std::size_t numMarked = steps[1].parts.size();
    std::erase_if(steps, [](const BuildingStep& step) { return step.parts.empty(); });
    _renderer.setModel(*own.model, *BuildingPlan::create(own.model->getParts().size(), std::move(steps)));
    _shown = NONE;
    _renderer.setPlaced(own.model->getParts().size(), numMarked);
    _renderer.setBase(nullptr);
    _renderer.setFullLook(false);
    const BookletCamera camera(own.model->getGrid(), {0, false, _front});
    BookletFrame frame = addMargin(camera.findFrame(*own.model));
    const glm::dvec2 fitting = LARGEST_PLACE / frame.getSize();
    const double pixels = std::min(fitting.x, fitting.y);
    const glm::ivec2 size = roundToPixels(frame, pixels);
    return encode(*_renderer.drawTransparent(camera, frame, size), DENSITY, pixels);
}

BookletPictures::Whole BookletPictures::findWhole(std::size_t chapter) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const bool isSubmodel = chapter > 0;
    Whole whole{BookletCamera(own.model->getGrid(), {0, false, _front}), {}};
    whole.frame = addMargin(_frames.findWhole(own, whole.camera));
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
    _renderer.setBase(_frames.isOnPlate(own) ? _plate.get() : nullptr);
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
    return _frames.findFrame(chapter, step).getSize();
}

bool BookletPictures::replacesSteps(std::size_t chapter)
{
    constexpr double LEAST_SHARE = 0.25; // of the faces of a part towards the eye
    const BookletChapter& own = _model.getChapters()[chapter];
    if (own.steps.size() == 1 && !own.steps.front().isTurned && _frames.findArrows(chapter, 0).getArrows().empty())
        return true;
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
    _renderer.setBase(_frames.isOnPlate(own) ? _fadedPlate.get() : nullptr,
                      shown.numPieces > 1 ? createTable(own, shown) : nullptr);
    _renderer.setFullLook(false);

    const BookletCamera camera = _frames.createCamera(own, shown);
    const double pixels = _frames.getScale(chapter).pixels;
    BookletFrame frame = _frames.findFrame(chapter, step);
    const glm::ivec2 size = roundToPixels(frame, pixels);
    const osg::ref_ptr<osg::Image> image = _renderer.draw(camera, frame, size);
    drawOutlines(own, shown, countPartsOfGroups(_model, shown), camera, frame, *image);
    if (_frames.isCut(chapter, step)) fadeBottom(*image, static_cast<int>(FADING * pixels));
    BookletPicture picture = encode(*image, DENSITY, pixels);
    const auto toPixels = [&](const glm::dvec2& place)
    { return glm::dvec2(place.x - frame.lowest.x, frame.highest.y - place.y) * pixels; };
    for (const BookletArrow& arrow : _frames.findArrows(chapter, step).getArrows())
        picture.arrows.push_back(
            {toPixels(arrow.tail), toPixels(arrow.tip), arrow.width * pixels, toPixels(arrow.letter)});
    return picture;
}

double BookletPictures::getAspect(std::size_t chapter) const
{
    const glm::dvec2& size = _frames.getScale(chapter).size;
    return size.x / size.y;
}

} // namespace osgLego
