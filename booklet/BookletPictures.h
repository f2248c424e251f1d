#pragma once

#include "ArrowPlacement.h"
#include "BookletCamera.h"
#include "BookletModel.h"
#include "BookletPicture.h"
#include "BookletRenderer.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace osgLego
{

/** Draws the pictures of a booklet with this project's renderer. One thread. */
class BookletPictures : public BookletPictureSource
{
public:
    /** The model and the renderer must outlive this object.
     * @param front the view of the finished model, and of steps without turns. */
    BookletPictures(const BookletModel& model, BookletRenderer& renderer, const BuildingView& front = {});

    BookletPicture drawKind(std::size_t kind) override;
    BookletPicture drawBasePlate() override;
    BookletPicture drawFinished(std::size_t chapter) override;
    glm::dvec2 measureFinished(std::size_t chapter) const override;
    glm::dvec2 measureStep(std::size_t chapter, std::size_t step) const override;
    bool showsAllParts(std::size_t chapter) override;
    BookletPicture drawStep(std::size_t chapter, std::size_t step) override;
    double getAspect(std::size_t chapter) const override;

private:
    /** The pictures of a chapter: their scale, and their size in pitches. */
    struct Scale
    {
        double pixels = 0.0; //!< per pitch
        glm::dvec2 size{0.0};
    };

    bool isOnPlate(const BookletChapter& chapter) const;
    BookletFrame findWholeFrame(const BookletChapter& chapter, const BookletCamera& camera) const;
    BookletFrame findPlacedFrame(const BookletChapter& chapter, const BookletStep& step,
                                 const BookletCamera& camera) const;
    BookletFrame findFrame(const BookletChapter& chapter, const BookletStep& step, const BookletCamera& camera) const;
    const ArrowPlacement& findArrows(const BookletChapter& chapter, const BookletStep& step,
                                     const BookletCamera& camera) const;
    static std::vector<std::uint32_t> findHidden(const BookletChapter& chapter, const BookletStep& step,
                                                 const BookletCamera& camera);
    Scale findScale(const BookletChapter& chapter) const;
    BookletCamera createCamera(const BookletChapter& chapter, const BookletStep& step) const;
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
    osg::ref_ptr<const BrickModel> _plate;                        // null without a base plate
    osg::ref_ptr<const BrickModel> _fadedPlate;                   // likewise
    mutable std::map<const BookletStep*, ArrowPlacement> _arrows; // of steps that are known
    std::vector<Scale> _scales;
    std::size_t _shown;                      // the chapter that the renderer shows
    std::optional<BookletPicture> _finished; // the model
};

} // namespace osgLego
