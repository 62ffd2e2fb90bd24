#include "world/files/template_file.h"

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

constexpr int kNotThere = 127;  ///< exit code if there is no such program

/// The program xacro, which its Python module has as a function. ROS 2's `$(find-pkg-share
/// package)` is translated to xacro's `$(find package)`. The newest version, from PyPI, asks ROS
/// 2's index for packages; if there is no such index, ROS_PACKAGE_PATH is searched.
constexpr const char* kXacro = R"py(
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

/// Variables for which there is no argument are empty, as is Jinja's default.
constexpr const char* kJinja = R"py(
import os
import sys

try:
    import jinja2.sandbox
except ImportError:
    sys.exit(127)

folder, name = os.path.split(os.path.abspath(sys.argv[1]))
environment = jinja2.sandbox.SandboxedEnvironment(loader=jinja2.FileSystemLoader(folder))
try:
    print(environment.get_template(name).render(dict(each.split(':=', 1) for each in sys.argv[2:])))
except jinja2.TemplateSyntaxError as error:
    sys.exit('line %d: %s' % (error.lineno, error.message))
except Exception as error:
    sys.exit('%s: %s' % (type(error).__name__, error))
)py";

/// The time limit; robots take a second or two.
constexpr std::chrono::seconds kLongest{60};

std::vector<std::string> commandLine(const std::filesystem::path& file,
                                     const TemplateArguments& arguments) {
  std::vector<std::string> words = {file.string()};
  for (const auto& [name, value] : arguments) words.push_back(name + ":=" + value);
  return words;
}

/// A command as a user can type it. @param words  of the command
std::string shown(std::string text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const bool plain = word.find_first_of(" \t'\"\\$`&|;<>()*?") == std::string::npos;
    text += plain ? " " + word : " '" + word + "'";
  }
  return text;
}

/// The last lines of a program's error output: the first ones are Python's traceback.
std::string lastLines(const std::string& text) {
  constexpr std::size_t kMost = 600;
  const std::string whole = trimmed(text);
  if (whole.size() <= kMost) return whole;
  const std::size_t cut = whole.find('\n', whole.size() - kMost);
  return "... " + whole.substr(cut == std::string::npos ? whole.size() - kMost : cut + 1);
}

/// The folder of the package that a file is in; empty if it is in none.
std::filesystem::path packageAround(const std::filesystem::path& file) {
  std::error_code ignored;
  for (std::filesystem::path folder = std::filesystem::absolute(file, ignored).parent_path();
       folder.has_relative_path(); folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / "package.xml", ignored)) return folder;
  }
  return {};
}

/// @param name  for messages
/// @return nothing if there is no such program
std::optional<std::string> run(const std::string& name, std::vector<std::string> command,
                               const std::vector<std::string>& words) {
  command.insert(command.end(), words.begin(), words.end());
  // Lets xacro find the packages of ROS 2, and the file's own package with its neighbours.
  std::string packages = base::rosPackagePath();
  const std::filesystem::path own = packageAround(words.front());
  if (!own.empty()) packages += (packages.empty() ? "" : ":") + own.parent_path().string();
  if (!packages.empty()) command.insert(command.begin(), {"env", "ROS_PACKAGE_PATH=" + packages});
  base::SandboxLimits limits;
  limits.processor_time = kLongest;
  const auto answer = base::runSandboxedProgram(command, limits);
  const std::string called = "'" + shown(name, words) + "' ";
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

std::string expandXacro(const std::vector<std::string>& words) {
  const auto runModule = [&] { return run("xacro", {"python3", "-c", kXacro}, words); };
  try {
    if (auto text = run("xacro", {"xacro"}, words)) return *text;
  } catch (const Error& error) {
    const std::string what = error.what();
    const bool is_of_ros2 = what.find("find-pkg-share") != std::string::npos ||
                            what.find("ament_index_python") != std::string::npos;
    const auto text = is_of_ros2 ? runModule() : std::nullopt;
    if (!text) throw;
    return *text;
  }
  if (auto text = runModule()) return *text;
  throw Error(
      "is a xacro file, and there is no xacro to expand it, neither the program on PATH "
      "nor the Python module. Install it (ROS Noetic: apt install ros-noetic-xacro; "
      "elsewhere: python3 -m pip install --no-deps --target "
      "~/.local/share/synthetic_dataset/xacro xacro, as scripts/install_dependencies.sh "
      "does), or run '" +
      shown("xacro", words) + " > robot.urdf' where it is, and name robot.urdf");
}

std::string expandJinja(const std::vector<std::string>& words) {
  if (auto text = run("Jinja of", {"python3", "-c", kJinja}, words)) return *text;
  throw Error(
      "is a Jinja template, and there is no Jinja to expand it: apt install python3-jinja2, "
      "or name a file expanded elsewhere");
}

}  // namespace

bool isTemplate(const std::filesystem::path& file) {
  const std::string ending = file.extension();
  return ending == ".xacro" || ending == ".jinja" || ending == ".j2";
}

std::string expandTemplate(const std::filesystem::path& file, const TemplateArguments& arguments) {
  const std::vector<std::string> words = commandLine(file, arguments);
  try {
    return file.extension() == ".xacro" ? expandXacro(words) : expandJinja(words);
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

}  // namespace synthetic_dataset::world
