#include "motion/recorded_pictures.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "base/image/picture_decoder.h"
#include "motion/checked_messages.h"
#include "motion/ros_time.h"
#include "motion/time_text.h"
#include "motion/topic_search.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Where a message is: the `rank`-th of its topic that was recorded then.
struct PicturePlace {
  std::size_t bag = 0;
  ros::Time recorded;
  std::size_t rank = 0;
};

struct FoundPicture {
  PictureHead head;
  PicturePlace place;
};

/// A message's picture, with its stamp.
std::pair<Stamp, RecordedPicture> pictureOf(const rosbag::MessageInstance& message) {
  if (const auto raw = message.instantiate<RecordedImage>()) {
    sensor_msgs::Image& image = raw->message;
    return {toStamp(image.header.stamp),
            base::RawPicture{image.width, image.height, image.encoding, image.is_bigendian != 0,
                             image.step, std::move(image.data)}};
  }
  const auto file = message.instantiate<RecordedImageFile>();
  if (!file) throw Error("a message of '" + message.getTopic() + "' is no picture");
  return {toStamp(file->message.header.stamp),
          PictureFile{file->message.format, std::move(file->message.data)}};
}

PictureHead headOf(Stamp stamp, const RecordedPicture& picture, const std::string& topic) {
  PictureHead head{stamp};
  if (const auto* raw = std::get_if<base::RawPicture>(&picture)) {
    head.problem = base::pictureProblem(*raw).value_or("");
    if (!head.problem.empty()) return head;
    head.width = raw->width;
    head.height = raw->height;
    return head;
  }
  const auto& file = std::get<PictureFile>(picture);
  try {
    const base::PictureSize size = base::checkPicture(file.bytes, topic);
    head.width = static_cast<std::uint32_t>(size.width);
    head.height = static_cast<std::uint32_t>(size.height);
  } catch (const Error& error) {
    head.problem = "of format '" + file.format + "' " + error.what();
  }
  return head;
}

/// Refuses stamps that go back, as then two pictures of different moments may have the same stamp.
void checkOrder(std::vector<FoundPicture>& found) {
  constexpr Duration kLate = std::chrono::seconds(1);  // what only came late
  std::stable_sort(found.begin(), found.end(), [](const FoundPicture& a, const FoundPicture& b) {
    return a.place.recorded < b.place.recorded;
  });
  Stamp latest{0};
  for (const FoundPicture& each : found) {
    if (each.head.stamp == Stamp{0}) {
      throw Error("its picture recorded at " + secondsText(toStamp(each.place.recorded)) +
                  " has no stamp in its header; without stamps nobody knows when pictures were "
                  "taken");
    }
    if (each.head.stamp + kLate < latest) {
      throw Error("the stamps of its pictures go back from " + secondsText(latest) + " to " +
                  secondsText(each.head.stamp) +
                  ", as when a simulation is reset; bag_file should name a recording without that "
                  "(`rosbag filter` cuts bags)");
    }
    latest = std::max(latest, each.head.stamp);
  }
}

}  // namespace

struct RecordedPictures::Impl {
  /// @param names  of the topic in the bag, with or without a slash
  void take(std::size_t bag, rosbag::View& messages, std::vector<FoundPicture>& found) {
    ros::Time last;
    std::size_t rank = 0;
    for (const rosbag::MessageInstance& message : messages) {
      names[bag].insert(message.getTopic());
      rank = message.getTime() == last ? rank + 1 : 0;
      last = message.getTime();
      const auto [stamp, picture] = pictureOf(message);
      found.push_back({headOf(stamp, picture, topic), {bag, last, rank}});
    }
  }

  void keep(std::vector<FoundPicture> found) {
    checkOrder(found);
    std::stable_sort(found.begin(), found.end(), [](const FoundPicture& a, const FoundPicture& b) {
      return a.head.stamp < b.head.stamp;
    });
    for (FoundPicture& each : found) {
      if (!heads.empty() && heads.back().stamp == each.head.stamp) {
        ++repeated;
        continue;
      }
      heads.push_back(std::move(each.head));
      places.push_back(each.place);
    }
  }

  RecordedPicture read(std::size_t index) {
    const PicturePlace& place = places.at(index);
    const std::lock_guard<std::mutex> lock(mutex);
    auto& bag = bags[place.bag];
    try {
      if (!bag) bag = std::make_unique<rosbag::Bag>(files[place.bag]);
      const std::vector<std::string> topics(names.at(place.bag).begin(), names.at(place.bag).end());
      rosbag::View messages(*bag, rosbag::TopicQuery(topics), place.recorded, place.recorded);
      std::size_t rank = 0;
      for (const rosbag::MessageInstance& message : messages) {
        if (rank++ == place.rank) return pictureOf(message).second;
      }
    } catch (const std::exception& error) {
      throw Error("bag " + files[place.bag] + ": " + error.what());
    }
    throw Error("bag " + files[place.bag] + ": " + pictureName(topic, heads[index].stamp) +
                " is not there any more");
  }

  std::vector<std::string> files;
  std::string topic;
  std::map<std::size_t, std::set<std::string>> names;  ///< of the topic, by bag
  std::vector<PictureHead> heads;
  std::vector<PicturePlace> places;  ///< of heads
  std::int64_t repeated = 0;
  std::mutex mutex;
  std::map<std::size_t, std::unique_ptr<rosbag::Bag>> bags;  ///< those that were opened
};

RecordedPictures::RecordedPictures(const std::vector<std::string>& bag_files,
                                   const std::string& topic)
    : impl_(std::make_unique<Impl>()) {
  impl_->files = bag_files;
  impl_->topic = topic;
  auto search = TopicSearch::of<sensor_msgs::Image, sensor_msgs::CompressedImage>(topic);
  std::vector<FoundPicture> found;
  for (std::size_t bag = 0; bag < bag_files.size(); ++bag) {
    search.in(bag_files[bag], [&](rosbag::View& messages) { impl_->take(bag, messages, found); });
  }
  if (found.empty()) throw search.notFound();
  try {
    impl_->keep(std::move(found));
  } catch (const Error& error) {
    throw Error("found '" + topic + "'; " + error.what());
  }
}

RecordedPictures::~RecordedPictures() = default;
RecordedPictures::RecordedPictures(RecordedPictures&&) noexcept = default;
RecordedPictures& RecordedPictures::operator=(RecordedPictures&&) noexcept = default;

const std::string& RecordedPictures::topic() const { return impl_->topic; }

const std::vector<PictureHead>& RecordedPictures::heads() const { return impl_->heads; }

std::int64_t RecordedPictures::repeatedCount() const { return impl_->repeated; }

RecordedPicture RecordedPictures::read(std::size_t index) const { return impl_->read(index); }

std::string pictureName(const std::string& topic, Stamp stamp) {
  return "the picture of '" + topic + "' at " + secondsText(stamp);
}

}  // namespace synthetic_dataset::motion
