#include "motion/ros2/decompression.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/ros2_bags.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace decompression_test {

using ::testing::HasSubstr;

std::string errorOf(const std::string& frame) {
  return messageOf([&] { (void)zstdDecompressed(frame); });
}

TEST(Decompression, GivesTheContentBack) {
  std::string content;
  for (int i = 0; i < 100000; ++i) content += std::to_string(i);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, content.size()}) {
    EXPECT_EQ(zstdDecompressed(zstdFrame(content.substr(0, size))), content.substr(0, size));
    EXPECT_EQ(lz4Decompressed(lz4Frame(content.substr(0, size))), content.substr(0, size));
  }
}

TEST(Decompression, NamesFramesThatAreCutDamagedOrGoOn) {
  const std::string frame = zstdFrame(std::string(100000, 'x') + "end");
  for (std::size_t size = 0; size < frame.size(); ++size) {
    EXPECT_NE(errorOf(frame.substr(0, size)), "") << size;
  }
  EXPECT_THAT(errorOf(frame + "more"), HasSubstr("has bytes after its compressed content"));
  EXPECT_THAT(errorOf("no frame at all"), HasSubstr("cannot be decompressed by zstd"));
  EXPECT_THAT(messageOf([&] { (void)lz4Decompressed("no frame at all"); }),
              HasSubstr("cannot be decompressed by lz4"));
}

TEST(Decompression, AFileBecomesATemporaryOneThatGoes) {
  const test::TemporaryFolder folder;
  const std::string content(5000000, 'x');
  const auto file = folder.write("a.zstd", zstdFrame(content) + zstdFrame("end"));
  std::string path;
  {
    const TemporaryFile plain = decompressZstdFile(file.string());
    path = plain.path();
    EXPECT_EQ(test::readFile(path), content + "end");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Decompression, AFileThatBreaksOffIsNamed) {
  const test::TemporaryFolder folder;
  const std::string frame = zstdFrame(std::string(100000, 'x') + "end");
  const auto file = folder.write("a.zstd", frame.substr(0, frame.size() - 3));
  EXPECT_THAT(messageOf([&] { (void)decompressZstdFile(file.string()); }),
              HasSubstr("breaks off: its compressed content has no end"));
}

}  // namespace decompression_test
}  // namespace synthetic_dataset::motion
