#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::readback {

/// Reads what a writer made of a scene from its files alone.
/// @throws Error naming the file that is missing or not as the format has it
using FormatReader = LabelledPicture (*)(const WrittenScene& scene);

/// The reader for a type of writer, as the manifest has it ("synthetic_dataset/Yolo"); null where
/// the type is unknown or holds nothing to draw.
[[nodiscard]] FormatReader readerOf(const std::string& writer_type);

/// For WrittenScene::kept: nothing is kept yet. Files must not change as long as it lives.
[[nodiscard]] std::shared_ptr<KeptFiles> keptFiles();

// Each in its own file, <format>_reader.cpp.
[[nodiscard]] LabelledPicture readBop(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readCityscapes(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readCoco(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readDope(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readImageFolder(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readKitti(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readPascalVoc(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readPvNet(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readStvNet(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readUltralytics(const WrittenScene& scene);
[[nodiscard]] LabelledPicture readYolo(const WrittenScene& scene);

}  // namespace synthetic_dataset::readback
