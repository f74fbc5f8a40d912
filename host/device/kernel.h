#pragma once
// Launching kernels with arguments bound by name: they cannot be misordered, forgotten or misspelt.

#include "device/buffer.h"
#include "device/program.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>

namespace eikonal {

/// What a kernel's arguments are, by name: buffers, and numbers of 32 bits.
class Bindings {
public:
    void set(const std::string& name, const Buffer& buffer) { values_[name] = buffer.handle(); }
    void set(const std::string& name, cl_uint number) { values_[name] = number; }
    /// Everything that `others` has, which replaces what is here under the same name.
    void add(const Bindings& others) { for (const auto& [name, value] : others.values_) values_[name] = value; }
    using Value = std::variant<cl_mem, cl_uint>;
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

    /// Enqueues `items` work-items, rounded up to whole groups of localSize, numbered from 0. Does not wait. `extra` holds arguments
    /// that `bindings` has not, or has otherwise. Throws a DeviceError that names an argument that is in neither.
    /// Returns the event if the context profiles, else null; the caller owns it.
    cl_event launch(const Context& context, const Bindings& bindings, const Bindings& extra, size_t items, size_t localSize) const;

private:
    std::shared_ptr<Program> program_;
    Owned<cl_kernel, clReleaseKernel> handle_;
};

}  // namespace eikonal
