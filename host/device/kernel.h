#pragma once
// Launches kernels with arguments bound by name, so that none can be swapped, missing or misspelt.

#include "device/buffer.h"
#include "device/program.h"

#include <map>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Values of kernel arguments by name: buffers, and 32-bit numbers.
class Bindings {
public:
    void set(const std::string& name, const Buffer& buffer) { values_[name] = {buffer.handle(), 0, buffer.serial()}; }
    void set(const std::string& name, cl_uint number) { values_[name] = {nullptr, number, 0}; }
    /// A buffer, or a number if `buffer` is null.
    struct Value {
        cl_mem buffer;
        cl_uint number;
        std::uint64_t serial;   ///< of the buffer
        bool operator==(const Value&) const = default;
    };
    const Value* find(const std::string& name) const {
        const auto found = values_.find(name);
        return found == values_.end() ? nullptr : &found->second;
    }

private:
    std::map<std::string, Value> values_;
};

/// The kernel of a program.
class Kernel {
public:
    Kernel() = default;
    explicit Kernel(std::shared_ptr<Program> program);

    const std::string& name() const { return program_->kernel; }
    const Program& program() const { return *program_; }

    /// Enqueues the work-groups for `slots` slots, at least one group, of `groupSlots` slots each; the number of work-items follows from
    /// the kernel's local size. Does not wait. Later `bindings` override earlier ones. Throws a DeviceError that names an argument that
    /// none of them has. Returns the event if the context profiles, else null; the caller owns it.
    cl_event launch(const Context& context, std::initializer_list<const Bindings*> bindings, size_t slots, size_t groupSlots) const;

private:
    void setArgument(cl_uint index, const Bindings::Value& value) const;

    std::shared_ptr<Program> program_;
    Owned<cl_kernel, clReleaseKernel> handle_;
    size_t localSize_ = 1;   ///< work-items per group
    mutable std::vector<std::optional<Bindings::Value>> set_;   ///< the value last set for each argument
};

}  // namespace eikonal
