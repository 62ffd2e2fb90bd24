#include "plugins/readback/written_scene.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

std::filesystem::path WrittenScene::file(const std::string& end) const {
  for (const std::filesystem::path& each : files) {
    const std::string path = each.string();
    if (path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0) {
      return each;
    }
  }
  throw Error("'" + folder.string() + "': scene " + name + " has no file '..." + end + "'");
}

}  // namespace synthetic_dataset::formats
