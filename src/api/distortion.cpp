#include "synthetic_dataset/distortion.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "api/lens_model.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

using lens::LensModel;

/// The form in which names are compared: "Kannala-Brandt 4" becomes "kannalabrandt4".
std::string plain(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isalnum(code) != 0) result += static_cast<char>(std::tolower(code));
  }
  return result;
}

/// A model of other software that cannot be rendered.
struct OtherModel {
  const char* name;  ///< plain
  const char* what;
  bool bends_without_coefficients;  ///< it is not a pinhole even if all coefficients are 0
};

constexpr OtherModel kOtherModels[] = {
    {"modifiedbrownconrady", "librealsense's modified Brown-Conrady", false},
    {"inversebrownconrady", "librealsense's inverse Brown-Conrady", false},
    {"ftheta", "the F-theta lens", true},
    {"eucm", "the enhanced unified camera model", true},
    {"fov", "the field-of-view lens", false},
    {"fieldofview", "the field-of-view lens", false},
    {"atan", "the field-of-view lens", false},
    {"division", "the division model", false},
    {"scaramuzza", "Scaramuzza's omnidirectional camera", true},
    {"ocam", "Scaramuzza's omnidirectional camera", true},
    {"thinprismfisheye", "the fisheye with a thin prism", true},
    {"fisheye624", "the fisheye with a thin prism", true},
};

const LensModel* findModel(const std::string& name) {
  const std::string wanted = plain(name);
  for (const LensModel& model : lens::allModels()) {
    for (const std::string& each : model.names) {
      if (plain(each) == wanted) return &model;
    }
  }
  return nullptr;
}

const OtherModel* findOther(const std::string& name) {
  const std::string wanted = plain(name);
  const auto* end = std::end(kOtherModels);
  const auto* found = std::find_if(std::begin(kOtherModels), end,
                                   [&](const OtherModel& each) { return wanted == each.name; });
  return found == end ? nullptr : found;
}

bool isZero(double number) { return number == 0.0; }

[[noreturn]] void refuseModel(const std::string& name) {
  std::string choices;
  std::vector<std::string> names;
  for (const LensModel& model : lens::allModels()) {
    const bool is_last = &model == &lens::allModels().back();
    choices += (choices.empty() ? "" : is_last ? " or " : ", ") + model.names.front();
    names.push_back(model.names.front());
  }
  const OtherModel* other = findOther(name);
  throw Error("distortion_model: found '" + name + "'" +
              (other != nullptr ? std::string(" (") + other->what + "), which is not drawn" : "") +
              "; it should be " + choices + didYouMean(name, names));
}

/// How many numbers of a list are the model's: the largest count that the model allows and the list
/// holds, if all numbers after it are 0.
std::size_t usedCount(const LensModel& model, const std::vector<double>& list) {
  const auto fits = [&](std::size_t count) {
    return count <= list.size() &&
           std::all_of(list.begin() + static_cast<std::ptrdiff_t>(count), list.end(), isZero);
  };
  for (auto count = model.counts.rbegin(); count != model.counts.rend(); ++count) {
    if (fits(*count)) return *count;
  }
  throw Error("distortion_coefficients: found " + std::to_string(list.size()) + " numbers; " +
              model.names.front() + " has " + model.coefficients +
              ", and what follows them should be 0");
}

/// The model by the list's length, as in cv::projectPoints, to which ROS passes its list.
const LensModel& byLength(const LensModel& model, const std::vector<double>& list) {
  constexpr std::size_t kMostOfPlumbBob = 5;
  const bool is_longer = model.model == DistortionModel::kPlumbBob &&
                         list.size() > kMostOfPlumbBob &&
                         !std::all_of(list.begin() + kMostOfPlumbBob, list.end(), isZero);
  return is_longer ? lens::modelOf(DistortionModel::kRationalPolynomial) : model;
}

}  // namespace

const std::string& distortionModelName(DistortionModel model) {
  return lens::modelOf(model).names.front();
}

bool isDistortionModelName(const std::string& name) { return findModel(name) != nullptr; }

std::vector<double> coefficientsOf(const Distortion& distortion) {
  const LensModel& model = lens::modelOf(distortion.model);
  const auto& c = distortion.coefficients;
  std::size_t count = model.written;
  for (const std::size_t larger : model.counts) {
    const auto beyond = c.begin() + static_cast<std::ptrdiff_t>(count);
    if (larger > count && !std::all_of(beyond, c.end(), isZero)) count = larger;
  }
  return {c.begin(), c.begin() + static_cast<std::ptrdiff_t>(count)};
}

Distortion makeDistortion(const std::string& name, const std::vector<double>& coefficients) {
  const bool all_zero = std::all_of(coefficients.begin(), coefficients.end(), isZero);
  const LensModel* named = findModel(name);
  if (named == nullptr) {
    const OtherModel* other = findOther(name);
    if (all_zero && !(other != nullptr && other->bends_without_coefficients)) return {};
    refuseModel(name);
  }
  if (named->model == DistortionModel::kNone && !all_zero) {
    throw Error("distortion_coefficients: found numbers other than 0 with the distortion_model '" +
                name + "'; they should be 0, or the model should be named");
  }
  const LensModel& model = byLength(*named, coefficients);
  if (all_zero && !model.bends_without_coefficients) return {};
  Distortion distortion;
  distortion.model = model.model;
  if (!all_zero) {
    const std::size_t count = usedCount(model, coefficients);
    std::copy_n(coefficients.begin(), count, distortion.coefficients.begin());
  }
  const std::string fault = model.fault != nullptr ? model.fault(distortion) : "";
  if (!fault.empty()) throw Error("distortion_coefficients: " + fault);
  return distortion;
}

}  // namespace v2
}  // namespace synthetic_dataset
