#include <common/PictureFile.h>

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

using Bytes = std::vector<unsigned char>;

/** A file in memory, for the writers that only write to files. */
class MemoryFile
{
public:
    MemoryFile() : _descriptor(memfd_create("picture", MFD_CLOEXEC)) {}
    ~MemoryFile()
    {
        if (_descriptor >= 0) close(_descriptor);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    bool isOpen() const { return _descriptor >= 0; }
    std::string getName() const { return "/proc/self/fd/" + std::to_string(_descriptor); }
    /** @return false with errno if this fails. */
    bool read(Bytes& bytes) const
    {
        struct stat file = {};
        if (fstat(_descriptor, &file) != 0) return false;
        bytes.resize(static_cast<std::size_t>(file.st_size));
        for (std::size_t done = 0; done < bytes.size();)
        {
            const ssize_t count =
                pread(_descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
            if (count <= 0) return false;
            done += static_cast<std::size_t>(count);
        }
        return true;
    }

private:
    int _descriptor;
};

std::string encodeTo(OIIO::ImageOutput& output, const std::string& name, const OIIO::ImageBuf& picture)
{
    if (!output.open(name, picture.spec()) || !picture.write(&output))
        return output.has_error() ? output.geterror() : picture.geterror();
    return output.close() ? std::string() : output.geterror();
}

/** Whether a file can be read in a format: some writers ignore that writing fails. */
bool isWhole(const std::string& name, const std::string& format, const OIIO::ImageSpec& written)
{
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    if (!input || !input->open(name, spec) || spec.width != written.width || spec.height != written.height)
        return false;
    Bytes pixels(spec.image_bytes());
    return input->read_image(0, 0, 0, -1, spec.format, pixels.data());
}

/** @return the reason if a picture can't be encoded, or nothing. */
std::string encode(const std::string& fileName, const OIIO::ImageBuf& picture, Bytes& bytes)
{
    OIIO::Filesystem::IOVecOutput stream(bytes); // outlives the output, which may write to it until its end
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(fileName);
    if (!output) return OIIO::geterror();
    if (output->supports("ioproxy"))
    {
        output->set_ioproxy(&stream);
        return encodeTo(*output, fileName, picture);
    }
    const MemoryFile memory;
    if (!memory.isOpen()) return std::strerror(errno);
    std::string why = encodeTo(*output, memory.getName(), picture);
    if (why.empty() && !memory.read(bytes)) why = std::strerror(errno);
    if (why.empty() && !bytes.empty() && !isWhole(memory.getName(), output->format_name(), picture.spec()))
        why = "it can't be read back; there may not be enough memory for it";
    return why;
}

} // namespace

std::string writePictureFile(const std::string& fileName, const OIIO::ImageBuf& picture)
{
    Bytes bytes;
    if (std::string why = encode(fileName, picture, bytes); !why.empty()) return why;
    if (bytes.empty())
        return "its format stores no picture; expected .png, .tif, .exr or another that OpenImageIO supports";
    return writeCompleteFile(fileName,
                             [&bytes](std::ostream& stream)
                             {
                                 stream.write(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<std::streamsize>(bytes.size()));
                                 return std::string();
                             });
}

} // namespace osgLego
