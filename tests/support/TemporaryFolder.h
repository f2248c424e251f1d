#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace osgLego::test
{

/** A test with its own empty folder, which is removed afterwards. */
class TemporaryFolderTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        _folder = std::filesystem::temp_directory_path() / ("osglego-" + std::to_string(getpid()) + "-" + info->name());
        std::filesystem::create_directories(_folder);
    }

    void TearDown() override { std::filesystem::remove_all(_folder); }

    std::string pathOf(const std::string& name) const { return (_folder / name).string(); }

    /** The bytes of a file, given its path. */
    static std::string contentsOf(const std::string& fileName)
    {
        std::ostringstream contents;
        contents << std::ifstream(fileName, std::ios::binary).rdbuf();
        return contents.str();
    }

    std::size_t countFiles() const
    {
        using std::filesystem::directory_iterator;
        return static_cast<std::size_t>(std::distance(directory_iterator(_folder), directory_iterator()));
    }

    std::filesystem::path _folder;
};

} // namespace osgLego::test
