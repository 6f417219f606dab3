#include "geometry/mesh/kept_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>

#if __has_include(<sanitizer/asan_interface.h>)
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(address, size)
#define ASAN_UNPOISON_MEMORY_REGION(address, size)
#endif

namespace mwt {

namespace {

std::size_t rounded_up(std::size_t bytes) { return (bytes + kBlock - 1) / kBlock * kBlock; }

// Memory that is new to the process; nothing if the system refuses. In pages of the size that the system prefers: on a
// virtual machine, huge ones made greedy on a million points 3% faster where memory was used again and 40% slower where
// it was new.
char* map_new_block(std::size_t size) {
  void* block = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return block == MAP_FAILED ? nullptr : static_cast<char*>(block);
}

// The blocks that were given back. Few at any time: only arrays of megabytes come here.
class KeptBlocks {
 public:
  // Nothing if none is large enough.
  char* take(std::size_t size) {
    auto best = size_at_.end();
    for (auto block = size_at_.begin(); block != size_at_.end(); ++block) {
      if (block->second >= size && (best == size_at_.end() || block->second < best->second)) best = block;
    }
    if (best == size_at_.end()) return nullptr;
    const auto [start, whole] = *best;
    if (whole > size) size_at_.emplace(start + size, whole - size);
    size_at_.erase(best);
    ASAN_UNPOISON_MEMORY_REGION(start, size);
    return start;
  }

  void put(char* start, std::size_t size) {
    const auto block = size_at_.emplace(start, size).first;
    ASAN_POISON_MEMORY_REGION(start, size);
    const auto after = std::next(block);
    if (after != size_at_.end() && start + size == after->first) {
      block->second += after->second;
      size_at_.erase(after);
    }
    if (block == size_at_.begin()) return;
    const auto before = std::prev(block);
    if (before->first + before->second == start) {
      before->second += block->second;
      size_at_.erase(block);
    }
  }

  void unmap() {
    for (const auto& [start, size] : size_at_) {
      ASAN_UNPOISON_MEMORY_REGION(start, size);
      munmap(start, size);
    }
    size_at_.clear();
  }

  void vacate(std::size_t bytes) {
    for (const auto& [start, size] : size_at_) {
      const std::size_t part = bytes < size ? rounded_up(bytes) : size;
      madvise(start, part, MADV_DONTNEED);
      bytes -= std::min(bytes, part);
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [start, size] : size_at_) sum += size;
    return sum;
  }

 private:
  std::map<char*, std::size_t> size_at_;
};

struct SharedBlocks {
  std::mutex mutex;
  KeptBlocks blocks;
};

// Never destroyed: arrays of static storage may be given back after it would have been.
SharedBlocks& kept() {
  static auto* const shared = new SharedBlocks;
  return *shared;
}

}  // namespace

void* take_block(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::size_t>::max() / 2) throw std::bad_alloc();
  const std::size_t size = rounded_up(bytes);
  {
    const std::scoped_lock lock(kept().mutex);
    if (char* const block = kept().blocks.take(size)) return block;
  }
  if (char* const block = map_new_block(size)) return block;
  release_kept_blocks();  // scattered blocks may be what the system lacks
  if (char* const block = map_new_block(size)) return block;
  throw std::bad_alloc();
}

void give_back_block(void* block, std::size_t bytes) noexcept {
  const std::scoped_lock lock(kept().mutex);
  try {
    kept().blocks.put(static_cast<char*>(block), rounded_up(bytes));
  } catch (const std::bad_alloc&) {  // no memory to remember it by
    munmap(block, rounded_up(bytes));
  }
}

void release_kept_blocks() {
  const std::scoped_lock lock(kept().mutex);
  kept().blocks.unmap();
}

void vacate_kept_blocks(std::size_t bytes) {
  const std::scoped_lock lock(kept().mutex);
  kept().blocks.vacate(bytes);
}

std::size_t kept_bytes() {
  const std::scoped_lock lock(kept().mutex);
  return kept().blocks.bytes();
}

}  // namespace mwt
