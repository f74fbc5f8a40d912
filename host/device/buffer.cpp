#include "device/buffer.h"

#include <fmt/format.h>

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

namespace eikonal {

constexpr size_t smallestBuffer = 64;

static std::uint64_t nextSerial() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

/// Pages of this size, where the system has them, spare walks down large tables most of what looking up addresses costs (docs/performance.md).
constexpr size_t largePage = size_t{2} << 20;

/// Memory in large pages; null if there is none. For std::free.
static void* allocateLargePages(size_t bytes) {
    void* memory = std::aligned_alloc(largePage, (bytes + largePage - 1) / largePage * largePage);
    if (memory) ::madvise(memory, bytes, MADV_HUGEPAGE);   // where this is refused, pages are small
    return memory;
}

/// A buffer in memory of ours, which is freed with it; null if that does not work.
static cl_mem allocateInLargePages(const Context& context, size_t bytes) {
    void* pages = allocateLargePages(bytes);
    if (!pages) return nullptr;
    cl_int status = CL_SUCCESS;
    cl_mem memory = clCreateBuffer(context.handle(), CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, pages, &status);
    if (status != CL_SUCCESS) { std::free(pages); return nullptr; }
    check(clSetMemObjectDestructorCallback(memory, [](cl_mem, void* pages) { std::free(pages); }, pages), "taking over a buffer's memory");
    return memory;
}

static cl_mem allocate(const Context& context, size_t bytes, const std::string& what) {
    if (context.device().isCpu && bytes >= 2 * largePage)
        if (cl_mem memory = allocateInLargePages(context, bytes)) return memory;
    cl_int status = CL_SUCCESS;
    cl_mem memory = clCreateBuffer(context.handle(), CL_MEM_READ_WRITE, std::max(bytes, smallestBuffer), nullptr, &status);
    if (status != CL_SUCCESS)
        throw DeviceError(fmt::format("the device \"{}\" could not allocate {:.1f} MiB for {}: {}", context.device().name,
                                      static_cast<double>(bytes) / (1 << 20), what, statusName(status)));
    return memory;
}

Buffer::Buffer(const Context& context, size_t bytes, const std::string& what)
    : memory_(allocate(context, bytes, what)), size_(std::max(bytes, smallestBuffer)), serial_(nextSerial()) {
    clear(context, 0, size_);
}

Buffer::Buffer(const Context& context, const void* data, size_t bytes, const std::string& what)
    : memory_(allocate(context, bytes, what)), size_(std::max(bytes, smallestBuffer)), serial_(nextSerial()) {
    if (bytes > 0) write(context, data, bytes);
    else clear(context, 0, size_);
}

void Buffer::write(const Context& context, const void* data, size_t bytes, size_t offset) {
    check(clEnqueueWriteBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, data, 0, nullptr, nullptr), "writing to a buffer");
}

void Buffer::read(const Context& context, void* data, size_t bytes, size_t offset) const {
    check(clEnqueueReadBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, data, 0, nullptr, nullptr), "reading from a buffer");
}

void Buffer::clear(const Context& context, size_t offset, size_t bytes) {
    /* Written, not filled: Oclgrind 21.10 forgets that memory was initialised when it is filled (or written in part) */
    static const std::array<char, 4096> few{};
    if (bytes <= few.size()) {
        check(clEnqueueWriteBuffer(context.queue(), memory_, CL_FALSE, offset, bytes, few.data(), 0, nullptr, nullptr), "clearing a buffer");
        return;
    }
    const std::vector<char> zeros(bytes);
    check(clEnqueueWriteBuffer(context.queue(), memory_, CL_TRUE, offset, bytes, zeros.data(), 0, nullptr, nullptr), "clearing a buffer");
}

}  // namespace eikonal
