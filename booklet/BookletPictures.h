#pragma once

#include "BookletCamera.h"
#include "BookletModel.h"
#include "BookletPicture.h"
#include "BookletRenderer.h"
#include "StepFrames.h"

#include <cstddef>
#include <optional>
#include <span>

namespace osgLego
{

/** Draws the pictures of a booklet with this project's renderer. One thread. */
class BookletPictures : public BookletPictureSource
{
public:
    /** The model and the renderer must outlive this object.
     * @param front the view of the finished model, and of steps without turns. */
    BookletPictures(const BookletModel& model, BookletRenderer& renderer, const BuildingView& front = {});

    void setSection(std::size_t chapter, std::span<const BookletBlock> blocks) override;
    BookletPicture drawKind(std::size_t kind) override;
    BookletPicture drawBasePlate() override;
    BookletPicture drawFinished(std::size_t chapter) override;
    BookletPicture drawPlace(std::size_t chapter, std::span<const BookletBlock> blocks) override;
    glm::dvec2 measureFinished(std::size_t chapter) const override;
    glm::dvec2 measureStep(std::size_t chapter, std::size_t step) const override;
    bool replacesSteps(std::size_t chapter) override;
    BookletPicture drawStep(std::size_t chapter, std::size_t step) override;
    double getAspect(std::size_t chapter) const override;

private:
    void show(std::size_t chapter);
    /** How the finished model or a submodel is drawn. */
    struct Whole
    {
        BookletCamera camera;
        BookletFrame frame;
        glm::ivec2 size{0};  // pixels
        double pixels = 0.0; // per pitch
    };

    Whole findWhole(std::size_t chapter) const;
    BookletPicture drawWhole(std::size_t chapter);

    const BookletModel& _model;
    BookletRenderer& _renderer;
    BuildingView _front;
    osg::ref_ptr<const BrickModel> _plate;      // null without a base plate
    osg::ref_ptr<const BrickModel> _fadedPlate; // likewise
    StepFrames _frames;
    std::size_t _shown;                      // the chapter that the renderer shows
    std::optional<BookletPicture> _finished; // the model
};

} // namespace osgLego
