#include "programs/preview/preview_node.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <ros/init.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>
#include <Eigen/Geometry>

#include "base/json_text.h"
#include "programs/console/console_reporter.h"
#include "programs/preview/preview_control.h"
#include "run/scene_loop.h"
#include "run/scene_sink.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::programs {
namespace {

/// Shows the scenes of a run from an instant on, each when its turn comes, and writes nothing.
class PreviewSink : public run::SceneSink {
 public:
  /// @param control  has to outlive this
  /// @param show  receives each scene when it is its turn, in the thread that adds it
  PreviewSink(PreviewControl& control, std::int64_t first_instant, const Requirements& requirements,
              std::function<void(const Scene&)> show);

  [[nodiscard]] Requirements requirements() const override { return requirements_; }
  void begin(const DatasetInfo& dataset) override;
  [[nodiscard]] bool wants(std::int64_t scene) const override;
  [[nodiscard]] std::vector<base::Warning> add(const run::FinishedScene& finished) override;
  void finish(run::RunEnd /*end*/) override {}

 private:
  PreviewControl& control_;
  std::int64_t first_instant_;
  Requirements requirements_;
  std::function<void(const Scene&)> show_;
  std::int64_t camera_count_ = 1;
};

PreviewSink::PreviewSink(PreviewControl& control, std::int64_t first_instant,
                         const Requirements& requirements, std::function<void(const Scene&)> show)
    : control_(control),
      first_instant_(first_instant),
      requirements_(requirements),
      show_(std::move(show)) {}

void PreviewSink::begin(const DatasetInfo& dataset) {
  camera_count_ = static_cast<std::int64_t>(dataset.cameras.size());
}

bool PreviewSink::wants(std::int64_t scene) const {
  return scene / camera_count_ >= first_instant_;
}

std::vector<base::Warning> PreviewSink::add(const run::FinishedScene& finished) {
  if (control_.awaitTurn(finished.scene.instant)) show_(finished.scene);
  return {};
}

constexpr double kFirstRate = 5.0;  // [Hz]

std::string nameOf(PreviewControl::State state) {
  switch (state) {
    case PreviewControl::State::kLoading:
      return "loading";
    case PreviewControl::State::kPaused:
      return "standing";
    case PreviewControl::State::kPlaying:
      return "playing";
  }
  return "";
}

/// The middle of all objects that have a pose, and how far they reach from it [m].
Value::Map ballAround(const std::vector<SceneObject>& objects) {
  Eigen::AlignedBox3d box;
  for (const SceneObject& object : objects) {
    if (!object.X_GO) continue;
    for (const Eigen::Vector3d& corner_O : object.cuboid_O.corners())
      box.extend(*object.X_GO * corner_O);
  }
  if (box.isEmpty()) return {};
  const Eigen::Vector3d middle = box.center();
  return {{"middle", Value(Value::List{Value(middle.x()), Value(middle.y()), Value(middle.z())})},
          {"reach", Value(0.5 * box.diagonal().norm())}};
}

/// Prints warnings on the console; another order stops the loop.
class PreviewReporter : public run::Reporter {
 public:
  explicit PreviewReporter(const PreviewControl& control) : control_(control) {}
  void warning(const std::string& message) override { console_.warning(message); }
  [[nodiscard]] bool stopRequested() const override { return control_.isInterrupted(); }

 private:
  const PreviewControl& control_;
  ConsoleReporter console_;
};

}  // namespace

PreviewNode::PreviewNode(ros::NodeHandle& node, std::function<Value()> read_settings)
    : node_(node),
      read_settings_(std::move(read_settings)),
      control_([] { return !ros::ok(); }, kFirstRate),
      topics_(node, node.param<std::string>("frame_prefix", "preview/"),
              [this] { control_.makeAgain(); }),
      status_(node.advertise<std_msgs::String>("status", 4, true)) {
  offer("step", [this] { control_.step(); });
  offer("step_back", [this] { control_.stepBack(); });
  offer("play", [this] { control_.play(); });
  offer("pause", [this] { control_.pause(); });
  offer("reload", [this] { control_.reload(); });
  const auto jump = [this](const std_msgs::Int64ConstPtr& to) { control_.jumpTo(to->data); };
  subscribers_.push_back(node.subscribe<std_msgs::Int64>("jump_to_instant", 4, jump));
  const auto jump_to_time = [this](const std_msgs::TimeConstPtr& to) { jumpToTime(*to); };
  subscribers_.push_back(node.subscribe<std_msgs::Time>("jump_to_time", 4, jump_to_time));
  const auto set_rate = [this](const std_msgs::Float64ConstPtr& rate) { setRate(*rate); };
  subscribers_.push_back(node.subscribe<std_msgs::Float64>("rate", 4, set_rate));
}

