#pragma once
// Memory on the device.

#include "device/context.h"
#include "memory_pages.h"

#include <cstdint>
#include <span>
#include <vector>

namespace eikonal {

/// A buffer of bytes on a device. Never empty: a table without elements still has something to bind.
class Buffer {
public:
    Buffer() = default;
    /// `bytes` of zeros. Throws a DeviceError that says what for and how much, if the device has not enough. `pages` are those of large buffers of a CPU.
    Buffer(const Context& context, size_t bytes, const std::string& what, PageSize pages = PageSize::large);
    /// A copy of `elements`.
    template <class T> static Buffer of(const Context& context, std::span<const T> elements, const std::string& what) {
        return Buffer(context, elements.data(), elements.size_bytes(), what);
    }
    /// What kernels read and nobody changes: a large table of a CPU is not copied, so it must stay where and as it is for as long as the buffer lives.
    template <class T> static Buffer sharing(const Context& context, const Table<T>& table, const std::string& what) {
        return Buffer(context, table.data(), table.size() * sizeof(T), what, Shared{});
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
    struct Shared {};
    using Memory = Owned<cl_mem, clReleaseMemObject>;
    Buffer(const Context& context, const void* data, size_t bytes, const std::string& what);
    Buffer(const Context& context, const void* data, size_t bytes, const std::string& what, Shared);
    Memory memory_;
    size_t size_ = 0;
    std::uint64_t serial_ = 0;
};

}  // namespace eikonal
