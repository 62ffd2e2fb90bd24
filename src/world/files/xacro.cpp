#include "world/files/xacro.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/ros_packages.h"
#include "base/sandbox/sandboxed_program.h"
#include "synthetic_dataset/errors.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

constexpr int kNotThere = 127;  ///< how programs end that are not there

/// xacro's own program, which its Python module has as a function. What ROS 2 calls
/// `$(find-pkg-share package)` is `$(find package)` to it. Its newest version, which PyPI has, asks
/// ROS 2's index for packages; where that is not there, those of ROS_PACKAGE_PATH are meant.
constexpr const char* kModule = R"py(
import os
import sys
import types

home = os.environ.get('XDG_DATA_HOME') or os.path.expanduser('~/.local/share')
sys.path.append(os.path.join(home, 'synthetic_dataset', 'xacro'))
try:
    import xacro
except ImportError:
    sys.exit(127)

def folder_of(name):
    places = [each for each in os.environ.get('ROS_PACKAGE_PATH', '').split(os.pathsep) if each]
    for place in places:
        for found in (place, os.path.join(place, name)):
            if os.path.basename(found) == name and os.path.isfile(os.path.join(found, 'package.xml')):
                return found
    for place in places:
        for found, below, files in os.walk(place):
            if 'package.xml' not in files:
                continue
            below[:] = []
            if os.path.basename(found) == name:
                return found
    raise KeyError('no package ' + name + ' in ROS_PACKAGE_PATH')

try:
    import ament_index_python.packages
except ImportError:
    index = types.ModuleType('ament_index_python')
    index.packages = types.ModuleType('ament_index_python.packages')
    index.packages.get_package_share_directory = folder_of
    sys.modules['ament_index_python'] = index
    sys.modules['ament_index_python.packages'] = index.packages

sys.argv[0] = 'xacro'
evaluate = getattr(xacro, 'eval_extension', None)
def evaluated(text):
    return evaluate(text.replace('$(find-pkg-share ', '$(find ', 1))
if evaluate is not None:
    xacro.eval_extension = evaluated
xacro.main()
)py";

/// Robots take a second or two.
constexpr std::chrono::seconds kLongest{60};

std::vector<std::string> commandLine(const std::filesystem::path& file,
                                     const XacroArguments& arguments) {
  std::vector<std::string> words = {file.string()};
  for (const auto& [name, value] : arguments) words.push_back(name + ":=" + value);
  return words;
}

/// What a user can type. @param words  of the command
std::string shown(const std::vector<std::string>& words) {
  std::string text = "xacro";
  for (const std::string& word : words) {
    const bool plain = word.find_first_of(" \t'\"\\$`&|;<>()*?") == std::string::npos;
    text += plain ? " " + word : " '" + word + "'";
  }
  return text;
}

/// The last lines of what xacro complains of: the first ones are where in Python it was.
std::string lastLines(const std::string& text) {
  constexpr std::size_t kMost = 600;
  const std::string whole = trimmed(text);
  if (whole.size() <= kMost) return whole;
  const std::size_t cut = whole.find('\n', whole.size() - kMost);
  return "... " + whole.substr(cut == std::string::npos ? whole.size() - kMost : cut + 1);
}

/// The folder of the package that a file is in; empty for one that is in none.
std::filesystem::path packageAround(const std::filesystem::path& file) {
  std::error_code ignored;
  for (std::filesystem::path folder = std::filesystem::absolute(file, ignored).parent_path();
       folder.has_relative_path(); folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / "package.xml", ignored)) return folder;
  }
  return {};
}

/// @return nothing where there is no such program
std::optional<std::string> run(std::vector<std::string> command,
                               const std::vector<std::string>& words) {
  command.insert(command.end(), words.begin(), words.end());
  // So that packages of ROS 2 are found, and that of the file with those beside it.
  std::string packages = base::rosPackagePath();
  const std::filesystem::path own = packageAround(words.front());
  if (!own.empty()) packages += (packages.empty() ? "" : ":") + own.parent_path().string();
  if (!packages.empty()) command.insert(command.begin(), {"env", "ROS_PACKAGE_PATH=" + packages});
  base::SandboxLimits limits;
  limits.processor_time = kLongest;
  const auto answer = base::runSandboxedProgram(command, limits);
  const std::string called = "'" + shown(words) + "' ";
  if (const auto* crash = std::get_if<base::Crash>(&answer)) throw Error(called + crash->how);
  const auto& result = std::get<base::ProgramResult>(answer);
  if (result.exit_code == kNotThere) return std::nullopt;
  if (result.exit_code != 0) {
    throw Error(called + "ends with exit code " + std::to_string(result.exit_code) + ": " +
                lastLines(result.errors) +
                " (its arguments are the setting 'model_arguments' of the object)");
  }
  return result.output;
}

}  // namespace

bool isXacro(const std::filesystem::path& file) { return file.extension() == ".xacro"; }

std::string expandXacro(const std::filesystem::path& file, const XacroArguments& arguments) {
  const std::vector<std::string> words = commandLine(file, arguments);
  const auto runModule = [&] { return run({"python3", "-c", kModule}, words); };
  try {
    try {
      if (auto text = run({"xacro"}, words)) return *text;
    } catch (const Error& error) {
      const std::string what = error.what();
      const bool is_of_ros2 = what.find("find-pkg-share") != std::string::npos ||
                              what.find("ament_index_python") != std::string::npos;
      const auto text = is_of_ros2 ? runModule() : std::nullopt;
      if (!text) throw;
      return *text;
    }
    if (auto text = runModule()) return *text;
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
  throw Error(file.string() +
              ": is a xacro file, and there is no xacro to expand it, neither the program on PATH "
              "nor the Python module. Install it (ROS Noetic: apt install ros-noetic-xacro; "
              "elsewhere: python3 -m pip install --no-deps --target "
              "~/.local/share/synthetic_dataset/xacro xacro, as scripts/install_dependencies.sh "
              "does), or run '" +
              shown(words) + " > robot.urdf' where it is, and name robot.urdf");
}

}  // namespace synthetic_dataset::world
