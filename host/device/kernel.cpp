#include "device/kernel.h"

#include <fmt/format.h>

namespace eikonal {

Kernel::Kernel(std::shared_ptr<Program> program) : program_(std::move(program)) {
    cl_int status = CL_SUCCESS;
    handle_ = decltype(handle_)(clCreateKernel(program_->handle, program_->kernel.c_str(), &status));
    check(status, "creating kernel " + program_->kernel);
}

cl_event Kernel::launch(const Context& context, const Bindings& bindings, const Bindings& extra, size_t items, size_t localSize) const {
    for (cl_uint i = 0; i < program_->arguments.size(); ++i) {
        const std::string& argument = program_->arguments[i];
        const Bindings::Value* value = extra.find(argument);
        if (!value) value = bindings.find(argument);
        if (!value) throw DeviceError(fmt::format("{}: argument '{}' is not bound", name(), argument));
        std::visit([&](const auto& v) { check(clSetKernelArg(handle_, i, sizeof v, &v), fmt::format("binding argument '{}' of {}", argument, name())); }, *value);
    }
    const size_t global = (std::max<size_t>(items, 1) + localSize - 1) / localSize * localSize;
    cl_event event = nullptr;
    check(clEnqueueNDRangeKernel(context.queue(), handle_, 1, nullptr, &global, &localSize, 0, nullptr, context.profiling() ? &event : nullptr),
          "launching " + name());
    return event;
}

}  // namespace eikonal
