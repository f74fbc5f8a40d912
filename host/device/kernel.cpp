#include "device/kernel.h"

#include <fmt/format.h>

namespace eikonal {

Kernel::Kernel(std::shared_ptr<Program> program) : program_(std::move(program)) {
    cl_int status = CL_SUCCESS;
    handle_ = decltype(handle_)(clCreateKernel(program_->handle, program_->kernel.c_str(), &status));
    check(status, "creating kernel " + program_->kernel);
    cl_device_id device = nullptr;   // a program here has a single device
    check(clGetProgramInfo(program_->handle, CL_PROGRAM_DEVICES, sizeof device, &device, nullptr),
          "querying the device of " + program_->kernel);
    size_t size[3] = {};
    check(clGetKernelWorkGroupInfo(handle_, device, CL_KERNEL_COMPILE_WORK_GROUP_SIZE, sizeof size, size, nullptr),
          "querying the work-group size of " + program_->kernel);
    localSize_ = std::max<size_t>(size[0], 1);
    set_.resize(program_->arguments.size());
}

void Kernel::setArgument(cl_uint index, const Bindings::Value& value) const {
    if (set_[index] == value) return;
    const cl_int status = value.buffer ? clSetKernelArg(handle_, index, sizeof value.buffer, &value.buffer)
                                       : clSetKernelArg(handle_, index, sizeof value.number, &value.number);
    if (status != CL_SUCCESS) check(status, fmt::format("binding argument '{}' of {}", program_->arguments[index], name()));
    set_[index] = value;
}

cl_event Kernel::launch(const Context& context, std::initializer_list<const Bindings*> bindings, size_t slots, size_t groupSlots) const {
    for (cl_uint i = 0; i < program_->arguments.size(); ++i) {
        const Bindings::Value* value = nullptr;
        for (const Bindings* layer : bindings)
            if (const Bindings::Value* found = layer->find(program_->arguments[i])) value = found;
        if (!value) throw DeviceError(fmt::format("{}: argument '{}' is not bound", name(), program_->arguments[i]));
        setArgument(i, *value);
    }
    const size_t global = (std::max<size_t>(slots, 1) + groupSlots - 1) / groupSlots * localSize_;
    cl_event event = nullptr;
    check(clEnqueueNDRangeKernel(context.queue(), handle_, 1, nullptr, &global, &localSize_, 0, nullptr,
                                 context.profiling() ? &event : nullptr),
          "launching " + name());
    return event;
}

}  // namespace eikonal
