// Which of several devices renders.

#include "device/context.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

DeviceInfo named(const std::string& name, bool isCpu, bool hasCompiler = true) {
    DeviceInfo d;
    d.name = name;
    d.platformName = "Platform";
    d.isCpu = isCpu;
    d.hasCompiler = hasCompiler;
    return d;
}

std::string errorOf(const std::vector<DeviceInfo>& list, const std::string& wanted) {
    try {
        return "chose " + chooseDevice(list, wanted).name;
    } catch (const DeviceError& error) { return error.what(); }
}

TEST(DeviceChoice, PrefersAGpuThenAProcessorAndNothingWithoutACompiler) {
    const DeviceInfo mute = named("mute", true, false), muteGpu = named("mute gpu", false, false), cpu = named("cpu", true),
                     gpu = named("gpu", false);
    EXPECT_EQ(chooseDevice({mute, cpu, muteGpu, gpu}, "").name, "gpu");
    EXPECT_EQ(chooseDevice({muteGpu, mute, cpu}, "").name, "cpu");
    EXPECT_THAT(errorOf({muteGpu, mute}, ""),
                AllOf(HasSubstr("no OpenCL device has a compiler"), HasSubstr("0  mute gpu (Platform), without a compiler")));
    EXPECT_THAT(errorOf({}, ""), HasSubstr("no OpenCL device found"));
}

TEST(DeviceChoice, GoesByNumberOrName) {
    std::vector<DeviceInfo> list{named("Alpha", true), named("Beta 2", false)};
    EXPECT_EQ(chooseDevice(list, "0").name, "Alpha");
    EXPECT_EQ(chooseDevice(list, "beta").name, "Beta 2");
    EXPECT_EQ(chooseDevice(list, "2").name, "Beta 2") << "no such number, but a part of a name";
    EXPECT_EQ(chooseDevice(list, "platform").name, "Alpha");
    list[1].version = "OpenCL 3.0 PoCL";
    EXPECT_EQ(chooseDevice(list, "pocl").name, "Beta 2") << "as its implementation is called";
    EXPECT_THAT(errorOf(list, "gamma"),
                AllOf(HasSubstr("no OpenCL device is called \"gamma\""), HasSubstr("\n  0  Alpha (Platform)\n  1  Beta 2 (Platform)")));
}

TEST(DeviceChoice, TakesSeveral) {
    std::vector<DeviceInfo> list{named("Alpha", true), named("Mute", true, false), named("Beta, 2", false)};
    for (size_t i = 0; i < list.size(); ++i) list[i].id = reinterpret_cast<cl_device_id>(i + 1);
    using testing::ElementsAre;
    EXPECT_THAT(chooseDevices(list, "all"), ElementsAre("0", "2"));
    EXPECT_THAT(chooseDevices(list, "beta,0"), ElementsAre("2", "0"));
    EXPECT_THAT(chooseDevices(list, "alpha"), ElementsAre("alpha"));
    EXPECT_THAT(chooseDevices(list, ""), ElementsAre(""));
    for (const char* gap : {",", "alpha,", ",beta"})
        EXPECT_THAT([&] { chooseDevices(list, gap); }, testing::ThrowsMessage<DeviceError>(HasSubstr("a name is empty"))) << gap;
    const auto errorOfSeveral = [&](const std::vector<DeviceInfo>& devices, const char* wanted) -> std::string {
        try {
            return std::to_string(chooseDevices(devices, wanted).size());
        } catch (const DeviceError& error) { return error.what(); }
    };
    EXPECT_THAT(errorOfSeveral(list, "0,alpha"), HasSubstr("--device 0,alpha: \"alpha\" is device 0 again"));
    EXPECT_THAT(errorOfSeveral(list, "0,gamma"), HasSubstr("no OpenCL device is called \"gamma\""));
    EXPECT_THAT(errorOfSeveral({list[1]}, "all"), HasSubstr("no OpenCL device has a compiler"));
}

}  // namespace
}  // namespace eikonal
