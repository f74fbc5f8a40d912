#include "device/check.h"

#include <fmt/format.h>

#include <map>

namespace eikonal {

std::string statusName(cl_int status) {
#define NAME(code) {code, #code}
    static const std::map<cl_int, const char*> names{NAME(CL_SUCCESS),
                                                     NAME(CL_DEVICE_NOT_FOUND),
                                                     NAME(CL_DEVICE_NOT_AVAILABLE),
                                                     NAME(CL_COMPILER_NOT_AVAILABLE),
                                                     NAME(CL_MEM_OBJECT_ALLOCATION_FAILURE),
                                                     NAME(CL_OUT_OF_RESOURCES),
                                                     NAME(CL_OUT_OF_HOST_MEMORY),
                                                     NAME(CL_BUILD_PROGRAM_FAILURE),
                                                     NAME(CL_INVALID_VALUE),
                                                     NAME(CL_INVALID_DEVICE),
                                                     NAME(CL_INVALID_CONTEXT),
                                                     NAME(CL_INVALID_COMMAND_QUEUE),
                                                     NAME(CL_INVALID_MEM_OBJECT),
                                                     NAME(CL_INVALID_BINARY),
                                                     NAME(CL_INVALID_BUILD_OPTIONS),
                                                     NAME(CL_INVALID_PROGRAM),
                                                     NAME(CL_INVALID_PROGRAM_EXECUTABLE),
                                                     NAME(CL_INVALID_KERNEL_NAME),
                                                     NAME(CL_INVALID_KERNEL),
                                                     NAME(CL_INVALID_ARG_INDEX),
                                                     NAME(CL_INVALID_ARG_VALUE),
                                                     NAME(CL_INVALID_ARG_SIZE),
                                                     NAME(CL_INVALID_KERNEL_ARGS),
                                                     NAME(CL_INVALID_WORK_DIMENSION),
                                                     NAME(CL_INVALID_WORK_GROUP_SIZE),
                                                     NAME(CL_INVALID_WORK_ITEM_SIZE),
                                                     NAME(CL_INVALID_GLOBAL_OFFSET),
                                                     NAME(CL_INVALID_EVENT),
                                                     NAME(CL_INVALID_OPERATION),
                                                     NAME(CL_INVALID_BUFFER_SIZE),
                                                     NAME(CL_KERNEL_ARG_INFO_NOT_AVAILABLE),
                                                     {-1001, "CL_PLATFORM_NOT_FOUND_KHR"}};
#undef NAME
    const auto found = names.find(status);
    return fmt::format("{} ({})", found == names.end() ? "unknown OpenCL status" : found->second, status);
}

void check(cl_int status, const std::string& doing, std::source_location where) {
    if (status == CL_SUCCESS) return;
    throw DeviceError(fmt::format("OpenCL failed while {}: {} [{}:{}]", doing, statusName(status), where.file_name(), where.line()));
}

}  // namespace eikonal
