#pragma once

#include <osgLego/LegoSettings.h>

#include <string>

#include <gtest/gtest.h>

namespace osgLego::test
{

/** A GL test that runs twice: with the passes, and with the default device, which on a software renderer is the CPU.
 * @tparam Base a class derived from GlTest. */
template <typename Base>
class OnDevices : public Base, public ::testing::WithParamInterface<const char*>
{
protected:
    /** Parse settings that don't name a device. */
    LegoSettings parseSettings(const std::string& text) const
    {
        return Base::parseSettings(text + ",device=" + this->GetParam());
    }
};

inline std::string nameOfDevice(const ::testing::TestParamInfo<const char*>& device)
{
    return device.param;
}

/** Instantiates the tests of a class derived from OnDevices. */
#define INSTANTIATE_ON_DEVICES(name)                                                                                   \
    INSTANTIATE_TEST_SUITE_P(Devices, name, ::testing::Values("gpu", "auto"), nameOfDevice)

} // namespace osgLego::test
