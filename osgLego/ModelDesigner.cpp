#include <osgLego/ModelDesigner.h>

#include <osgLego/design/DesignFailure.h>
#include <osgLego/design/DesignSearch.h>

namespace osgLego
{

namespace
{

std::string check(const DesignOptions& options)
{
    const std::size_t numParts = options.numParts.value_or(DesignOptions::USUAL_PARTS);
    if (numParts < 1 || numParts > DesignOptions::MOST_PARTS)
        return "the number of parts is out of range; expected 1 to " + std::to_string(DesignOptions::MOST_PARTS);
    // Also false for a length that is not a number.
    const bool isLengthGood =
        !options.length || (*options.length >= DesignOptions::SHORTEST && *options.length <= DesignOptions::LONGEST);
    if (!isLengthGood) return "the length is out of range; expected 8 to 8192 millimetres";
    return options.view.isValid() ? "" : "the view is out of range; expected 10 to 80 degrees of elevation";
}

} // namespace

std::optional<ModelDesign> designModel(const osg::Node& node, const DesignOptions& options, std::string& error)
{
    error = check(options);
    if (!error.empty()) return std::nullopt;
    try
    {
        return DesignSearch(node, options).run();
    }
    catch (const DesignFailure& failure)
    {
        error = failure.error;
        return std::nullopt;
    }
}

} // namespace osgLego
