#include "run/setup/run_setup.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "config/motion_list.h"
#include "config/object_count.h"
#include "lidar/ray_bodies.h"
#include "run/check/motion_checks.h"
#include "run/setup/alike_motions.h"
#include "run/setup/balanced_blocks.h"
#include "run/setup/dataset_description.h"
#include "run/setup/input_cache.h"
#include "run/setup/run_record.h"
#include "run/setup/scene_plan.h"
#include "run/setup/scene_shares.h"
#include "run/setup/setup_errors.h"
#include "run/setup/setup_notes.h"
#include "run/setup/split_plan.h"
#include "run/setup/transfer_preset.h"
#include "run/setup/world_objects.h"

namespace synthetic_dataset::run {
namespace {

/// Builds a run part by part; failures are noted, and parts that depend on them are skipped.
class Builder {
 public:
  Builder(const Value& parameters, const std::vector<std::string>& plugin_xml_files,
          InputCache& inputs, const base::OnStage& on_stage, const base::Diagnostics& known)
      : parameters_(parameters),
        plugin_xml_files_(plugin_xml_files),
        inputs_(inputs),
        on_stage_(on_stage),
        list_(config::readMotions(parameters)) {
    setup_.diagnostics.merge(known);
  }

  RunSetup build() {
    for (config::MotionEntry& entry : list_.entries) addMotion(entry);
    setup_.config = setup_.motions.front().config;
    diagnostics().add(base::Severity::kError, list_.errors);
    checkMotionsCompatible(setup_.motions, diagnostics());
    const std::int64_t told_count = countInstants();
    planSplits();
    const std::size_t errors_before = roots_.front().errors().size();
    loadWriters();
    const std::vector<std::string>& of_first = roots_.front().errors();
    writer_errors_.assign(of_first.begin() + static_cast<std::ptrdiff_t>(errors_before),
                          of_first.end());
    for (MotionSetup& motion : setup_.motions) checkFrames(motion);
    if (list_.errors.empty()) shareScenes();
    leaveOutSplitGaps();
    if (countInstants() < told_count) replan();
    checkOnlyScenes();
    noteSurprisingSettings(setup_);
    const std::vector<std::string> unused = unusedSettings(list_.entries, roots_);
    passOverFormats();
    throwErrors();
    describe(unused);
    return std::move(setup_);
  }

 private:
  [[nodiscard]] const config::Config& config() const { return setup_.config; }
  [[nodiscard]] base::Diagnostics& diagnostics() { return setup_.diagnostics; }

  void addMotion(const config::MotionEntry& entry) {
    roots_.emplace_back(entry.settings);
    config::Config config = config::readConfig(roots_.back());
    setting_errors_.push_back(roots_.back().errors());
    setup_.motions.push_back(setUpMotion(entry, std::move(config), inputs_, on_stage_));
  }

  /// Divides the scenes in proportion to the motions' weights, if there are any.
  void shareScenes() {
    if (!list_.is_weighted) return;
    std::vector<SharingMotion> sharing;
    for (const MotionSetup& motion : setup_.motions) {
      if (motion.timeline.stamps.empty()) return;  // reported already
      sharing.push_back({motion.entry.group, motion.entry.weight, motion.instantCount()});
    }
    const auto counts = diagnostics().attempt([&] { return sharesOf(sharing, list_.scenes); });
    if (!counts) return;
    for (std::size_t i = 0; i < counts->size(); ++i) {
      MotionSetup& motion = setup_.motions[i];
      thinOut(motion.timeline, (*counts)[i]);
    }
  }

  /// Numbers the times of all motions consecutively, and returns their count.
  std::int64_t countInstants() {
    std::int64_t count = 0;
    for (MotionSetup& motion : setup_.motions) {
      motion.first_instant = count;
      count += motion.instantCount();
    }
    return count;
  }

  void checkOnlyScenes() {
    const std::set<std::int64_t>& only = config().only_scenes;
    const std::int64_t count = setup_.instantCount();
    if (count == 0 || only.empty() || *only.rbegin() < count) return;
    diagnostics().error("only_scenes", "found " + std::to_string(*only.rbegin()) +
                                           "; this run's scenes are 0 to " +
                                           std::to_string(count - 1));
  }

