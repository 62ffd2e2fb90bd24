#include "programs/console/heap.h"

#include <sys/resource.h>

#include <cstring>
#include <memory>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace heap_test {

/// How often the system has had to provide a page of memory.
long pageFaults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

void usePicture() {
  constexpr std::size_t kBytes = 24U << 20U;
  const std::unique_ptr<char[]> picture(new char[kBytes]);
  std::memset(picture.get(), 1, kBytes);
  ASSERT_EQ(picture[kBytes / 2], 1);
}

/// Sanitizers have heaps of their own.
constexpr bool isTheLibrarysHeap() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return false;
#endif
#endif
  return true;
}

TEST(Heap, KeepsTheMemoryOfPictures) {
  if (!isTheLibrarysHeap()) return;
  heap::prepare();
  usePicture();
  const long before = pageFaults();
  for (int i = 0; i < 5; ++i) usePicture();
  EXPECT_LT(pageFaults() - before, 1000) << "24 MB are 6,000 pages";
}

}  // namespace heap_test
}  // namespace synthetic_dataset::programs
