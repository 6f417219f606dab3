// Memory for large arrays that are visited out of order: in huge pages where the system has them.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace mwt {

/// The size that blocks of huge pages are rounded up to.
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// A block of at least this many bytes (of any content), on the boundary of a huge page. A page that is new to the
/// process has to be cleared by the system, on a virtual machine often by its host too, which costs more than an
/// algorithm's work on it; so blocks come from those given back before, the smallest that is large enough, and new ones
/// only when there is none. From any thread. Throws std::bad_alloc.
[[nodiscard]] void* take_huge_pages(std::size_t bytes);

/// Keeps a block of take_huge_pages(bytes), joined with its neighbours, for the next one who needs it.
void give_back_huge_pages(void* block, std::size_t bytes) noexcept;

/// Returns all that was given back to the system, so that a measurement of memory starts from what is in use.
void release_kept_huge_pages();

/// Makes room for so many bytes from elsewhere: the kept blocks stay, but as much of them is without memory until it is
/// used again.
void vacate_kept_huge_pages(std::size_t bytes);

/// The size of the blocks that are kept.
[[nodiscard]] std::size_t kept_huge_page_bytes();

/// An allocator for std::vector. A mesh of a million points spans 25,000 ordinary pages, more than the processor's
/// translation buffers hold, but only 50 huge ones; small arrays get ordinary memory. New elements of a vector that
/// are not given a value, as by resize(n), have none if their type has no constructor: the pages are written once.
template <class T>
class HugePageAllocator {
 public:
  using value_type = T;

  HugePageAllocator() = default;
  template <class Other>
  HugePageAllocator(const HugePageAllocator<Other>&) {}  // NOLINT(google-explicit-constructor): as allocators do

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes >= kHugePage) return static_cast<T*>(take_huge_pages(bytes));
    return static_cast<T*>(::operator new (bytes, std::align_val_t{kAlignment}));
  }

  void deallocate(T* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes >= kHugePage) {
      give_back_huge_pages(memory, bytes);
    } else {
      ::operator delete (memory, std::align_val_t{kAlignment});
    }
  }

  template <class Element>
  void construct(Element* place) {
    ::new (static_cast<void*>(place)) Element;
  }
  template <class Element, class... Values>
  void construct(Element* place, Values&&... values) {
    ::new (static_cast<void*>(place)) Element(std::forward<Values>(values)...);
  }

  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }

 private:
  static constexpr std::size_t kAlignment = 64;  // a cache line
};

template <class T>
using HugeVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace mwt