  void planSplits() {
    std::vector<SplitPart> parts;
    for (std::size_t i = 0; i < setup_.motions.size(); ++i) {
      const MotionSetup& motion = setup_.motions[i];
      parts.push_back({motion.instantCount(), motion.entry.split,
                       i < blocks_.size() ? blocks_[i] : std::vector<std::int64_t>(),
                       i < chosen_.size() ? chosen_[i] : chosenBlocks(motion)});
    }
    const auto plan = diagnostics().attempt([&] {
      return SplitPlan(config().split, static_cast<std::uint64_t>(config().seed), parts);
    });
    if (plan) setup_.splits = std::make_unique<SplitPlan>(*plan);
  }

  /// The share of each time if the recording's blocks are chosen; otherwise empty.
  [[nodiscard]] std::vector<std::uint8_t> chosenBlocks(const MotionSetup& motion) const {
    const config::SplitConfig& split = config().split;
    if (split.by != config::SplitBy::kBalancedBlocks || motion.entry.split) return {};
    return balancedBlocks(split, expectedLabels(motion));
  }

  /// Leaves gaps between the blocks of a recording. If a recording's scenes are drawn one by one
  /// instead, warns the user.
  void leaveOutSplitGaps() {
    const config::SplitConfig& split = config().split;
    const auto isDivided = [&](const MotionSetup& motion) {
      return motion.timeline.is_recorded && !motion.entry.split && split.shares.size() > 1;
    };
    const bool any = std::any_of(setup_.motions.begin(), setup_.motions.end(), isDivided);
    if (any && split.by == config::SplitBy::kScenes) {
      diagnostics().warning(
          "split/by",
          "scenes of a recording are assigned one by one, so those of val and test have "
          "look-alike neighbours in time in train, and results on them are too "
          "good; `by: blocks` with a `gap` keeps them apart");
    }
    if (split.gap <= 0.0 || split.by == config::SplitBy::kScenes) return;
    for (MotionSetup& motion : setup_.motions) {
      blocks_.emplace_back();
      chosen_.push_back(chosenBlocks(motion));
      if (!chosen_.back().empty()) {
        leaveOutGaps(split, motion.timeline, chosen_.back());
      } else if (isDivided(motion)) {
        blocks_.back() = leaveOutGaps(split, motion.timeline);
      }
    }
    if (!any) {
      diagnostics().warning("split/gap",
                            "no recording is divided into splits, so it has no effect");
    }
  }

  [[nodiscard]] DatasetInfo dataset() const {
    return describeDataset(config(), setup_.motions, *setup_.splits);
  }

  const Credits& credits() {
    if (!credits_) credits_ = creditsOf(setup_.motions);
    return *credits_;
  }

  void loadWriters() {
    if (config().writers.empty() || !setup_.splits) return;
    on_stage_("preparing the writers");
    DatasetInfo info = dataset();
    info.credits = output::creditInfos(credits());
    // Keeps the models that writers ask for, as the manifest lists them.
    info.setModels([of_worlds = info, models = models_](std::size_t object) {
      const auto known = models->find(object);
      if (known != models->end()) return known->second;
      return models->emplace(object, of_worlds.model(object)).first->second;
    });
    auto made = diagnostics().attempt([&] {
      return std::make_unique<output::WriterHost>(config().writers, info, plugin_xml_files_);
    });
    if (made) setup_.writers = std::move(*made);
  }

  /// Checks the frames that writers ask for: unknown ones are errors, and scenes without them are
  /// left out.
  void checkFrames(MotionSetup& motion) {
    if (!setup_.writers || !motion.frames) return;
    for (const std::string& frame : setup_.writers->requirements().frames) {
      if (motion.isSensorFrame(frame)) continue;
      if (motion.frames->find(frame)) {
        motion.diagnostics.attempt(
            [&] { leaveOutScenesWithout(frame, *motion.frames, motion.timeline); });
      } else {
        motion.diagnostics.error(
            "", "a writer asks for the frame '" + frame + "': " + motion.frames->lacks(frame));
      }
    }
  }

