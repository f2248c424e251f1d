#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Calls a harness with each file of its corpus, and with mutations of it that are the same in every run. Without
// libFuzzer, so that every build repeats the inputs that once failed.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace osgLego::fuzz
{

namespace
{

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

std::vector<fs::path> listCorpus()
{
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(OSGLEGO_CORPUS))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Bytes readFile(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

/** @return the reason if the harness refuses the result of an input; otherwise empty. */
std::string run(const Bytes& input)
try
{
    LLVMFuzzerTestOneInput(input.data(), input.size());
    return {};
}
catch (const std::exception& exception)
{
    return exception.what();
}

/** Changes an input in a few places, as libFuzzer does. */
class Mutation
{
public:
    explicit Mutation(std::uint32_t seed) : _engine(seed) {}

    Bytes mutate(Bytes input)
    {
        for (std::size_t left = 1 + below(4); left > 0; --left)
            change(input);
        return input;
    }

private:
    std::size_t below(std::size_t count) { return _engine() % count; }

    void change(Bytes& input)
    {
        const auto place = static_cast<std::ptrdiff_t>(below(input.size() + 1));
        if (place == std::ssize(input))
        {
            input.push_back(static_cast<std::uint8_t>(below(256)));
            return;
        }
        const std::size_t length = std::min(1 + below(16), input.size() - static_cast<std::size_t>(place));
        const auto begin = input.begin() + place;
        const auto end = begin + static_cast<std::ptrdiff_t>(length);
        constexpr std::uint8_t INTERESTING[]{0, 1, 0x7f, 0x80, 0xff, '0', '-', '9'};
        switch (below(6))
        {
        case 0:
            *begin = static_cast<std::uint8_t>(*begin ^ 1 << below(8));
            break;
        case 1:
            *begin = static_cast<std::uint8_t>(below(256));
            break;
        case 2:
            std::fill(begin, end, INTERESTING[below(std::size(INTERESTING))]);
            break;
        case 3:
            input.erase(begin, end);
            break;
        case 4:
            repeat(input, begin, end);
            break;
        default:
            input.resize(static_cast<std::size_t>(place));
        }
    }

    static void repeat(Bytes& input, Bytes::iterator begin, Bytes::iterator end)
    {
        const Bytes copy(begin, end);
        input.insert(end, copy.begin(), copy.end());
    }

    std::mt19937 _engine;
};

class Corpus : public ::testing::TestWithParam<fs::path>
{
};

TEST_P(Corpus, InputAndMutationsAreHandled)
{
    const Bytes input = readFile(GetParam());
    EXPECT_EQ(run(input), "");
    for (std::uint32_t seed = 0; seed < OSGLEGO_MUTATIONS; ++seed)
        EXPECT_EQ(run(Mutation(seed).mutate(input)), "") << "mutation " << seed;
}

std::string nameOf(const ::testing::TestParamInfo<fs::path>& info)
{
    std::string name = info.param.filename().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(OSGLEGO_HARNESS, Corpus, ::testing::ValuesIn(listCorpus()), nameOf);

} // namespace

} // namespace osgLego::fuzz
