#include "device/context.h"

#include "split.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace eikonal {

template <class T> static T deviceInfo(cl_device_id id, cl_device_info what) {
    T value{};
    check(clGetDeviceInfo(id, what, sizeof value, &value, nullptr), "querying a device");
    return value;
}

static std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\0' || std::isspace(static_cast<unsigned char>(text.back())))) text.pop_back();
    return text;
}

static std::string deviceText(cl_device_id id, cl_device_info what) {
    size_t size = 0;
    check(clGetDeviceInfo(id, what, 0, nullptr, &size), "querying a device");
    std::string text(size, '\0');
    check(clGetDeviceInfo(id, what, size, text.data(), nullptr), "querying a device");
    return trimmed(text);
}

static std::string platformText(cl_platform_id id, cl_platform_info what) {
    size_t size = 0;
    if (clGetPlatformInfo(id, what, 0, nullptr, &size) != CL_SUCCESS) return "?";
    std::string text(size, '\0');
    clGetPlatformInfo(id, what, size, text.data(), nullptr);
    return trimmed(text);
}

static DeviceInfo query(cl_platform_id platform, cl_device_id id) {
    DeviceInfo d;
    d.platform = platform;
    d.id = id;
    d.name = deviceText(id, CL_DEVICE_NAME);
    d.vendor = deviceText(id, CL_DEVICE_VENDOR);
    d.version = deviceText(id, CL_DEVICE_VERSION);
    d.driver = deviceText(id, CL_DRIVER_VERSION);
    d.platformName = platformText(platform, CL_PLATFORM_NAME);
    d.isCpu = deviceInfo<cl_device_type>(id, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_CPU;
    d.computeUnits = deviceInfo<cl_uint>(id, CL_DEVICE_MAX_COMPUTE_UNITS);
    d.memory = deviceInfo<cl_ulong>(id, CL_DEVICE_GLOBAL_MEM_SIZE);
    d.largestBuffer = deviceInfo<cl_ulong>(id, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
    d.largestGroup = deviceInfo<size_t>(id, CL_DEVICE_MAX_WORK_GROUP_SIZE);
    // Such an implementation reports scalars as its preferred vector width.
    d.widensGroups = deviceInfo<cl_uint>(id, CL_DEVICE_PREFERRED_VECTOR_WIDTH_FLOAT) == 1;
    d.hasCompiler = deviceInfo<cl_bool>(id, CL_DEVICE_COMPILER_AVAILABLE);
    return d;
}

/// A device that cannot be queried keeps its place in the list, and is only chosen if asked for.
static DeviceInfo describe(cl_platform_id platform, cl_device_id id) {
    try {
        return query(platform, id);
    } catch (const DeviceError& error) {
        DeviceInfo d;
        d.platform = platform;
        d.id = id;
        d.platformName = platformText(platform, CL_PLATFORM_NAME);
        d.name = fmt::format("a device that cannot be used: {}", error.what());
        d.hasCompiler = false;
        return d;
    }
}

std::vector<DeviceInfo> listDevices() {
    cl_uint count = 0;
    const cl_int status = clGetPlatformIDs(0, nullptr, &count);
    constexpr cl_int noPlatform = -1001;
    if (status == noPlatform || count == 0) return {};
    check(status, "looking for OpenCL platforms");
    std::vector<cl_platform_id> platforms(count);
    check(clGetPlatformIDs(count, platforms.data(), nullptr), "looking for OpenCL platforms");

    std::vector<DeviceInfo> list;
    for (cl_platform_id platform : platforms) {
        cl_uint devices = 0;
        if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &devices) != CL_SUCCESS || devices == 0) continue;
        std::vector<cl_device_id> ids(devices);
        if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, devices, ids.data(), nullptr) != CL_SUCCESS) continue;
        for (cl_device_id id : ids) list.push_back(describe(platform, id));
    }
    return list;
}

static std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

DeviceInfo chooseDevice(const std::string& wanted) { return chooseDevice(listDevices(), wanted); }

DeviceInfo chooseDevice(const std::vector<DeviceInfo>& list, const std::string& wanted) {
    if (list.empty())
        throw DeviceError("no OpenCL device found. On Debian, `apt install pocl-opencl-icd` makes the CPU an OpenCL device.");
    std::string listed;
    for (size_t i = 0; i < list.size(); ++i)
        listed +=
            fmt::format("\n  {}  {} ({}){}", i, list[i].name, list[i].platformName, list[i].hasCompiler ? "" : ", without a compiler");
    if (wanted.empty()) {
        const DeviceInfo* best = nullptr;
        for (const DeviceInfo& d : list)
            if (d.hasCompiler && (!best || (best->isCpu && !d.isCpu))) best = &d;
        if (!best)
            throw DeviceError(
                "no OpenCL device has a compiler for OpenCL C; on Debian, `apt install pocl-opencl-icd` makes the CPU a device that has "
                "one. There are:" +
                listed);
        return *best;
    }
    size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error == std::errc() && end == wanted.data() + wanted.size() && index < list.size()) return list[index];
    for (const DeviceInfo& d : list)
        if (lower(d.name + " " + d.platformName + " " + d.version).find(lower(wanted)) != std::string::npos) return d;
    throw DeviceError(fmt::format("no OpenCL device is called \"{}\". There are:{}", wanted, listed));
}

static size_t indexOf(const std::vector<DeviceInfo>& list, const DeviceInfo& device) {
    return static_cast<size_t>(std::ranges::find(list, device.id, &DeviceInfo::id) - list.begin());
}

std::vector<std::string> chooseDevices(const std::vector<DeviceInfo>& list, const std::string& wanted) {
    std::vector<std::string> chosen;
    if (wanted == "all") {
        for (size_t i = 0; i < list.size(); ++i)
            if (list[i].hasCompiler) chosen.push_back(std::to_string(i));
        if (chosen.empty()) chooseDevice(list, "");   // says why there is none
        return chosen;
    }
    const std::vector<std::string> parts = split(wanted, ',');
    if (parts.size() < 2) {
        chooseDevice(list, wanted);
        return {wanted};
    }
    for (const std::string& part : parts) {
        if (part.empty()) throw DeviceError(fmt::format("--device {}: a name is empty; write names with commas between them", wanted));
        const DeviceInfo device = chooseDevice(list, part);
        const std::string index = std::to_string(indexOf(list, device));
        if (std::ranges::find(chosen, index) != chosen.end())
            throw DeviceError(fmt::format("--device {}: \"{}\" is device {} again", wanted, part, index));
        chosen.push_back(index);
    }
    return chosen;
}

Context::Context(const DeviceInfo& device, bool profiling) : device_(device), profiling_(profiling) {
    if (!device.hasCompiler)
        throw DeviceError(fmt::format("the device \"{}\" has no compiler for OpenCL C; choose another with --device.", device.name));
    cl_int status = CL_SUCCESS;
    const cl_context_properties properties[] = {CL_CONTEXT_PLATFORM, reinterpret_cast<cl_context_properties>(device.platform), 0};
    context_ = ContextHandle(clCreateContext(properties, 1, &device.id, nullptr, nullptr, &status));
    check(status, fmt::format("creating a context for \"{}\"", device.name));
    queue_ = QueueHandle(clCreateCommandQueue(context_, device.id, profiling ? CL_QUEUE_PROFILING_ENABLE : 0, &status));
    check(status, "creating a command queue");
}

void Context::finish() const { check(clFinish(queue_), "waiting for the device"); }
void Context::flush() const { check(clFlush(queue_), "flushing the command queue"); }

}  // namespace eikonal
