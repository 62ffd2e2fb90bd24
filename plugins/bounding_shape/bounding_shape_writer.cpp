#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// 3D labels: `N.png` and, with one line per object, `N.txt`: the id, then x, y, z [m] of each
/// vertex of the bounding shape in the frame `output_frame`, for objects in view and out of view
/// alike.
class BoundingShapeWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    parameters.ignore("tf_timeout");  // a parameter of nn_data_collection
    output_frame_ = parameters.required<std::string>("output_frame");
    global_frame_ = dataset.global_frame;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.frames = {output_frame_};
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const Pose X_FG = scene.transform(output_frame_, global_frame_);  // F: the output frame
    std::string labels;
    for (const SceneObject& object : scene.objects) {
      if (!object.X_GO || object.dropped) continue;
      const Pose X_FO = X_FG * *object.X_GO;
      labels += object.id;
      for (const Eigen::Vector3d& vertex_O : object.bounding_shape_O) {
        const Eigen::Vector3d vertex_F = X_FO * vertex_O;
        for (int axis = 0; axis < 3; ++axis) labels += " " + fixed(vertex_F[axis], 5);
      }
      labels += "\n";
    }
    output.addImage(scene.name + ".png", scene.image);
    output.addText(scene.name + ".txt", labels);
  }

  std::string output_frame_;
  std::string global_frame_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::BoundingShapeWriter, synthetic_dataset::LabelWriter)
