#include "BenchFiles.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace osgLego
{

void checkPlace(const std::string& fileName)
{
    if (fileName.empty()) return;
    if (const std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty())
        throw std::runtime_error("can't write '" + fileName + "': " + obstacle);
}

void writeTextFile(const std::string& fileName, const std::string& text)
{
    const std::string why = writeCompleteFile(fileName,
                                              [&text](const std::string& temporaryName)
                                              {
                                                  std::ofstream file(temporaryName, std::ios::binary);
                                                  file << text;
                                                  file.close();
                                                  return file ? std::string() : std::string(std::strerror(errno));
                                              });
    if (!why.empty()) throw std::runtime_error("can't write '" + fileName + "': " + why);
}

} // namespace osgLego
