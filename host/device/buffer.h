#pragma once
// Memory on the device.

#include "device/context.h"

#include <cstdint>
#include <span>
#include <vector>

namespace eikonal {

/// A buffer of bytes on a device. Never empty: a table without elements still has something to bind.
class Buffer {
public:
    Buffer() = default;
    /// `bytes` of zeros. Throws a DeviceError that says what for and how much, if the device has not enough.
    Buffer(const Context& context, size_t bytes, const std::string& what);
    /// A copy of `elements`.
    template <class T> static Buffer of(const Context& context, std::span<const T> elements, const std::string& what) {
        return Buffer(context, elements.data(), elements.size_bytes(), what);
    }

    cl_mem handle() const { return memory_; }
    /// Tells it from every other buffer that there has been: handles are used again.
    std::uint64_t serial() const { return serial_; }
    size_t size() const { return size_; }  ///< bytes

    /// Copies to and from the device; waits until it is done.
    void write(const Context& context, const void* data, size_t bytes, size_t offset = 0);
    void read(const Context& context, void* data, size_t bytes, size_t offset = 0) const;
    /// Sets `bytes` from `offset` on to zero, in the order of the queue, without waiting.
    void clear(const Context& context, size_t offset, size_t bytes);

private:
    Buffer(const Context& context, const void* data, size_t bytes, const std::string& what);
    Owned<cl_mem, clReleaseMemObject> memory_;
    size_t size_ = 0;
    std::uint64_t serial_ = 0;
};

}  // namespace eikonal
