#include "device/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace eikonal {

constexpr size_t smallestBuffer = 64;

static std::uint64_t nextSerial() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

static cl_mem allocate(const Context& context, size_t bytes, const std::string& what) {
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
