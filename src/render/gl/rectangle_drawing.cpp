#include "render/gl/rectangle_drawing.h"

#include <algorithm>

namespace synthetic_dataset::render {

void RectangleDrawing::draw(const ShaderProgram& program, const std::vector<cv::Rect>& rectangles,
                            const cv::Size& picture) const {
  constexpr std::size_t kMost = SYNTHETIC_DATASET_MAX_RECTANGLES;
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(no_vertices_.name());
  program.use();
  const Eigen::Vector2f scale(2.0F / static_cast<float>(picture.width),
                              2.0F / static_cast<float>(picture.height));
  for (std::size_t first = 0; first < rectangles.size(); first += kMost) {
    const std::size_t count = std::min(kMost, rectangles.size() - first);
    std::vector<Eigen::Vector4f> places;
    for (std::size_t i = first; i < first + count; ++i) {
      const cv::Rect& each = rectangles[i];
      places.emplace_back(static_cast<float>(each.x) * scale.x() - 1.0F,
                          static_cast<float>(each.y) * scale.y() - 1.0F,
                          static_cast<float>(each.x + each.width) * scale.x() - 1.0F,
                          static_cast<float>(each.y + each.height) * scale.y() - 1.0F);
    }
    program.set("rectangles", places);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  }
}

}  // namespace synthetic_dataset::render
