#pragma once
// Large allocations, mapped from and returned to the system directly.

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace eikonal {

/// Large pages avoid most TLB misses of traversals through large tables (docs/performance.md); small ones only use memory that is touched.
enum class PageSize { small, large };

/// Size of a large page in bytes.
inline constexpr std::size_t largePage = std::size_t{2} << 20;
/// Allocations of at least this size get pages of their own.
inline constexpr std::size_t worthPages = 2 * largePage;

/// Allocates `bytes` zeroed bytes, aligned to a large page; null if there is not enough memory. Pages use memory once they are touched, and
/// are small if the system has no large ones.
void* mapPages(std::size_t bytes, PageSize size);
/// Frees memory from mapPages; `bytes` as given there.
void unmapPages(void* pages, std::size_t bytes);

/// Allocates `bytes` < worthPages zeroed bytes, aligned to two cache lines, in large pages that other such allocations share; null if there
/// is not enough memory. The pages are freed with the last allocation in them. Thread-safe.
std::shared_ptr<void> sharePages(std::size_t bytes);

/// Whether resize() leaves new elements of this type uninitialised. Only for tables that many threads fill, so that each page is first
/// touched by the thread that fills it.
template <class T> constexpr bool staysUninitialized = false;

/// Allocator for vectors that may be large, which then lie in large pages; others are aligned to a cache line.
template <class T> struct PageAllocator {
    using value_type = T;

    PageAllocator() = default;
    template <class Other> PageAllocator(const PageAllocator<Other>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < worthPages) return static_cast<T*>(::operator new(bytes, cacheLine));
        if (void* pages = mapPages(bytes, PageSize::large)) return static_cast<T*>(pages);
        throw std::bad_alloc();
    }
    void deallocate(T* memory, std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < worthPages) ::operator delete(memory, cacheLine);
        else unmapPages(memory, bytes);
    }

    template <class Element, class... Values> void construct(Element* place, Values&&... values) {
        if constexpr (sizeof...(Values) == 0 && staysUninitialized<Element>) ::new (static_cast<void*>(place)) Element;
        else ::new (static_cast<void*>(place)) Element(std::forward<Values>(values)...);
    }

    template <class Other> bool operator==(const PageAllocator<Other>&) const { return true; }

private:
    static constexpr std::align_val_t cacheLine{64};
};

/// A table that a device can read in place.
template <class T> using Table = std::vector<T, PageAllocator<T>>;

}  // namespace eikonal
