#include "world/mesh/mesh_file_bytes.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"
#include "world/files/byte_stream.h"

namespace synthetic_dataset::world {
namespace {

TEST(MeshFileBytes, RefuseCountsBeyondTheirEnd) {
  for (int counts_before = 0; counts_before < 3; ++counts_before) {  // pictures, materials, parts
    ByteWriter writer;
    for (int i = 0; i < counts_before; ++i) writer.number<std::uint64_t>(0);
    writer.number<std::uint64_t>(std::uint64_t{1} << 60U);
    const std::string bytes = writer.take();
    EXPECT_THAT([&] { static_cast<void>(meshFileOf(bytes)); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("came over incomplete")));
  }
}

}  // namespace
}  // namespace synthetic_dataset::world
