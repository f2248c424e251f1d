#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace osgLego
{

/** A set of cells of a window, with one bit for each cell. */
template <std::size_t NUM_WORDS>
struct CellSet
{
    static constexpr int CAPACITY = static_cast<int>(NUM_WORDS) * 64;

    std::array<std::uint64_t, NUM_WORDS> words{};

    void add(int cell) { words[static_cast<std::size_t>(cell) / 64] |= std::uint64_t(1) << (cell % 64); }
    bool contains(int cell) const { return (words[static_cast<std::size_t>(cell) / 64] >> (cell % 64) & 1) != 0; }

    bool isEmpty() const
    {
        std::uint64_t all = 0;
        for (const std::uint64_t word : words)
            all |= word;
        return all == 0;
    }
    /** The least cell; the set must not be empty. */
    int getFirst() const
    {
        std::size_t word = 0;
        while (words[word] == 0)
            ++word;
        return static_cast<int>(word) * 64 + std::countr_zero(words[word]);
    }
    bool includes(const CellSet& other) const
    {
        std::uint64_t missing = 0;
        for (std::size_t i = 0; i < NUM_WORDS; ++i)
            missing |= other.words[i] & ~words[i];
        return missing == 0;
    }
    CellSet& operator|=(const CellSet& other)
    {
        for (std::size_t i = 0; i < NUM_WORDS; ++i)
            words[i] |= other.words[i];
        return *this;
    }
    CellSet without(const CellSet& other) const
    {
        CellSet rest;
        for (std::size_t i = 0; i < NUM_WORDS; ++i)
            rest.words[i] = words[i] & ~other.words[i];
        return rest;
    }
    std::uint64_t getHash() const
    {
        std::uint64_t hash = 0;
        for (const std::uint64_t word : words)
        {
            hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 29;
        }
        return hash;
    }
    template <typename Visit>
    void visit(Visit visitCell) const
    {
        for (std::size_t i = 0; i < NUM_WORDS; ++i)
            for (std::uint64_t word = words[i]; word != 0; word &= word - 1)
                visitCell(static_cast<int>(i) * 64 + std::countr_zero(word));
    }

    bool operator==(const CellSet&) const = default;
};

} // namespace osgLego
