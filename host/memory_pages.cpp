#include "memory_pages.h"

#include <sys/mman.h>

#include <cstdint>

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

}  // namespace eikonal
