#pragma once

#include <array>
#include <cstddef>

namespace osgLego
{

/** Cut a triangle at the midpoints of its edges that are too long, into two, three or four triangles (the paper,
 * Algorithm 2 and Figure 3). The counterpart on the CPU of shaders/subdivision/subdivision.geom: the same triangles, in
 * the same order.
 *
 * @param corners vertices of a type with functions midpoint(a, b) and squaredLength(a, b).
 * @param use called with the corners of each part; once, with the triangle itself, if no edge is too long.
 * @return whether an edge was too long. */
template <typename Vertex, typename Number, typename Use>
bool cutLongEdges(const std::array<Vertex, 3>& corners, Number squaredLimit, const Use& use)
{
    std::array<bool, 3> isLong{};
    int count = 0;
    std::size_t lastLong = 0;
    std::size_t lastShort = 0;
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
        isLong[edge] = squaredLength(corners[edge], corners[(edge + 1) % 3]) > squaredLimit;
        count += isLong[edge] ? 1 : 0;
        (isLong[edge] ? lastLong : lastShort) = edge;
    }
    // A single long edge is ab; a single short one is ca.
    const std::size_t first = count == 1 ? lastLong : count == 2 ? (lastShort + 1) % 3 : 0;
    const Vertex& a = corners[first];
    const Vertex& b = corners[(first + 1) % 3];
    const Vertex& c = corners[(first + 2) % 3];
    const auto add = [&use](const Vertex& p, const Vertex& q, const Vertex& r) { use(std::array<Vertex, 3>{p, q, r}); };
    if (count == 0)
    {
        add(a, b, c);
        return false;
    }

    const Vertex ab = midpoint(a, b);
    if (count == 1)
    {
        add(a, ab, c);
        add(ab, b, c);
        return true;
    }
    const Vertex bc = midpoint(b, c);
    if (count == 3)
    {
        const Vertex ca = midpoint(c, a);
        add(a, ab, ca);
        add(ab, b, bc);
        add(ca, bc, c);
        add(ab, bc, ca);
        return true;
    }
    add(ab, b, bc);
    // The remaining quadrilateral is cut along its shorter diagonal.
    const bool isFromA = squaredLength(a, bc) <= squaredLength(ab, c);
    add(a, ab, isFromA ? bc : c);
    add(isFromA ? a : ab, bc, c);
    return true;
}

/** The treatment of a part of a triangle by cutToSize(). */
enum class PartUse
{
    DROPPED,
    KEPT,
    CUT //!< cut again, or kept if no edge is too long
};

/** Cut a triangle repeatedly, as cutLongEdges() does, but only the parts that `decide` selects.
 * @param decide returns the PartUse of a part, given its corners.
 * @param keep called with the corners of each part that is kept. */
template <typename Vertex, typename Number, typename Decide, typename Keep>
void cutToSize(const std::array<Vertex, 3>& corners, Number squaredLimit, const Decide& decide, const Keep& keep)
{
    const PartUse use = decide(corners);
    if (use == PartUse::DROPPED) return;
    if (use == PartUse::KEPT)
    {
        keep(corners);
        return;
    }
    std::array<std::array<Vertex, 3>, 4> parts;
    std::size_t count = 0;
    const auto add = [&](const std::array<Vertex, 3>& part) { parts[count++] = part; };
    if (!cutLongEdges(corners, squaredLimit, add))
    {
        keep(corners);
        return;
    }
    for (std::size_t part = 0; part < count; ++part)
        cutToSize(parts[part], squaredLimit, decide, keep);
}

} // namespace osgLego
