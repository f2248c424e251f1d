#include <osgLego/data/SparseBox.h>

#include <osgLego/GridLimits.h>

#include <HeapSize.h>

#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(SparseBox, HasTheValuesThatWereSetAndOthersByDefault)
{
    const glm::ivec3 size(37, 16, 50);
    std::mt19937 engine(3);
    SparseBox<int> box(size);
    std::map<std::tuple<int, int, int>, int> expected;
    const auto choose = [&engine](int end) { return static_cast<int>(engine() % static_cast<unsigned int>(end)); };
    for (int count = 1; count < 2000; ++count)
    {
        const glm::ivec3 place(choose(size.x), choose(size.y), choose(size.z));
        box.edit(place) = count;
        expected[{place.x, place.y, place.z}] = count;
    }
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
            {
                const auto found = expected.find({x, y, z});
                ASSERT_EQ(box.get({x, y, z}), found == expected.end() ? 0 : found->second) << x << " " << y << " " << z;
            }
}

TEST(SparseBox, TakesMemoryForPagesWithValuesAlone)
{
    const glm::ivec3 size = GridLimits::getLargest(2);
    const std::size_t before = getHeapSize();
    SparseBox<double> box(size);
    EXPECT_EQ(box.getNumPages(), 0u);
    for (const glm::ivec3& place : {glm::ivec3(0), size - 1, glm::ivec3(15), glm::ivec3(16, 15, 15)})
        box.edit(place) = 1.0;
    EXPECT_EQ(box.getNumPages(), 3u);
    EXPECT_LT(getHeapSize() - before, HEAP_OF_FEW_BRICKS);
}

} // namespace

} // namespace osgLego::test
