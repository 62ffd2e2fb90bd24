#include "plugins/image_folder/image_folder_card.h"

#include <ostream>

#include "plugins/shared/json.h"

namespace synthetic_dataset {
namespace {

constexpr const char* kColumns = R"(
Columns of `metadata.jsonl`, a line an image. SI units; matrices row by row; `X_AB` is the pose of frame B
in frame A (`p_A = X_AB p_B`); frames: G global, C the camera's optical frame (x right, y down, z ahead),
O the object.

| column | |
| --- | --- |
| `file_name` | the image |
| `mask_file_name` | 16 bit: the `instances` number of the object that is seen, 0 elsewhere |
| `depth_file_name` | 32 bit: z in the optical frame [m], 0 where nothing is |
| `normals_file_name` | red, green, blue: x, y, z in the optical frame, from -1 (0) to 1 (255); black where nothing is |
| `flow_u_file_name`, `flow_v_file_name` | 32 bit: how far what is seen moves to the right and down until the camera's next image [px]; NaN where that is unknown |
| `width`, `height` | of the image [px] |
| `instant`, `stamp_ns` | number of the time, from 0, and the time [ns] |
| `camera` | `name`; `K`, 3 x 3 (a pixel's centre has whole coordinates); `distortion_model` and `D` as in ROS's CameraInfo; `X_GC`, 4 x 4 |
| `objects` | lists with an entry for each object that is seen |
| `bbox` | [x, y, width, height] in an image that spans 0 to its width [px] |
| `categories`, `class_names` | class as a number and by name |
| `names`, `ids`, `instances` | which object; its number in masks |
| `visibility` | visible pixels / pixels of its silhouette, past the image's edge too |
| `truncation` | share of its silhouette outside the image |
| `distance` | from the camera to the origin of its frame [m] |
| `X_CO` | its pose, 4 x 4 |
| `cuboid` | lowest x, y, z and highest x, y, z of the box round it in its frame [m] |
| `keypoints` | [x, y] each, where a pixel's centre has whole coordinates; outside the image too; [0, 0] where it cannot be projected |
| `keypoint_visibility` | 0 not in the image, 1 hidden, 2 visible |
)";

constexpr const char* kPacking = R"(
Each split's folder packs into a WebDataset shard:

    tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --exclude=metadata.jsonl -cf train.tar -C train .
)";

/// Lists the authors with their files: whoever publishes the dataset has to name them.
void writeCredits(std::ostream& file, const std::vector<CreditInfo>& credits) {
  if (credits.empty()) return;
  file << "\nMade of these files, as far as they say who made them and under which licence:\n\n";
  const auto said = [](const std::string& text) {
    return text.empty() ? std::string("not said") : "`" + jsonText(text) + "`";
  };
  for (const CreditInfo& each : credits) {
    file << "- licence " << said(each.license) << ", author " << said(each.author) << ": ";
    for (std::size_t i = 0; i < each.files.size(); ++i) {
      file << (i == 0 ? "" : ", ") << "`" << jsonText(each.files[i]) << "`";
    }
    file << "\n";
  }
}

}  // namespace

void writeCard(std::ostream& file, const DatasetCard& card) {
  file << "---\nconfigs:\n- config_name: default\n  description: \"content " << card.fingerprint
       << "\"\n  data_files:\n";
  for (const SplitInfo& split : card.splits) {
    file << "  - split: " << (split.name == "val" ? "validation" : split.name) << "\n    path:\n";
    file << "    - " << split.name << "/metadata.jsonl\n";
    for (const std::string& extension : card.extensions) {
      file << "    - " << split.name << "/**/*." << extension << "\n";
    }
  }
  file << "task_categories:\n- object-detection\n---\n\n# Dataset card\n\n"
       << "Images and labels made by synthetic_dataset.\n"
       << kColumns << "\nClasses:\n\n";
  for (const ClassInfo& each : card.classes) {
    file << "- " << each.id << ": `" << jsonText(each.name) << "`\n";
  }
  writeCredits(file, card.credits);
  if (card.webdataset) file << kPacking;
}

}  // namespace synthetic_dataset
