#pragma once
// Memory on the device.

#include "device/context.h"
#include "memory_pages.h"

#include <cstdint>
#include <span>
#include <vector>

namespace eikonal {

/// A buffer on a device. Never empty, so that a table without elements can be bound, too.
class Buffer {
public:
    Buffer() = default;
    /// A buffer of `bytes` zeros. `pages`: the page size on a CPU. Throws a DeviceError with the size and the purpose
    /// `what` if the allocation fails.
    Buffer(const Context& context, size_t bytes, const std::string& what, PageSize pages = PageSize::large);
    /// A copy of `elements`.
    template <class T> static Buffer of(const Context& context, std::span<const T> elements, const std::string& what) {
        return Buffer(context, elements.data(), elements.size_bytes(), what);
    }
    /// A buffer that kernels only read. On a CPU a large table is not copied, so it must outlive the buffer, neither moved nor changed.
    template <class T> static Buffer sharing(const Context& context, const Table<T>& table, const std::string& what) {
        const size_t bytes = table.size() * sizeof(T);
        return bytes >= worthPages ? over(context, table.data(), bytes, what) : Buffer(context, table.data(), bytes, what);
    }
    /// A buffer that kernels only read. On a CPU it is this memory, which must outlive it: kernels see what the host writes there while
    /// they run. Elsewhere it is a copy.
    static Buffer over(const Context& context, const void* memory, size_t bytes, const std::string& what) {
        return Buffer(context, memory, bytes, what, Shared{});
    }

    cl_mem handle() const { return memory_; }
    /// A number that no other buffer has had. (OpenCL reuses handles.)
    std::uint64_t serial() const { return serial_; }
    size_t size() const { return size_; }  ///< bytes

    /// Copies to and from the device; these calls block.
    void write(const Context& context, const void* data, size_t bytes, size_t offset = 0);
    void read(const Context& context, void* data, size_t bytes, size_t offset = 0) const;
    /// Enqueues a copy to the device. The data must not change before the queue has come to it.
    void enqueueWrite(const Context& context, const void* data, size_t bytes);
    /// Enqueues making the buffer host memory, to read and write from event `ready` on. On a CPU nothing is copied.
    void* map(const Context& context, Owned<cl_event, clReleaseEvent>& ready);
    /// Enqueues giving mapped memory back to the device.
    void unmap(const Context& context, void* memory);
    /// Sets `bytes` bytes from `offset` on to zero, in queue order. Blocks if they are more than 4096.
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
