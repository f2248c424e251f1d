#pragma once

#include "GlLedger.h"

#include <cstddef>

namespace osgLego
{

/** Sees the GL functions that this program and its libraries call, by having functions of the same names that call on.
 *
 * Those are found before the renderer's own, by the linker and by OpenSceneGraph, which looks for extensions by name.
 * One thread. */
class GlWatch
{
public:
    /** How often there was a wait for what the renderer has to say since the program started: results of queries,
     * buffers and pictures that are read or mapped, fences, glFinish. */
    static std::size_t countWaits();

    /** Have it noted from now on what GL makes and deletes; null: no more. */
    static void setLedger(GlLedger* ledger);
};

} // namespace osgLego
