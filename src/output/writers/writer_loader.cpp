#include "output/writers/writer_loader.h"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <vector>

#include <console_bridge/console.h>
#include <pluginlib/class_loader.hpp>

#include "base/name_list.h"
#include "base/plugin_mutex.h"
#include "base/ros_packages.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::output {
namespace {

/// Keeps other threads from working with plugins, and class_loader from printing what it throws.
class PluginWork {
 public:
  PluginWork() : lock_(base::pluginMutex()), level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  }
  ~PluginWork() { console_bridge::setLogLevel(level_); }
  PluginWork(const PluginWork&) = delete;
  PluginWork& operator=(const PluginWork&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  console_bridge::LogLevel level_;
};

std::string trimmed(const std::string& text) {
  constexpr const char* kSpace = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

void refuseMissingFiles(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      throw Error("there is no plugin description '" + file + "'");
    }
  }
}

std::string unknownType(const std::string& type, const std::vector<std::string>& types) {
  const bool has_package = type.find('/') != std::string::npos;
  return "there is no writer type '" + type + "'" +
         didYouMean(has_package ? type : "synthetic_dataset/" + type, types) +
         " (available types: " + base::listed(types) + ")";
}

using PluginLoader = pluginlib::ClassLoader<LabelWriter>;

std::unique_ptr<PluginLoader> makeLoader(const std::vector<std::string>& files) {
  refuseMissingFiles(files);
  shortenPackageSearch();
  const PluginWork work;
  try {
    return std::make_unique<PluginLoader>("synthetic_dataset", "synthetic_dataset::LabelWriter",
                                          "plugin", files);
  } catch (const pluginlib::PluginlibException& exception) {
    throw Error(std::string("cannot search for writers: ") + exception.what() +
                "; is the workspace's setup file sourced?");
  }
}

}  // namespace

std::string soundPackagePath(const std::string& package_path) {
  const bool all_sound = base::findRosPackages(package_path).broken.empty();
  std::string result;
  const auto add = [&](const std::string& entry) { result += (result.empty() ? "" : ":") + entry; };
  std::istringstream entries(package_path);
  for (std::string entry; std::getline(entries, entry, ':');) {
    const base::RosPackages inside = all_sound ? base::RosPackages() : base::findRosPackages(entry);
    const std::vector<std::filesystem::path> installed = base::installedPackages(entry);
    if (!inside.broken.empty()) {
      for (const base::RosPackage& package : inside.sound) add(package.folder.string());
    } else if (!installed.empty()) {
      for (const std::filesystem::path& package : installed) add(package.string());
    } else {
      add(entry);
    }
  }
  return result;
}

void shortenPackageSearch() {
  const char* path = getenv("ROS_PACKAGE_PATH");
  if (path != nullptr) setenv("ROS_PACKAGE_PATH", soundPackagePath(path).c_str(), 1);
}

struct WriterLoader::Impl {
  explicit Impl(const std::vector<std::string>& files) : loader(makeLoader(files)) {}

  std::unique_ptr<PluginLoader> loader;
};

WriterLoader::WriterLoader(const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(plugin_xml_files)) {}

WriterLoader::~WriterLoader() {
  const PluginWork work;
  impl_.reset();
}

WriterLoader::Instance WriterLoader::create(const std::string& type) {
  PluginLoader& loader = *impl_->loader;
  if (!loader.isClassAvailable(type)) throw Error(unknownType(type, loader.getDeclaredClasses()));
  const PluginWork work;
  try {
    return loader.createUniqueInstance(type);
  } catch (const pluginlib::PluginlibException& exception) {
    throw Error("the writer type '" + type + "' of package '" + loader.getClassPackage(type) +
                "' cannot be loaded, as '" + loader.getPluginManifestPath(type) +
                "' describes it: " + exception.what());
  }
}

std::vector<std::string> WriterLoader::typeNames() const {
  return impl_->loader->getDeclaredClasses();
}

std::vector<WriterType> WriterLoader::types() {
  PluginLoader& loader = *impl_->loader;
  std::vector<WriterType> types;
  for (const std::string& name : loader.getDeclaredClasses()) {
    WriterType type{name, trimmed(loader.getClassDescription(name)), loader.getClassPackage(name),
                    ""};
    try {
      (void)create(name);
    } catch (const Error& error) {
      type.problem = error.what();
    }
    types.push_back(std::move(type));
  }
  return types;
}

}  // namespace synthetic_dataset::output
