#include "plugins/nuscenes/nuscenes_samples.h"

#include <algorithm>
#include <iterator>

namespace synthetic_dataset::nuscenes {

std::string Sample::token() const { return nuScenesToken(NuScenesTable::kSample, first->instant); }

std::string Sample::tokenOf(std::int64_t object) const {
  return nuScenesToken(NuScenesTable::kSampleAnnotation, first->instant, object);
}

std::string Samples::Chain::add(std::int64_t first, std::int64_t second, std::string& next,
                                const std::string& token) {
  auto& [last_token, last_next] = last_[{first, second}];
  if (last_next != nullptr) *last_next = token;
  last_next = &next;
  return std::exchange(last_token, token);
}

Samples::Samples(const DatasetInfo& dataset, const std::vector<Frame>& frames,
                 const NuScenesOptions& options)
    : dataset_(dataset) {
  for (const Frame& frame : frames) {
    if (isNuScenesKeyframe(dataset, options, frame.instant)) {
      addKeyframe(frame);
    } else {
      waiting_[frame.sequence].push_back({&frame, false, {}, {}});
    }
  }
  for (auto& [sequence, data] : waiting_) {
    const auto last = last_.find(sequence);
    if (last == last_.end()) continue;
    std::move(data.begin(), data.end(), std::back_inserter(last->second->data));
  }
  leaveOutFewPoints(options.min_points);
  for (const auto& sample : all_) link(*sample);
}

void Samples::addKeyframe(const Frame& frame) {
  if (all_.empty() || all_.back()->first->instant != frame.instant) {
    all_.push_back(std::make_unique<Sample>());
    all_.back()->first = &frame;
    all_.back()->data = std::exchange(waiting_[frame.sequence], {});
    last_[frame.sequence] = all_.back().get();
  }
  Sample& sample = *all_.back();
  sample.data.push_back({&frame, true, {}, {}});
  for (const SeenObject& each : frame.objects) {
    Annotation& annotation = sample.annotations[each.object];
    if (annotation.seen == nullptr) annotation.seen = &each;
    annotation.visibility = std::max(annotation.visibility, each.visibility);
    annotation.pixels += each.pixels;
    annotation.points += each.points;
  }
}

void Samples::leaveOutFewPoints(std::int64_t min_points) {
  for (const auto& sample : all_) {
    auto& annotations = sample->annotations;
    for (auto each = annotations.begin(); each != annotations.end();) {
      each = each->second.points < min_points ? annotations.erase(each) : std::next(each);
    }
  }
}

void Samples::link(Sample& sample) {
  const std::int64_t sequence = sample.first->sequence;
  sample.prev = samples_.add(sequence, 0, sample.next, sample.token());
  for (SensorData& each : sample.data) {
    each.prev =
        data_.add(sequence, each.frame->camera, each.next, dataToken(dataset_, *each.frame));
  }
  for (auto& [object, annotation] : sample.annotations) {
    annotation.prev = annotations_.add(sequence, object, annotation.next, sample.tokenOf(object));
  }
}

}  // namespace synthetic_dataset::nuscenes
