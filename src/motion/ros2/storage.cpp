#include "motion/ros2/storage.h"

#include <fstream>
#include <limits>

#include "base/input_file.h"
#include "motion/ros2/decompression.h"
#include "motion/ros2/mcap_storage.h"
#include "motion/ros2/sqlite_storage.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

Stamp recordTime(std::uint64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1000000000;  // [ns]
  constexpr std::uint64_t kEnd = std::numeric_limits<std::uint32_t>::max() * kSecond;
  if (nanoseconds < kEnd) return Stamp(static_cast<std::int64_t>(nanoseconds));
  throw Error("a message is said to be recorded " + std::to_string(nanoseconds / kSecond) +
              " s after the epoch, which is not a ROS time");
}

Storage openStorage(const std::string& file) {
  std::ifstream stream = base::openInput(file);
  std::string start(16, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  if (start.empty()) throw Error("the file is empty");
  if (isSqlite(start)) return openSqlite(file);
  if (isMcap(start)) return openMcap(file);
  if (!isZstd(start)) throw Error("is neither an SQLite database nor an MCAP file");
  // The temporary file's name is removed as soon as the file is open, so nothing is left of it when
  // this process ends.
  const TemporaryFile plain = decompressZstdFile(file);
  std::ifstream(plain.path()).read(start.data(), static_cast<std::streamsize>(start.size()));
  if (isZstd(start)) throw Error("is compressed twice");
  Storage storage = openStorage(plain.path());
  storage.kind += ", zstd of the file";
  return storage;
}

}  // namespace synthetic_dataset::motion
