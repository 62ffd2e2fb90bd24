#include "output/scene_contents.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::output {
namespace scene_contents_test {

using testing::ElementsAre;

OutputFile imageFile(const std::string& path, const cv::Mat& pixels,
                     std::vector<cv::Vec3b> palette = {}) {
  return {0, path, pixels, "", std::move(palette)};
}

/// For each content, the files that have it.
std::vector<std::vector<std::size_t>> sharesOf(const std::vector<OutputFile>& files) {
  std::vector<std::vector<std::size_t>> shares;
  for (const SceneContent& content : encodeScene(files, {})) shares.push_back(content.files);
  return shares;
}

TEST(SceneContents, EncodesOnePictureOnce) {
  const cv::Mat pixels(4, 4, CV_8UC1, cv::Scalar(1));
  EXPECT_THAT(sharesOf({imageFile("a.png", pixels), imageFile("b.png", pixels)}),
              ElementsAre(ElementsAre(0, 1)));
}

TEST(SceneContents, EncodesEqualPicturesOnce) {
  const cv::Mat pixels(40, 60, CV_8UC1, cv::Scalar(1));
  cv::Mat other = pixels.clone();
  other.at<uchar>(39, 59) = 2;
  const cv::Mat part = cv::Mat(80, 80, CV_8UC1, cv::Scalar(1))(cv::Rect(5, 7, 60, 40));
  EXPECT_THAT(sharesOf({imageFile("a.png", pixels), imageFile("b.png", pixels.clone()),
                        imageFile("c.png", other), imageFile("d.png", part),
                        imageFile("e.png", pixels.reshape(1, 60))}),
              ElementsAre(ElementsAre(0, 1, 3), ElementsAre(2), ElementsAre(4)));
}

TEST(SceneContents, TellsIndicesFromGreys) {
  const cv::Mat pixels(4, 4, CV_8UC1, cv::Scalar(1));
  const std::vector<cv::Vec3b> palette = {{0, 0, 0}, {1, 2, 3}};
  EXPECT_THAT(sharesOf({imageFile("a.png", pixels), imageFile("b.png", pixels, palette),
                        imageFile("c.png", pixels, palette),
                        imageFile("d.png", pixels, {{0, 0, 0}, {1, 2, 4}})}),
              ElementsAre(ElementsAre(0), ElementsAre(1, 2), ElementsAre(3)));
}

TEST(SceneContents, EncodesAPictureOnceForEachFormat) {
  const cv::Mat pixels(4, 4, CV_8UC1, cv::Scalar(1));
  EXPECT_THAT(sharesOf({imageFile("a.png", pixels), imageFile("b.tiff", pixels),
                        imageFile("c.tif", pixels)}),
              ElementsAre(ElementsAre(0), ElementsAre(1, 2)));
}

TEST(SceneContents, AMaskIsItsWholeImageEncodedOnce) {
  cv::Mat image = cv::Mat::zeros(40, 60, CV_8UC1);
  image(cv::Rect(7, 9, 5, 3)).setTo(255);
  OutputFile first;
  first.path = "a.png";
  first.mask = Mask(image);
  OutputFile second = first;
  second.path = "b.png";
  const OutputFile whole = imageFile("c.png", image);
  OutputFile empty = first;
  empty.path = "d.png";
  empty.mask = Mask(image.size());
  EXPECT_THAT(sharesOf({first, second, whole, empty}),
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3)));
}

}  // namespace scene_contents_test
}  // namespace synthetic_dataset::output