  /// Ignores the groups of formats that `writers` does not currently name, for example because it
  /// is set on the command line.
  void passOverFormats() {
    if (!setup_.writers) return;
    std::set<std::string> formats;
    for (const std::string& type : setup_.writers->typeNames()) {
      formats.insert(plainName(type.substr(type.rfind('/') + 1)));
    }
    for (Parameters& root : roots_) {
      for (const std::string& name : root.unknownNames()) {
        const bool is_group = name.find('/') == std::string::npos &&
                              formats.count(plainName(name)) &&
                              root.maybe<Value>(name)->is<Value::Map>();
        if (!is_group) continue;
        root.ignore(name);
        diagnostics().note(name, "its settings are not used, as `writers` does not name it");
      }
    }
  }

  /// Maps "PascalVoc" and "pascal_voc" to the same text.
  static std::string plainName(const std::string& name) {
    std::string plain;
    for (const char c : name) {
      if (c != '_') plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return plain;
  }

  /// Reloads the writers after scenes were left out: they were told of more scenes, since only they
  /// know which frames they need.
  void replan() {
    if (!setup_.splits) return;  // reported already
    planSplits();
    if (setup_.writers && writer_errors_.empty()) loadWriters();
  }

  void throwErrors() {
    base::Diagnostics all;
    const auto addErrors = [&](const std::vector<std::string>& errors) {
      all.add(base::Severity::kError, errors);
    };
    std::vector<MotionErrors> of_motions;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      of_motions.push_back({setup_.motions[i].entry.group, setting_errors_[i]});
    }
    addErrors(mergedErrors(of_motions));
    addErrors(writer_errors_);
    // If writers could not be loaded, they have not read their parameters, so none can be called
    // unknown.
    if (setup_.writers && config::isNnDataCollectionFile(parameters_)) {
      for (const std::string& each : unknownParameters(list_.entries, roots_)) {
        diagnostics().warning("", each + "; it is ignored");
      }
    } else if (setup_.writers) {
      addErrors(unknownParameters(list_.entries, roots_));
    }
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      of_motions[i].messages = setup_.motions[i].diagnostics.messages(base::Severity::kError);
    }
    addErrors(mergedErrors(of_motions));
    all.merge(diagnostics());
    if (!all.hasErrors()) return;
    throw ErrorList(explainRelativePaths(all.messages(base::Severity::kError), parameters_));
  }

  /// Describes the run for the manifest and for the user at its start.
  /// @param unused  settings that nobody reads
  void describe(const std::vector<std::string>& unused) {
    output::RunDescription& run = setup_.description;
    std::map<std::string, Value> defaults;
    for (Parameters& root : roots_) {
      defaults.insert(root.defaultValues().begin(), root.defaultValues().end());
      for (const std::string& taken : root.defaultsTaken()) addOnce(setup_.defaults_taken, taken);
    }
    run.settings = usedSettings(parameters_, config(), unused, defaults);
    run.software = softwareVersions();
    if (!config().lidars.empty()) run.software["embree"] = lidar::rayCasterVersion();
    const std::set<std::string> inputs = inputsOf(setup_.motions);
    for (const MotionSetup& motion : setup_.motions) diagnostics().merge(motion.diagnostics);
    on_stage_("computing the checksums of " + std::to_string(inputs.size()) + " input files");
    findOdd();
    run.inputs = inputs_.describe(inputs);
    run.credits = credits();
    output::describeContents(dataset(), run);
    for (const auto& [object, model] : *models_) run.objects.at(object).model = model;
    countLeftOut("scene left out: TF would be interpolated across more than max_tf_gap",
                 &motion::Timeline::left_out_gap);
    countLeftOut("scene left out: in the gap between two splits",
                 &motion::Timeline::left_out_split);
    countLeftOut("scene left out: a transform is not known at its time",
                 &motion::Timeline::left_out_unknown);
    for (const base::Diagnostic& each : diagnostics().all()) {
      if (each.severity == base::Severity::kWarning)
        run.warnings.push_back({each.message(), "", each.count});
    }
  }

