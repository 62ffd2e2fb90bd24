#include "programs/console/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace synthetic_dataset::programs::heap {
namespace {

constexpr int kMegabyte = 1 << 20;

/// Otherwise the C library would get memory for each image from the system, which fills it with
/// zeros, and return it afterwards.
void keepImages() {
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);  // the most that all versions accept
  mallopt(M_TRIM_THRESHOLD, 512 * kMegabyte);
}

/// Whether the process may reserve addresses that it may never use.
bool hasRoom() {
  const auto isFree = [](auto resource) {
    rlimit limit{};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  };
  return isFree(RLIMIT_AS) && isFree(RLIMIT_DATA);
}

/// A shadow map's neighbouring rows lie on different pages; the processor looks up few large pages
/// faster. Reserves addresses for some hundred megabytes, which take no memory until they are used.
void useLargePages() {
  constexpr int kHeap = 256 * kMegabyte;
  constexpr int kUsualPad = 128 << 10;
  constexpr std::uintptr_t kPage = 2 * kMegabyte;
  if (!hasRoom()) return;
  mallopt(M_TOP_PAD, kHeap);
  void* const first = std::malloc(kMegabyte);
  mallopt(M_TOP_PAD, kUsualPad);
  const auto address = reinterpret_cast<std::uintptr_t>(first);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t begin = (address + kPage - 1) / kPage * kPage;
  // A sanitizer's heap lies elsewhere.
  if (first != nullptr && begin < end && end - begin <= 2 * std::uintptr_t{kHeap}) {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
  std::free(first);
}

}  // namespace

void prepare() {
  keepImages();
  useLargePages();
}

}  // namespace synthetic_dataset::programs::heap
