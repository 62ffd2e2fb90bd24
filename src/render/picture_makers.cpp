#include "render/picture_makers.h"

#include <future>
#include <memory>
#include <utility>

namespace synthetic_dataset::render {

PendingPicture PictureMakers::begun(PendingPicture picture) {
  const auto make =
      std::make_shared<std::packaged_task<cv::Mat()>>([picture = std::move(picture)]() mutable {
        return std::exchange(picture, {})();  // frees what it was made of
      });
  std::shared_future<cv::Mat> made = make->get_future().share();
  std::optional<base::BackgroundWorker>& worker = workers_.at(next_++ % workers_.size());
  if (!worker) worker.emplace(1);
  worker->add([make] { (*make)(); });
  return [made = std::move(made)] { return made.get(); };
}

}  // namespace synthetic_dataset::render
