#include "device/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <utility>

namespace eikonal {

constexpr size_t smallestBuffer = 64;

static std::uint64_t nextSerial() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

/// A buffer that uses host memory; null on failure.
static cl_mem wrap(const Context& context, void* memory, size_t bytes) {
    cl_int status = CL_SUCCESS;
    const cl_mem buffer = clCreateBuffer(context.handle(), CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, memory, &status);
    return status == CL_SUCCESS ? buffer : nullptr;
}

using Pages = std::shared_ptr<void>;

/// Zeroed memory in pages of its own, or for a small buffer in large ones that it shares; null if there is not enough.
static Pages allocatePages(size_t bytes, PageSize pageSize) {
    if (bytes < worthPages) return sharePages(bytes);
    void* const memory = mapPages(bytes, pageSize);
    return memory ? Pages(memory, [bytes](void* pages) { unmapPages(pages, bytes); }) : nullptr;
}

/// A buffer that uses these pages, and frees them with it; null on failure.
static cl_mem wrapPages(const Context& context, Pages pages, size_t bytes) {
    if (!pages) return nullptr;
    auto owned = std::make_unique<Pages>(std::move(pages));
    const cl_mem buffer = wrap(context, owned->get(), bytes);
    if (!buffer) return nullptr;
    check(clSetMemObjectDestructorCallback(
              buffer, [](cl_mem, void* ownedPages) { delete static_cast<Pages*>(ownedPages); }, owned.get()),
          "passing memory to a buffer");
    owned.release();
    return buffer;
}

static cl_mem allocate(const Context& context, size_t bytes, const std::string& what) {
    cl_int status = CL_SUCCESS;
    cl_mem memory = clCreateBuffer(context.handle(), CL_MEM_READ_WRITE, std::max(bytes, smallestBuffer), nullptr, &status);
    if (status != CL_SUCCESS)
        throw DeviceError(fmt::format("the device \"{}\" could not allocate {:.1f} MiB for {}: {}", context.device().name,
                                      static_cast<double>(bytes) / (1 << 20), what, statusName(status)));
    return memory;
}

Buffer::Buffer(const Context& context, size_t bytes, const std::string& what, PageSize pages)
    : size_(std::max(bytes, smallestBuffer)), serial_(nextSerial()) {
    /* On a CPU, which uses host memory, in our own pages; not if only a part of a small buffer may be touched */
    if (context.device().isCpu && (bytes >= worthPages || pages == PageSize::large))
        memory_ = Memory(wrapPages(context, allocatePages(size_, pages), size_));
    /* New pages hold zeros, but only what is written counts as initialised to Oclgrind: it sees small buffers */
    if (memory_ && bytes >= worthPages) return;
    if (!memory_) memory_ = Memory(allocate(context, bytes, what));
    clear(context, 0, size_);
}

Buffer::Buffer(const Context& context, const void* data, size_t bytes, const std::string& what)
    : size_(std::max(bytes, smallestBuffer)), serial_(nextSerial()) {
    if (context.device().isCpu && bytes < worthPages) memory_ = Memory(wrapPages(context, sharePages(size_), size_));
    if (!memory_) memory_ = Memory(allocate(context, bytes, what));
    if (bytes > 0) write(context, data, bytes);
    else clear(context, 0, size_);
}

Buffer::Buffer(const Context& context, const void* data, size_t bytes, const std::string& what, Shared)
    : size_(bytes), serial_(nextSerial()) {
    /* The const_cast is safe: kernels take tables as pointers to const */
    if (context.device().isCpu) memory_ = Memory(wrap(context, const_cast<void*>(data), bytes));
    if (!memory_) *this = Buffer(context, data, bytes, what);
}

void Buffer::write(const Context& context, const void* data, size_t bytes, size_t offset) {
    check(clEnqueueWriteBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, data, 0, nullptr, nullptr), "writing to a buffer");
}

void Buffer::read(const Context& context, void* data, size_t bytes, size_t offset) const {
    check(clEnqueueReadBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, data, 0, nullptr, nullptr), "reading from a buffer");
}

void Buffer::enqueueWrite(const Context& context, const void* data, size_t bytes) {
    check(clEnqueueWriteBuffer(context.queue(), memory_, CL_FALSE, 0, bytes, data, 0, nullptr, nullptr), "writing to a buffer");
}

void* Buffer::map(const Context& context, Owned<cl_event, clReleaseEvent>& ready) {
    cl_int status = CL_SUCCESS;
    cl_event event = nullptr;
    void* const memory =
        clEnqueueMapBuffer(context.queue(), memory_, CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, size_, 0, nullptr, &event, &status);
    check(status, "mapping a buffer");
    ready = Owned<cl_event, clReleaseEvent>(event);
    return memory;
}

void Buffer::unmap(const Context& context, void* memory) {
    check(clEnqueueUnmapMemObject(context.queue(), memory_, memory, 0, nullptr, nullptr), "unmapping a buffer");
}

void Buffer::clear(const Context& context, size_t offset, size_t bytes) {
    /* Writes zeros instead of clEnqueueFillBuffer: Oclgrind 21.10 treats memory that was filled, or partly written, as uninitialised */
    static const std::array<char, 4096> few{};
    if (bytes <= few.size()) {
        check(clEnqueueWriteBuffer(context.queue(), memory_, CL_FALSE, offset, bytes, few.data(), 0, nullptr, nullptr),
              "clearing a buffer");
        return;
    }
    const std::vector<char> zeros(bytes);
    check(clEnqueueWriteBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, zeros.data(), 0, nullptr, nullptr), "clearing a buffer");
}

}  // namespace eikonal
