#include "output/files/file_system.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::output {
namespace file_system_test {

TEST(FileSystem, OfUnknownKindsIsNotLocal) {
  EXPECT_FALSE(isOnLocalDisk("/proc"));  // no disk at all
  EXPECT_FALSE(isOnLocalDisk("/nowhere"));
}

TEST(FileSystem, InMemoryIsLocal) { EXPECT_TRUE(isOnLocalDisk("/dev/shm")); }

}  // namespace file_system_test
}  // namespace synthetic_dataset::output