  /// Runs the checks that are cheap enough for every run.
  void findOdd() {
    for (const MotionSetup& motion : setup_.motions) {
      std::vector<Finding> findings = joinAlike(checkSetup(motion));
      nameMotion(motion, setup_.motions.size(), findings);
      for (const Finding& each : findings) diagnostics().warning(each.about, each.what());
      setup_.findings.insert(setup_.findings.end(), findings.begin(), findings.end());
    }
  }

  void countLeftOut(const std::string& kind, std::int64_t motion::Timeline::*count) {
    std::int64_t all = 0;
    for (const MotionSetup& motion : setup_.motions) all += motion.timeline.*count;
    if (all > 0) diagnostics().warning("", kind, all);
  }

  static void addOnce(std::vector<std::string>& texts, const std::string& text) {
    if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
  }

  const Value& parameters_;
  const std::vector<std::string>& plugin_xml_files_;
  InputCache& inputs_;
  const base::OnStage& on_stage_;
  config::MotionList list_;
  std::vector<Parameters> roots_;                         ///< of the entries
  std::vector<std::vector<std::string>> setting_errors_;  ///< of the entries' settings
  std::vector<std::string> writer_errors_;                ///< of the writers' settings
  std::vector<std::vector<std::int64_t>> blocks_;         ///< of the motions; empty: by the shares
  std::vector<std::vector<std::uint8_t>> chosen_;         ///< of the motions; empty: not chosen
  std::optional<Credits> credits_;                        ///< determined on first use

  /// The models that writers have asked for, by object.
  std::shared_ptr<std::map<std::size_t, ObjectModel>> models_ =
      std::make_shared<std::map<std::size_t, ObjectModel>>();

  RunSetup setup_;
};

Value counted(const Value& parameters) {
  const auto* settings = parameters.as<Value::Map>();
  return settings == nullptr ? parameters : Value(config::withCounts(*settings));
}

RunSetup built(const Value& parameters, const std::vector<std::string>& plugin_xml_files,
               InputCache& inputs, const base::OnStage& on_stage) {
  const SpelledWorldObjects of_world = spellOutWorldObjects(counted(parameters), inputs);
  const Value& given = of_world.settings;
  const ExpandedPreset spelled = expandPreset(given, inputs);
  RunSetup setup = [&] {
    try {
      return Builder(spelled.settings, plugin_xml_files, inputs, on_stage, of_world.diagnostics)
          .build();
    } catch (const ErrorList& errors) {
      throw ErrorList(explainPreset(errors.messages(), given, spelled.settings));
    }
  }();
  for (const std::string& note : spelled.notes) {
    setup.diagnostics.note("randomize/preset", note);
  }
  return setup;
}

}  // namespace

std::int64_t RunSetup::instantCount() const {
  return motions.back().first_instant + motions.back().instantCount();
}

Value spelledOut(const Value& parameters) {
  InputCache inputs;
  return expandPreset(spellOutWorldObjects(counted(parameters), inputs).settings, inputs).settings;
}

RunSetup setUpRun(const Value& parameters, const std::vector<std::string>& plugin_xml_files,
                  const base::OnStage& on_stage) {
  InputCache inputs(on_stage);
  return built(parameters, plugin_xml_files, inputs, on_stage);
}

RunSetup setUpRun(const Value& parameters, InputCache& inputs,
                  const std::vector<std::string>& plugin_xml_files, const base::OnStage& on_stage) {
  inputs.worlds.beginUse();
  try {
    RunSetup setup = built(parameters, plugin_xml_files, inputs, on_stage);
    if (inputs.worlds.isAsFresh()) return setup;
  } catch (const Error&) {
    if (inputs.worlds.isAsFresh()) throw;
  }
  // A different set of models has been requested, so the cache still has notes about earlier ones.
  inputs.worlds.clear();
  return built(parameters, plugin_xml_files, inputs, on_stage);
}

}  // namespace synthetic_dataset::run
