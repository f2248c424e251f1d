#pragma once

#include <array>
#include <cstddef>
#include <streambuf>

namespace osgLego
{

/** The buffer of a stream that writes to a file descriptor and remembers why that failed. Does not close the
 * descriptor. Flush the stream at the end. Not thread-safe. */
class DescriptorBuffer : public std::streambuf
{
public:
    explicit DescriptorBuffer(int descriptor);

    /** The errno of the first failure, after which nothing more is written; 0 if there was none. */
    int getError() const { return _error; }

protected:
    int_type overflow(int_type character) override;
    int sync() override;

private:
    bool writeAll();

    int _descriptor;
    int _error = 0;
    std::array<char, std::size_t(1) << 16> _bytes;
};

} // namespace osgLego
