#include "plugins/readback/format_readers.h"

#include <map>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::readback {
namespace {

const std::map<std::string, FormatReader>& readers() {
  static const std::map<std::string, FormatReader> kReaders = {
      {"synthetic_dataset/Bop", readBop},
      {"synthetic_dataset/Cityscapes", readCityscapes},
      {"synthetic_dataset/Coco", readCoco},
      {"synthetic_dataset/Dope", readDope},
      {"synthetic_dataset/ImageFolder", readImageFolder},
      {"synthetic_dataset/Kitti", readKitti},
      {"synthetic_dataset/PascalVoc", readPascalVoc},
      {"synthetic_dataset/PvNet", readPvNet},
      {"synthetic_dataset/StvNet", readStvNet},
      {"synthetic_dataset/UltralyticsYolo", readUltralytics},
      {"synthetic_dataset/Yolo", readYolo},
  };
  return kReaders;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::filesystem::path WrittenScene::file(const std::string& end) const {
  for (const std::filesystem::path& each : files) {
    if (endsWith(each.string(), end)) return each;
  }
  throw Error("'" + folder.string() + "': scene " + name + " has no file '..." + end + "'");
}

FormatReader readerOf(const std::string& writer_type) {
  const auto found = readers().find(writer_type);
  return found == readers().end() ? nullptr : found->second;
}

}  // namespace synthetic_dataset::readback
