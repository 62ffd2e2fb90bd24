#include "synthetic_dataset/distortion.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace distortion_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string messageOf(const std::string& model, const std::vector<double>& coefficients) {
  try {
    (void)makeDistortion(model, coefficients);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Distortion, IsKnownByTheNamesOfRosOpenCvAndKalibr) {
  const std::vector<double> four = {0.1, 0.2, 0.001, 0.002};
  for (const char* name : {"plumb_bob", "radtan", "radial-tangential", "Brown Conrady"}) {
    EXPECT_EQ(makeDistortion(name, four).model, DistortionModel::kPlumbBob) << name;
  }
  for (const char* name : {"equidistant", "fisheye", "equi", "kannala_brandt4", "KannalaBrandt8"}) {
    EXPECT_EQ(makeDistortion(name, four).model, DistortionModel::kEquidistant) << name;
  }
  EXPECT_EQ(makeDistortion("MEI", {1.2, 0.1, 0, 0, 0}).model, DistortionModel::kOmnidirectional);
  EXPECT_EQ(makeDistortion("ds", {0.1, 0.5}).model, DistortionModel::kDoubleSphere);
}

TEST(Distortion, TakesAListForWhatItsLengthSaysAsOpenCvDoes) {
  const Distortion five = makeDistortion("rational_polynomial", {0.1, 0.2, 0, 0, 0.3});
  EXPECT_EQ(five.model, DistortionModel::kRationalPolynomial);
  EXPECT_EQ(five.coefficients[4], 0.3);
  EXPECT_EQ(makeDistortion("plumb_bob", {0.1, 0, 0, 0, 0, 0.2, 0, 0}).model,
            DistortionModel::kRationalPolynomial);
  EXPECT_EQ(makeDistortion("plumb_bob", {0.1, 0, 0, 0, 0, 0, 0, 0}).model,
            DistortionModel::kPlumbBob);
}

TEST(Distortion, WithoutCoefficientsIsNoneUnlessTheLensIsAFisheye) {
  EXPECT_EQ(makeDistortion("none", {0, 0, 0, 0, 0}).model, DistortionModel::kNone);
  EXPECT_EQ(makeDistortion("rational_polynomial", {}).model, DistortionModel::kNone);
  EXPECT_EQ(makeDistortion("modified_brown_conrady", {0, 0, 0, 0, 0}).model,
            DistortionModel::kNone);
  EXPECT_EQ(makeDistortion("somebody's", {0, 0}).model, DistortionModel::kNone);
  EXPECT_EQ(makeDistortion("fisheye", {0, 0, 0, 0}).model, DistortionModel::kEquidistant);
  EXPECT_THAT(messageOf("eucm", {0, 0}), HasSubstr("found 'eucm'"));
}

TEST(Distortion, OfAModelThatIsNotDrawnIsRefusedByItsName) {
  EXPECT_THAT(messageOf("modified_brown_conrady", {0.1, 0, 0, 0, 0}),
              AllOf(HasSubstr("distortion_model: found 'modified_brown_conrady'"),
                    HasSubstr("librealsense"), HasSubstr("not drawn"), HasSubstr("plumb_bob")));
  EXPECT_THAT(messageOf("none", {0.1, 0, 0, 0, 0}), HasSubstr("should be 0"));
}

TEST(Distortion, NamesTheCountsThatAModelMayHave) {
  EXPECT_THAT(messageOf("plumb_bob", {0.1, 0.2}),
              AllOf(HasSubstr("found 2 numbers"), HasSubstr("4 or 5 (k1, k2, p1, p2, k3)")));
  EXPECT_THAT(messageOf("equidistant", {0.1, 0, 0, 0, 0.2}), HasSubstr("equidistant has 4"));
}

TEST(Distortion, IsWrittenWithTheCoefficientsThatItNeeds) {
  EXPECT_THAT(coefficientsOf(makeDistortion("radtan", {0.1, 0.2, 0, 0})),
              ElementsAre(0.1, 0.2, 0, 0, 0));
  EXPECT_EQ(coefficientsOf(makeDistortion("rational", {1, 2, 0, 0, 5})).size(), 8U);
  std::vector<double> prism(12, 0.01);
  EXPECT_EQ(coefficientsOf(makeDistortion("rational", prism)), prism);
  prism.resize(14, 0.02);
  EXPECT_EQ(coefficientsOf(makeDistortion("rational", prism)), prism);
  EXPECT_THAT(coefficientsOf(makeDistortion("ds", {0.1, 0.5})), ElementsAre(0.1, 0.5));
}

TEST(Distortion, IsReadBackAsItIsWritten) {
  for (const auto& [name, numbers] :
       {std::pair<const char*, std::vector<double>>{"radtan", {0.1, 0.2, 0.01, 0}},
        {"rational", {1, 2, 0, 0, 5, 6, 7, 8, 9, 10, 11, 12}},
        {"equi", {0.1, 0.2, 0.3, 0.4}},
        {"mei", {1.1, 0.1, 0.2, 0.01, 0.02, 0.003}},
        {"ds", {0.1, 0.5}}}) {
    const Distortion distortion = makeDistortion(name, numbers);
    EXPECT_EQ(makeDistortion(distortionModelName(distortion.model), coefficientsOf(distortion)),
              distortion)
        << name;
  }
}

}  // namespace distortion_test
}  // namespace synthetic_dataset
