#include "Plot.h"

#include "BenchFiles.h"

#include <common/CompleteFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

/** A text as gnuplot takes it. */
std::string quoted(const std::string& text)
{
    std::string result = "'";
    for (const char character : text)
        result += character == '\'' ? "''" : std::string(1, character);
    return result + "'";
}

std::string formatFootnote(const BenchEnvironment& environment)
{
    return fmt::format("{}, GL {}\n{}, {} threads; commit {}, {}", environment.renderer, environment.version,
                       environment.processor, environment.numThreads, environment.commit, environment.date);
}

std::string joined(const std::set<double>& numbers)
{
    std::string text;
    for (const double number : numbers)
        text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
    return text;
}

std::set<double> collect(const Plot& plot, double std::pair<double, double>::*coordinate)
{
    std::set<double> values;
    for (const Plot::Curve& curve : plot.curves)
        for (const auto& point : curve.points)
            values.insert(point.*coordinate);
    return values;
}

/** Marks of a logarithmic axis: of few in every power of ten, as many as it takes. */
std::set<double> findMarks(double bottom, double top)
{
    constexpr std::size_t FEWEST = 4;
    const std::vector<std::vector<double>> candidates{
        {1.0}, {1.0, 2.0, 5.0}, {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}, {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0,
                                                                           2.2, 2.5, 2.8, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5,
                                                                           6.0, 6.5, 7.0, 7.5, 8.0, 8.5, 9.0, 9.5}};
    std::set<double> marks;
    for (const std::vector<double>& factors : candidates)
    {
        marks.clear();
        for (double exponent = std::floor(std::log10(bottom)); exponent <= std::log10(top); exponent += 1.0)
            for (const double factor : factors)
                if (const double mark = factor * std::pow(10.0, exponent); mark >= bottom && mark <= top)
                    marks.insert(mark);
        if (marks.size() >= FEWEST) break;
    }
    return marks;
}

/** Range and marks of both axes: every x that was measured has one. */
std::string formatAxes(const Plot& plot)
{
    constexpr double MARGIN = 1.2;
    const std::set<double> places = collect(plot, &std::pair<double, double>::first);
    const std::set<double> values = collect(plot, &std::pair<double, double>::second);
    const double bottom = *values.begin() / MARGIN;
    const double top = *values.rbegin() * MARGIN;
    return fmt::format("set logscale xy\nset xrange [{}:{}]\nset yrange [{}:{}]\nset xtics ({})\nset ytics ({})\n",
                       *places.begin() / MARGIN, *places.rbegin() * MARGIN, bottom, top, joined(places),
                       joined(findMarks(bottom, top)));
}

/** How curves look, in their order: no two alike, and none too pale for white paper. */
std::vector<std::string> formatStyles(const Plot& plot)
{
    constexpr std::array COLORS{"#0072b2", "#d55e00", "#009e73", "#c0508c", "#000000", "#7b3294", "#3fa0e0", "#a87800"};
    constexpr std::array DASHES{1, 4}; // solid; dashes and dots
    constexpr int VARIANT_DASH = 2;
    std::vector<std::string> styles;
    std::size_t number = 0;
    for (const Plot::Curve& curve : plot.curves)
    {
        if (!curve.isVariant) ++number;
        const std::size_t index = number > 0 ? number - 1 : 0;
        styles.push_back(fmt::format(
            "linewidth 2 linecolor rgb '{}' dashtype {} pointtype {}", COLORS[index % COLORS.size()],
            curve.isVariant ? VARIANT_DASH : DASHES[index / COLORS.size() % DASHES.size()], index % 13 + 1));
    }
    return styles;
}

std::string formatScript(const Plot& plot, const BenchEnvironment& environment, const std::string& fileName)
{
    std::string text =
        fmt::format("set terminal pngcairo noenhanced size 1200,800 font 'Sans,12'\n"
                    "set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n"
                    "set grid\nset key at screen 0.98,0.08 bottom right samplen 5 maxrows {}\nset bmargin {}\n{}",
                    quoted(fileName), quoted(plot.title), quoted(plot.xLabel), quoted(plot.yLabel),
                    (plot.curves.size() + 1) / 2, 8 + (plot.curves.size() + 1) / 2, formatAxes(plot));
    const std::string footnote = formatFootnote(environment);
    const auto end = footnote.find('\n');
    text +=
        fmt::format("set label 1 {} at screen 0.02,0.055 font ',9'\nset label 2 {} at screen 0.02,0.025 font ',9'\n",
                    quoted(footnote.substr(0, end)), quoted(footnote.substr(end + 1)));
    const std::vector<std::string> styles = formatStyles(plot);
    std::string curves;
    for (std::size_t index = 0; index < plot.curves.size(); ++index)
    {
        text += fmt::format("$curve{} << END\n", index);
        for (const auto& [x, y] : plot.curves[index].points)
            text += fmt::format("{} {}\n", x, y);
        text += "END\n";
        curves += fmt::format("{}$curve{} using 1:2 with linespoints {} title {}", curves.empty() ? "" : ", ", index,
                              styles[index], quoted(plot.curves[index].name));
    }
    return text + "plot " + curves + "\n";
}

/** @return why it did not work; empty when it did. */
std::string runGnuplot(const std::string& script)
{
    // What gnuplot says is its own to say; a script can't be wrong by what a user gave.
    std::FILE* pipe = popen("gnuplot", "w");
    if (!pipe) return "gnuplot can't be started";
    const bool isWritten = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
    return pclose(pipe) == 0 && isWritten ? std::string() : "gnuplot failed";
}

std::string formatCsv(const Plot& plot, const BenchEnvironment& environment)
{
    std::string text = fmt::format("# {}\n", plot.title);
    for (const auto& [name, value] : environment.toFields())
        text += fmt::format("# {}: {}\n", name, value);
    text += fmt::format("curve,\"{}\",\"{}\"\n", plot.xLabel, plot.yLabel);
    for (const Plot::Curve& curve : plot.curves)
        for (const auto& [x, y] : curve.points)
            text += fmt::format("\"{}\",{},{}\n", curve.name, x, y);
    return text;
}

} // namespace

Plot::Curve& Plot::getCurve(const std::string& name)
{
    const auto place =
        std::find_if(curves.begin(), curves.end(), [&name](const Curve& curve) { return curve.name == name; });
    return place != curves.end() ? *place : curves.emplace_back(Curve{name, {}, false});
}

void checkPlotting()
{
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
        throw std::runtime_error("plots need gnuplot, which is not there (Debian: gnuplot-nox)");
}

void writePlot(const Plot& plot, const BenchEnvironment& environment, const std::string& folder,
               const std::string& name)
{
    Plot shown = plot;
    std::erase_if(shown.curves, [](const Plot::Curve& curve) { return curve.points.empty(); });
    if (shown.curves.empty()) throw std::runtime_error("there is nothing to plot in '" + plot.title + "'");
    const std::string fileName = folder + "/" + name + ".png";
    const std::string why = writeCompleteFile(fileName, [&](const std::string& temporaryName)
                                              { return runGnuplot(formatScript(shown, environment, temporaryName)); });
    if (!why.empty()) throw std::runtime_error("can't write '" + fileName + "': " + why);
    writeTextFile(folder + "/" + name + ".csv", formatCsv(shown, environment));
}

} // namespace osgLego
