#include "programs/drawing/video_file.h"

#include <cstdlib>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "base/sandbox/sandboxed_program.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::programs {
namespace video_file_test {

using testing::ElementsAre;
using testing::HasSubstr;

cv::Mat picture(int width, int height, double brightness) {
  return {height, width, CV_8UC3, cv::Scalar::all(brightness)};
}

/// Width, height and number of pictures, as ffmpeg's own tool reads them.
std::string lookedAt(const std::string& file) {
  const auto result = base::runSandboxedProgram(
      {"ffprobe", "-v", "error", "-count_frames", "-show_entries",
       "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", file},
      {});
  return std::get<base::ProgramResult>(result).output;
}

TEST(VideoFile, HasEachPictureInTheSizeOfTheFirst) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "film.mp4").string();
  VideoFile film(file, 12.5);
  for (const double brightness : {0.0, 100.0, 200.0}) film.add(picture(64, 48, brightness));
  film.add(picture(30, 200, 50.0));
  film.finish();
  EXPECT_EQ(lookedAt(file), "64,48,25/2,4\n");
}

TEST(VideoFile, GetsEvenSizesThatPlayersNeed) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "film.mp4").string();
  VideoFile film(file, 10.0);
  film.add(picture(33, 21, 100.0));
  film.finish();
  EXPECT_EQ(lookedAt(file), "34,22,10/1,1\n");
}

TEST(VideoFile, NeedsAPicture) {
  const test::TemporaryFolder folder;
  VideoFile film((folder / "film.mp4").string(), 10.0);
  EXPECT_THAT(test::messagesOf([&] { film.finish(); }),
              ElementsAre(HasSubstr("there are no pictures")));
}

TEST(VideoFile, SaysThatItCannotBeWritten) {
  const test::TemporaryFolder folder;
  VideoFile film((folder / "no_folder/film.mp4").string(), 10.0);
  EXPECT_THAT(test::messagesOf([&] {
                for (int i = 0; i < 100; ++i) film.add(picture(640, 480, 0.0));
                film.finish();
              }),
              ElementsAre(HasSubstr("no_folder/film.mp4': ffmpeg has ")));
}

TEST(VideoFile, SaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  VideoFile film("film.mp4", 10.0);
  const auto messages = test::messagesOf([&] { film.add(picture(4, 4, 0.0)); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(messages,
              ElementsAre(HasSubstr("cannot start ffmpeg: No such file or directory; `sudo apt-get "
                                    "install ffmpeg` installs it")));
}

}  // namespace video_file_test
}  // namespace synthetic_dataset::programs
