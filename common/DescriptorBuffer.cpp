#include <common/DescriptorBuffer.h>

#include <cerrno>

#include <unistd.h>

namespace osgLego
{

DescriptorBuffer::DescriptorBuffer(int descriptor) : _descriptor(descriptor), _bytes()
{
    setp(_bytes.data(), _bytes.data() + _bytes.size());
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type character)
{
    if (!writeAll()) return traits_type::eof();
    if (!traits_type::eq_int_type(character, traits_type::eof())) sputc(traits_type::to_char_type(character));
    return traits_type::not_eof(character);
}

int DescriptorBuffer::sync()
{
    return writeAll() ? 0 : -1;
}

bool DescriptorBuffer::writeAll()
{
    const char* next = pbase();
    while (_error == 0 && next != pptr())
    {
        // May write a part, for example if the disk is full, and then fail.
        const ssize_t count = write(_descriptor, next, static_cast<std::size_t>(pptr() - next));
        if (count >= 0)
            next += count;
        else if (errno != EINTR)
            _error = errno;
    }
    setp(_bytes.data(), _bytes.data() + _bytes.size());
    return _error == 0;
}

} // namespace osgLego
