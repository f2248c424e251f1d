#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <osgLego/BrickModel.h>

// What the harnesses share. A harness is the function of libFuzzer's interface, in a source of its own:
//
//     extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
//
// It reads an input as a user's file and requires of the result that which holds for every input.

namespace osgLego::fuzz
{

/** Throws, which stops libFuzzer and fails the replay of the corpus, unless a property holds. */
void require(bool holds, const std::string& property);

/** The input as text. */
std::string_view toText(const std::uint8_t* data, std::size_t size);

/** Require that every brick of a model is in the grid and in a cell of its own, and that parts cover exactly the
 * bricks. */
void requirePossible(const BrickModel& model);

} // namespace osgLego::fuzz
