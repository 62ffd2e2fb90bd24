#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

using base::Warning;

/// What determines a run, as its manifest lists it: equal descriptions make equal datasets.
struct RunDescription {
  struct Setting {
    std::string value;        ///< JSON
    bool is_default = false;  ///< not set by the user
  };
  struct Input {
    std::int64_t bytes = 0;
    std::string digest;
  };
  /// The author and licence of an input, and the files that state them.
  struct Credit {
    std::string author;
    std::string author_in;
    std::string license;
    std::string license_in;
  };
  struct Class {
    int id = 0;
    std::string name;
  };
  struct Motion {
    std::string name;
    std::int64_t first_instant = 0;
    std::int64_t instant_count = 0;
    double rate = 0.0;  ///< as MotionInfo
  };
  struct Camera {
    std::string name;
    std::string frame;  ///< in the first motion
    int width = 0;      ///< in the first motion [px]
    int height = 0;     ///< in the first motion [px]

    std::optional<CameraModel> model = {};  ///< as CameraDescription
    bool intrinsics_vary = false;           ///< as CameraDescription
  };
  struct Object {
    std::string name;
    int class_id = 0;
    std::string id;

    std::vector<std::string> keypoint_names = {};           ///< as ObjectInfo
    std::vector<std::array<std::size_t, 2>> skeleton = {};  ///< as ObjectInfo
    bool model_varies = false;                              ///< as ObjectInfo
    std::optional<ObjectModel> model = {};                  ///< if a writer has asked for it
    std::vector<std::string> part_names = {};               ///< as ObjectInfo
  };

  std::map<std::string, Setting> settings = {};      ///< by full name
  std::map<std::string, std::string> software = {};  ///< name to version
  std::map<std::string, Input> inputs = {};          ///< by absolute path
  std::map<std::string, Credit> credits = {};        ///< of inputs, where a file states any
  std::vector<Class> classes = {};
  std::vector<std::string> world_classes = {};  ///< as DatasetInfo
  std::vector<Motion> motions = {};             ///< in the order of their scenes
  std::vector<Camera> cameras = {};
  std::vector<Object> objects = {};
  std::vector<SplitInfo> splits = {};
  std::string global_frame = {};
  std::int64_t scene_count = 0;        ///< of the whole run, all shards together
  std::vector<Warning> warnings = {};  ///< about the run as a whole
};

/// Adds what writers know about the dataset, without the models.
void describeContents(const DatasetInfo& dataset, RunDescription& run);

/// Credits in the form that writers receive: each author and licence once, with the files by folder
/// and name, so that the result does not depend on where the inputs are.
[[nodiscard]] std::vector<CreditInfo> creditInfos(
    const std::map<std::string, RunDescription::Credit>& credits);

/// The settings that the user gave, as JSON by full name.
[[nodiscard]] std::map<std::string, std::string> givenSettings(const RunDescription& run);

/// SHA-256 over everything that determines the dataset: the given settings and the inputs.
[[nodiscard]] std::string settingsDigest(const RunDescription& run);

/// The differences in settings, inputs and software, one line for each: empty if one run can resume
/// the dataset of the other.
/// @param before, now  names for the two sides: "then", "now"
[[nodiscard]] std::vector<std::string> differences(const RunDescription& one,
                                                   const RunDescription& other,
                                                   const std::string& before,
                                                   const std::string& now);

}  // namespace synthetic_dataset::output
