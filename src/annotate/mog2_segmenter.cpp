#include "annotate/mog2_segmenter.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::annotate {

void Mog2Segmenter::train(const cv::Mat& background) {
  subtractor_ = cv::createBackgroundSubtractorMOG2(options_.history_length, options_.var_threshold,
                                                   options_.detect_shadows);
  cv::Mat ignored;
  for (int i = 0; i < options_.history_length; ++i) subtractor_->apply(background, ignored);
}

cv::Mat Mog2Segmenter::segment(const cv::Mat& image) {
  if (!subtractor_) throw Error("the background subtractor was used before it was trained");
  constexpr double kLearnNothing = 0.0;
  cv::Mat mask;
  subtractor_->apply(image, mask, kLearnNothing);
  return mask;
}

}  // namespace synthetic_dataset::annotate
