#pragma once

/// Tiny worlds, models and meshes as text, and matchers for what they become; meant for
/// `using namespace test`.

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/world_loader.h"

namespace synthetic_dataset::test {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

[[nodiscard]] inline std::string worldFile(const std::string& content) {
  return "<sdf version='1.7'><world name='w'>" + content + "</world></sdf>";
}

[[nodiscard]] inline std::string modelElement(const std::string& name, const std::string& content) {
  return "<model name='" + name + "'>" + content + "</model>";
}

[[nodiscard]] inline std::string modelFile(const std::string& name, const std::string& content) {
  return "<sdf version='1.7'>" + modelElement(name, content) + "</sdf>";
}

[[nodiscard]] inline std::string linkElement(const std::string& content = "") {
  return "<link name='body'>" + content + "</link>";
}

[[nodiscard]] inline std::string visualElement(const std::string& geometry,
                                               const std::string& rest = "") {
  return "<visual name='v'><geometry>" + geometry + "</geometry>" + rest + "</visual>";
}

[[nodiscard]] inline std::string meshElement(const std::string& uri, const std::string& rest = "") {
  return "<mesh><uri>" + uri + "</uri>" + rest + "</mesh>";
}

constexpr const char* kBox = "<box><size>1 2 3</size></box>";

/// A model file of one box.
[[nodiscard]] inline std::string boxModel(const std::string& name, const std::string& rest = "") {
  return modelFile(name, rest + linkElement(visualElement(kBox)));
}

/// One triangle in the plane z = 0, from the origin to (1, 0, 0) and (0, 2, 0).
constexpr const char* kTriangleObj =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";

/// A finder that knows the folder's models and no packages.
[[nodiscard]] inline world::ResourceFinder finderIn(const TemporaryFolder& folder) {
  return world::ResourceFinder({folder.path().string()}, nullptr);
}

/// The world that a world file's text describes.
[[nodiscard]] inline world::Description loadText(const TemporaryFolder& folder,
                                                 const std::string& text) {
  return world::loadWorld(folder.write("world.sdf", text).string(), finderIn(folder));
}

/// The world that a world file's text describes, without missing assets.
[[nodiscard]] inline world::Description loadWithoutMissing(const TemporaryFolder& folder,
                                                           const std::string& text) {
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  return world::loadWorld(folder.write("world.sdf", text).string(), finderIn(folder), options);
}

[[nodiscard]] inline std::string includeElement(const std::string& uri,
                                                const std::string& rest = "") {
  return "<include><uri>" + uri + "</uri>" + rest + "</include>";
}

/// The one visual of a world with nothing else.
[[nodiscard]] inline world::Visual loadVisual(const TemporaryFolder& folder,
                                              const std::string& visual) {
  return loadText(folder, worldFile(modelElement("m", linkElement(visual))))
      .models.at(0)
      .links.at(0)
      .visuals.at(0);
}

/// The notes on a world that loads nevertheless.
[[nodiscard]] inline std::vector<std::string> notesOf(const TemporaryFolder& folder,
                                                      const std::string& text) {
  return loadText(folder, text).notes;
}

/// The errors of loading the file.
[[nodiscard]] inline std::vector<std::string> errorsOfFile(const TemporaryFolder& folder,
                                                           const std::string& uri) {
  try {
    static_cast<void>(world::loadWorld(uri, finderIn(folder)));
  } catch (const ErrorList& errors) {
    return errors.messages();
  }
  return {};
}

[[nodiscard]] inline std::vector<std::string> errorsOf(const TemporaryFolder& folder,
                                                       const std::string& text) {
  return errorsOfFile(folder, folder.write("world.sdf", text).string());
}

}  // namespace synthetic_dataset::test
