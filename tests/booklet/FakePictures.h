#pragma once

#include <booklet/BookletPicture.h>

#include <string>

namespace osgLego::test
{

/** Pictures without content, in which an arrow leads down to each submodel. */
class FakePictures : public BookletPictureSource
{
public:
    explicit FakePictures(const BookletModel& model) : _model(model) {}

    void setSection(std::size_t, std::span<const BookletBlock>) override {}
    BookletPicture drawPlace(std::size_t, std::span<const BookletBlock>) override { return create("place"); }
    BookletPicture drawKind(std::size_t kind) override { return create("kind " + std::to_string(kind)); }
    BookletPicture drawBasePlate() override { return create("plate"); }
    BookletPicture drawFinished(std::size_t chapter) override { return create("finished " + std::to_string(chapter)); }
    glm::dvec2 measureFinished(std::size_t) const override { return {300, 200}; }
    glm::dvec2 measureStep(std::size_t, std::size_t) const override { return {30, 20}; }
    bool replacesSteps(std::size_t) override { return showsAll; }
    BookletPicture drawStep(std::size_t chapter, std::size_t step) override
    {
        BookletPicture picture = create("step " + std::to_string(chapter) + "-" + std::to_string(step));
        for (std::size_t index = 0; index < _model.getChapters()[chapter].steps[step].submodels.size(); ++index)
        {
            const double x = 100.0 * static_cast<double>(index + 1);
            picture.arrows.push_back({{x, 40.0}, {x, 100.0}, 10.0, {x, 35.0}});
        }
        return picture;
    }
    double getAspect(std::size_t) const override { return 1.5; }

    bool showsAll = false;

private:
    static BookletPicture create(const std::string& bytes)
    {
        BookletPicture picture;
        picture.bytes = bytes;
        picture.mediaType = "image/png";
        picture.width = 300;
        picture.height = 200;
        return picture;
    }

    const BookletModel& _model;
};

} // namespace osgLego::test
