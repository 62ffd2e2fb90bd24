#include "output/manifest/camera_columns.h"

#include <cstdint>
#include <vector>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {

std::string coefficientText(const Distortion& distortion) {
  Value::List numbers;
  for (const double each : coefficientsOf(distortion)) numbers.emplace_back(each);
  return base::jsonText(Value(numbers));
}

std::optional<CameraModel> cameraAt(const base::SqliteStatement& row, int first, int width,
                                    int height) {
  std::vector<double> coefficients;
  const Value list = base::parseYaml(row.text(first + 7), "a camera's coefficients");
  if (list.is<Value::List>()) {
    for (const Value& each : *list.as<Value::List>()) {
      const auto* whole = each.as<std::int64_t>();
      const auto* number = each.as<double>();
      if (whole == nullptr && number == nullptr) throw Error("a camera's coefficients are damaged");
      coefficients.push_back(whole != nullptr ? static_cast<double>(*whole) : *number);
    }
  }
  Distortion distortion = makeDistortion(row.text(first + 6), coefficients);
  distortion.cutoff_angle = row.real(first + 8);
  try {
    const Intrinsics intrinsics{row.real(first), row.real(first + 1), row.real(first + 2),
                                row.real(first + 3)};
    return CameraModel(width, height, intrinsics, row.real(first + 4), row.real(first + 5),
                       distortion);
  } catch (const Error&) {
    return std::nullopt;  // for example an impossible image size
  }
}

}  // namespace synthetic_dataset::output
