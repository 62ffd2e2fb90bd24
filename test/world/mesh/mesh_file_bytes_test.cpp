#include "world/mesh/mesh_file_bytes.h"

#include <gmock/gmock.h>

#include "base/sandbox/byte_stream.h"
#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace mesh_file_bytes_test {

TEST(MeshFileBytes, RefuseCountsBeyondTheirEnd) {
  for (int counts_before = 0; counts_before < 3; ++counts_before) {  // pictures, materials, parts
    base::ByteWriter writer;
    for (int i = 0; i < counts_before; ++i) writer.number<std::uint64_t>(0);
    writer.number<std::uint64_t>(std::uint64_t{1} << 60U);
    const std::string bytes = writer.take();
    EXPECT_THAT(test::messagesOf([&] { static_cast<void>(meshFileOf(bytes)); }),
                testing::ElementsAre(testing::HasSubstr("arrived incomplete")));
  }
}

TEST(MeshFileBytes, TakeAnyByteForATruth) {
  MeshFile file;
  file.materials.resize(1);
  file.materials[0].material.lit = true;
  file.materials[0].material.double_sided = false;
  const std::string bytes = toBytes(file);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string broken = bytes;
    broken[i] = static_cast<char>(broken[i] | 12);
    try {
      for (const MaterialSource& source : meshFileOf(broken).materials) {
        EXPECT_TRUE(source.material.lit);
      }
    } catch (const Error&) {
      // The changed byte was part of a count.
    }
  }
}

}  // namespace mesh_file_bytes_test
}  // namespace synthetic_dataset::world
