#include "References.h"

#include <osglegocapture/CaptureFiles.h>
#include <osglegocapture/Comparison.h>
#include <osglegocapture/ExitCode.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>

namespace osgLego::test
{

namespace
{

namespace files = std::filesystem;

/* On the pinned renderer, one machine always draws the same bits. Another vendor's reciprocals change a few pixels by 1
 * to 3 levels; at a silhouette, they may give a pixel to another surface. */
constexpr double LEVEL = 1.0 / 255.0;
constexpr double NOISE = 3.0 * LEVEL;
constexpr long long MOST_STRAY_PIXELS = 2;
constexpr double MOST_MEAN_ERROR = 0.002 * LEVEL;

/** A picture and the reference closest to it. */
struct Comparison
{
    std::string name;
    files::path result;
    files::path reference; // empty: there is none
    std::string verdict;
    bool isAlike = false;
};

std::vector<files::path> findPictures(const files::path& folder)
{
    std::vector<files::path> pictures;
    if (files::is_directory(folder))
        for (const files::directory_entry& entry : files::directory_iterator(folder))
            if (entry.path().extension() == ".png") pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    if (pictures.empty())
        throw CaptureError(EXIT_BAD_INPUT, "there are no pictures to compare in '" + folder.string() + "'");
    return pictures;
}

std::vector<files::path> findReferences(const files::path& folder, const std::string& name)
{
    std::vector<files::path> references;
    for (const files::directory_entry& entry : files::directory_iterator(folder))
    {
        const std::string fileName = entry.path().filename().string();
        if (entry.path().extension() == ".png" && fileName.starts_with(name + ".")) references.push_back(entry.path());
    }
    std::sort(references.begin(), references.end());
    return references;
}

OIIO::ImageBuf readPicture(const files::path& path)
{
    OIIO::ImageBuf picture(path.string());
    if (!picture.read(0, 0, true, OIIO::TypeDesc::FLOAT))
        throw CaptureError(EXIT_BAD_INPUT, "can't read '" + path.string() + "': " + picture.geterror());
    return picture;
}

bool areOfOneSize(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b)
{
    return a.spec().width == b.spec().width && a.spec().height == b.spec().height;
}

/** Compare a picture with one reference. */
Comparison compare(const files::path& result, const files::path& reference, double& mean)
{
    Comparison comparison{result.stem().string(), result, reference, "another size", false};
    const OIIO::ImageBuf picture = readPicture(result);
    const OIIO::ImageBuf expected = readPicture(reference);
    mean = 1.0;
    if (!areOfOneSize(picture, expected)) return comparison;
    const PictureDifference difference = measureDifference(picture, expected, NOISE);
    mean = difference.mean;
    comparison.verdict = fmt::format(
        "mean error {:.4f} levels of 255 (at most {:.4f}), {} pixels off by more than 3 levels (at most {}), largest "
        "error {:.0f} levels at {}, {}",
        difference.mean / LEVEL, MOST_MEAN_ERROR / LEVEL, difference.pixels, MOST_STRAY_PIXELS,
        difference.largest / LEVEL, difference.column, difference.row);
    comparison.isAlike = difference.mean <= MOST_MEAN_ERROR && difference.pixels <= MOST_STRAY_PIXELS;
    return comparison;
}

/** Compare a picture with its references. @return the comparison with the reference of the least mean error. */
Comparison compare(const files::path& result, const std::vector<files::path>& references)
{
    Comparison nearest{result.stem().string(), result, {}, "there is no reference", false};
    double least = 2.0; // means are at most 1
    for (const files::path& path : references)
    {
        double mean = 0.0;
        const Comparison comparison = compare(result, path, mean);
        if (mean >= least) continue;
        least = mean;
        nearest = comparison;
    }
    return nearest;
}

/** Write the pictures of a row next to the page. @return the row. */
std::string addRow(const Comparison& comparison, const files::path& folder)
{
    std::string cells;
    const auto add = [&](const std::string& kind, const auto& write)
    {
        const std::string file = fmt::format("{}-{}.png", comparison.name, kind);
        write(folder / file);
        cells += fmt::format("<td><img src=\"{0}\" alt=\"{0}\"></td>", file);
    };
    const auto copyOf = [](const files::path& from)
    { return [&from](const files::path& to) { files::copy_file(from, to, files::copy_options::overwrite_existing); }; };
    if (comparison.reference.empty())
        cells += "<td></td>";
    else
        add("reference", copyOf(comparison.reference));
    add("result", copyOf(comparison.result));
    const auto writeDifference = [&](const files::path& to)
    {
        writePicture(to.string(),
                     createDifferencePicture(readPicture(comparison.result), readPicture(comparison.reference)));
    };
    if (!comparison.reference.empty() &&
        areOfOneSize(readPicture(comparison.result), readPicture(comparison.reference)))
        add("difference", writeDifference);
    return fmt::format("<tr><th colspan=\"3\">{}: {}</th></tr>\n<tr>{}</tr>\n", comparison.name, comparison.verdict,
                       cells);
}

void writePage(const std::string& page, const std::vector<Comparison>& failures)
{
    const files::path folder = files::path(page).parent_path();
    if (!folder.empty()) files::create_directories(folder);
    std::string rows;
    for (const Comparison& failure : failures)
        rows += addRow(failure, folder);
    writeText(page,
              [&](std::ostream& stream)
              {
                  stream << "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>Captures that "
                            "differ</title></head>\n<body>\n<table>\n<tr><th>reference</th><th>result</th>"
                            "<th>difference, five times as strong</th></tr>\n"
                         << rows << "</table>\n</body>\n</html>\n";
              });
}

} // namespace

int compareWithReferences(const std::string& referenceFolder, const std::string& folder, const std::string& page)
{
    std::vector<Comparison> failures;
    for (const files::path& picture : findPictures(folder))
    {
        const Comparison comparison = compare(picture, findReferences(referenceFolder, picture.stem().string()));
        fmt::print("{} {}: {}\n", comparison.isAlike ? "alike    " : "DIFFERENT", comparison.name, comparison.verdict);
        if (!comparison.isAlike) failures.push_back(comparison);
    }
    if (!failures.empty()) writePage(page, failures);
    return static_cast<int>(failures.size());
}

} // namespace osgLego::test
