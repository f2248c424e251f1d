#pragma once

#include <exception>
#include <string>
#include <utility>

namespace osgLego
{

/** Thrown while a model is chosen, with a sentence for the user; an empty one if the choice was cancelled. */
struct DesignFailure : std::exception
{
    explicit DesignFailure(std::string message) : error(std::move(message)) {}
    const char* what() const noexcept override { return error.c_str(); }

    std::string error;
};

} // namespace osgLego
