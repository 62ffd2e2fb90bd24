#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"
#include "support/tiny_run.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// A scene as listed in the manifest.
struct ListedScene {
  std::int64_t instant;
  std::int64_t milliseconds;  ///< its stamp
  int width, height;          ///< [px]
  std::string split;
};

/// A motion as listed in the manifest.
struct ListedMotion {
  std::string name;
  std::int64_t first_instant, instant_count;

  friend bool operator==(const ListedMotion& a, const ListedMotion& b) {
    return a.name == b.name && a.first_instant == b.first_instant &&
           a.instant_count == b.instant_count;
  }
};

/// A tiny run (4 scenes, all with exact masks) and the files that its other motions may use:
///   other.bag   half a second, 2 scenes: alpha stands, bravo drives
///   lone.bag    the tiny bag without bravo
///   below.bag   the tiny bag with bravo standing below the ball
///   yard.world  the tiny world on a green floor
///   lone.world  the tiny world without bravo
///   wide.yaml   a camera of 320 x 100 pixels, with distortion
/// All are in its folder, which is written `DIR` in the YAML texts.
class MotionsRun {
 public:
  MotionsRun();

  [[nodiscard]] std::string folder() const { return (tiny_.folder() / "out").string(); }

  /// A setting of the run, as YAML.
  void set(const std::string& name, const std::string& text);

  /// The list `motions`, as YAML.
  void list(const std::string& entries) { set("motions", entries); }

  /// Runs with the settings made so far; replaces an older dataset.
  run::RunSummary run(run::Reporter& reporter) const;
  run::RunSummary run() const;

  /// Runs, and reads all files of the dataset but its manifest.
  [[nodiscard]] std::map<std::string, std::string> files() const;

  /// The errors with which the run refuses to begin.
  [[nodiscard]] std::vector<std::string> errors() const;

  [[nodiscard]] std::vector<ListedScene> scenes() const;
  [[nodiscard]] std::vector<ListedMotion> motions() const;

  /// `00000012` of 12.
  [[nodiscard]] static std::string number(std::int64_t scene);

  Value::Map parameters;

 private:
  TinyRun tiny_;
};

}  // namespace synthetic_dataset::test
