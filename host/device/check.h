#pragma once
// Checks every OpenCL status, with the source location of the call.

#include "error.h"

#include <CL/cl.h>

#include <source_location>
#include <string>

namespace eikonal {

/// "CL_OUT_OF_RESOURCES (-5)".
std::string statusName(cl_int status);

/// Unless `status` is CL_SUCCESS, throws a DeviceError that names the status, the operation and the source location.
void check(cl_int status, const std::string& doing, std::source_location where = std::source_location::current());

/// Owns an OpenCL object.
template <class Handle, cl_int (*release)(Handle)> class Owned {
public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle) {}
    Owned(Owned&& other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }
    Owned& operator=(Owned&& other) noexcept { std::swap(handle_, other.handle_); return *this; }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { if (handle_) release(handle_); }
    operator Handle() const { return handle_; }
    Handle get() const { return handle_; }

private:
    Handle handle_ = nullptr;
};

}  // namespace eikonal
