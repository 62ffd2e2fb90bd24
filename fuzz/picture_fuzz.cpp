// Pictures of all formats. Their decoders run in a process of their own, which costs time: only
// pictures that pass our own checks get that far.
#include "base/image/picture_check.h"
#include "base/image/picture_decoder.h"
#include "base/image/picture_size.h"
#include "fuzzing.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::vector<std::uint8_t> bytes(data, data + size);
  static_cast<void>(base::claimedSize(bytes));
  const std::vector<std::uint8_t> essential = base::essentialPngChunks(bytes);
  if (essential.empty() || !base::isWhole(essential)) return 0;
  if (std::hash<std::string_view>()(fuzzing::view(data, size)) % 8 != 0) return 0;
  fuzzing::tolerating([&] { static_cast<void>(base::decodePicture(bytes, "picture")); });
  return 0;
}
