#include "memory_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <mutex>

namespace eikonal {

static std::size_t wholePages(std::size_t bytes) { return (bytes + largePage - 1) / largePage * largePage; }

void* mapPages(std::size_t bytes, PageSize size) {
    /* Map one page more than needed, keep an aligned part of the right length, and unmap the rest */
    const std::size_t length = wholePages(bytes), mapped = length + largePage;
    void* memory = ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    char* const begin = static_cast<char*>(memory);
    char* const aligned = reinterpret_cast<char*>(wholePages(reinterpret_cast<std::uintptr_t>(begin)));
    if (aligned > begin) ::munmap(begin, static_cast<std::size_t>(aligned - begin));
    if (char* const end = aligned + length; end < begin + mapped) ::munmap(end, static_cast<std::size_t>(begin + mapped - end));
    ::madvise(aligned, length, size == PageSize::large ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);   // if refused, the system chooses the page size
    return aligned;
}

void unmapPages(void* pages, std::size_t bytes) { ::munmap(pages, wholePages(bytes)); }

namespace {

/// Pages that allocations are taken from, one behind the other.
class SharedPages {
public:
    static constexpr std::size_t size = 4 * largePage, alignment = 128;
    static_assert(size >= worthPages);

    SharedPages() : memory_(static_cast<char*>(mapPages(size, PageSize::large))) {}
    ~SharedPages() { if (memory_) unmapPages(memory_, size); }
    SharedPages(const SharedPages&) = delete;

    bool hasRoomFor(std::size_t bytes) const { return memory_ && bytes <= size - used_; }
    void* take(std::size_t bytes) {
        void* const taken = memory_ + used_;
        used_ = std::min(size, (used_ + bytes + alignment - 1) / alignment * alignment);
        return taken;
    }

private:
    char* memory_;
    std::size_t used_ = 0;
};

}  // namespace

std::shared_ptr<void> sharePages(std::size_t bytes) {
    static std::mutex mutex;
    static std::shared_ptr<SharedPages> current;
    const std::lock_guard lock(mutex);
    if (!current || !current->hasRoomFor(bytes)) current = std::make_shared<SharedPages>();
    if (!current->hasRoomFor(bytes)) return nullptr;
    return {current, current->take(bytes)};
}

}  // namespace eikonal
