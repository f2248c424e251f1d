#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/ModelDesigner.h>

#include <vector>

namespace osgLego
{

/** The settings of the models that designModel() compares: those of its options, and combinations of all others that
 * may be chosen. One thread creates it; several may read it at once. */
class DesignSettings
{
public:
    /** Throws DesignFailure if the options ask for settings that can't be read, that exclude each other, or that give
     * no parts. */
    explicit DesignSettings(const DesignOptions& options);

    /** At least one, each with parts. If canChooseSize(), their resolutions mean nothing. */
    const std::vector<LegoSettings>& getAll() const { return _all; }
    /** Whether the number of parts limits the size, rather than the options giving it. */
    bool canChooseSize() const { return _canChooseSize; }
    /** Whether the options ask for pieces to be joined, also where a base plate joins them. */
    bool isConnectionGiven() const { return _isConnectionGiven; }
    /** Whether the options let pieces be joined, as models are that are supported. */
    bool canJoin() const { return _canJoin; }

private:
    static bool determineSize(const DesignOptions& options);
    void listAll(const DesignOptions& options);

    std::vector<LegoSettings> _all;
    bool _canChooseSize = false;
    bool _isConnectionGiven = false;
    bool _canJoin = false;
};

} // namespace osgLego