void PreviewNode::offer(const std::string& service, std::function<void()> command) {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;
  const boost::function<bool(Request&, Response&)> answer =
      [this, command = std::move(command)](Request& /*request*/, Response& response) {
        command();
        publishStatus();
        response.success = 1U;
        return true;
      };
  services_.push_back(node_.advertiseService(service, answer));
}

void PreviewNode::jumpToTime(const std_msgs::Time& message) {
  const Stamp wanted(static_cast<Stamp::rep>(message.data.toNSec()));
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto distance = [&](Stamp time) { return time < wanted ? wanted - time : time - wanted; };
  const auto nearest = std::min_element(
      times_.begin(), times_.end(), [&](Stamp a, Stamp b) { return distance(a) < distance(b); });
  if (nearest != times_.end()) control_.jumpTo(nearest - times_.begin());
}

void PreviewNode::setRate(const std_msgs::Float64& message) {
  try {
    control_.setRate(message.data);
  } catch (const Error& error) {
    ConsoleReporter().warning(std::string("rate: ") + error.what());
  }
}

void PreviewNode::run() {
  while (const auto order = control_.awaitOrder()) {
    try {
      publishStatus();
      carryOut(*order);
      publishStatus();
    } catch (const ErrorList& errors) {
      for (const std::string& each : errors.messages()) ConsoleReporter::fatal(each);
      publishStatus(errors.messages().front());
    } catch (const std::exception& error) {
      ConsoleReporter::fatal(error.what());
      publishStatus(error.what());
    }
  }
}

void PreviewNode::carryOut(const PreviewControl::Order& order) {
  if (order.reads_settings) settings_ = read_settings_();
  PreviewReporter reporter(control_);
  run::RunSetup setup = run::setUpRun(settings_, inputs_, {});
  if (order.reads_settings) {
    for (const base::Diagnostic& each : setup.diagnostics.all()) {
      if (each.severity == base::Severity::kWarning) reporter.warning(each.message());
    }
  }
  topics_.open(setup);
  keepRun(setup);
  PreviewSink sink(control_, std::min(order.instant, setup.instantCount() - 1),
                   topics_.takeRequirements(), [this](const Scene& scene) { show(scene); });
  run::SceneLoop(setup, sink, reporter).run();
}

void PreviewNode::keepRun(const run::RunSetup& setup) {
  Value::List cameras;
  for (const std::string& topic : topics_.cameraTopics()) cameras.emplace_back(topic);
  const std::lock_guard<std::mutex> lock(mutex_);
  of_run_ = {{"frame", Value(setup.config.global_frame)}, {"cameras", Value(cameras)}};
  times_.clear();
  for (const run::MotionSetup& motion : setup.motions) {
    times_.insert(times_.end(), motion.timeline.stamps.begin(), motion.timeline.stamps.end());
  }
}

void PreviewNode::show(const Scene& scene) {
  topics_.show(scene);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shown_.emplace(scene.camera);
    shown_->name = scene.name;
    shown_->instant = scene.instant;
    shown_->stamp = scene.stamp;
    surroundings_ = ballAround(scene.objects);
  }
  publishStatus();
}

void PreviewNode::publishStatus(const std::string& error) {
  Value::Map status = {{"state", Value(error.empty() ? nameOf(control_.state()) : "error")}};
  if (!error.empty()) status["error"] = Value(error);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& of_status : {of_run_, surroundings_})
      status.insert(of_status.begin(), of_status.end());
    status["instants"] = Value(static_cast<std::int64_t>(times_.size()));
    if (shown_) {
      status["scene"] = Value(shown_->name);
      status["instant"] = Value(shown_->instant);
      status["time"] = Value(toSeconds(shown_->stamp));
    }
  }
  std_msgs::String message;
  message.data = base::jsonText(Value(status));
  status_.publish(message);
}

}  // namespace synthetic_dataset::programs
