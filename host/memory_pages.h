#pragma once
// Large amounts of memory, straight from the system and straight back to it.

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace eikonal {

/// Large pages spare walks down large tables most of what looking up addresses costs (docs/performance.md); small ones take up no more than is touched.
enum class PageSize { small, large };

/// Bytes of a large page.
inline constexpr std::size_t largePage = std::size_t{2} << 20;
/// From this many bytes on, memory is worth pages of its own.
inline constexpr std::size_t worthPages = 2 * largePage;

/// `bytes` zeros, aligned to a large page; null if there is not enough memory. Pages take up memory when they are first touched, and are small
/// where the system has no large ones.
void* mapPages(std::size_t bytes, PageSize size);
/// Gives back what mapPages returned for so many bytes.
void unmapPages(void* pages, std::size_t bytes);

/// Whether elements of a type are left uninitialised where a table is made longer without saying what they are. Only for what fills whole tables by many
/// threads: each page is then touched first by the thread that fills it.
template <class T> constexpr bool staysUninitialized = false;

/// For vectors that may be large: these lie in large pages, others are aligned to a cache line.
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

/// A table as a device may read it where it lies.
template <class T> using Table = std::vector<T, PageAllocator<T>>;

}  // namespace eikonal
