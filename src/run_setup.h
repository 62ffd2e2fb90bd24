#pragma once

#include <memory>
#include <string>
#include <vector>

#include "articulation.h"
#include "camera_rig.h"
#include "config/config.h"
#include "motion/frame_motion.h"
#include "object_shapes.h"
#include "output/run_description.h"
#include "scene_arranger.h"
#include "scene_variation.h"
#include "split_plan.h"
#include "synthetic_dataset/value.h"
#include "world/world.h"
#include "writers/writer_host.h"

namespace synthetic_dataset {

/// Everything that a run is made of, checked and ready for the first scene.
struct RunSetup {
  config::Config config;
  std::unique_ptr<motion::FrameMotion> frames;
  motion::Timeline timeline;
  std::unique_ptr<world::World> world;
  std::vector<CameraRig> cameras;
  std::vector<std::vector<DrivenLink>> driven_links;  ///< of each object
  std::unique_ptr<ObjectShapes> shapes;               ///< of the objects
  std::unique_ptr<SceneArranger> arranger;
  std::unique_ptr<SceneVariation> variation;
  std::unique_ptr<SplitPlan> splits;
  std::unique_ptr<writers::WriterHost> writers;
  output::RunDescription description;       ///< for the manifest; with what the user should know
  std::vector<std::string> remarks;         ///< what the user may like to know
  std::vector<std::string> defaults_taken;  ///< "parameter: value"
};

/// Reads parameters, recording, world, camera and writers. Writes nothing.
/// @throws ErrorList with all that is wrong
[[nodiscard]] RunSetup setUpRun(const Value& parameters,
                                const std::vector<std::string>& plugin_xml_files);

}  // namespace synthetic_dataset
