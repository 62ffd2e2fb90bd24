#include "motion/recorded/cloud_points.h"

#include <limits>

#include <gmock/gmock.h>

#include "support/cloud_message.h"
#include "support/error_messages.h"

namespace synthetic_dataset::motion {
namespace cloud_points_test {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;
using test::ByteOrder;
using test::CloudFieldNumbers;
using test::cloudMessage;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Stamp kStamp = std::chrono::nanoseconds(1'600'000'000'250'000'000);
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A cloud with positions along x, and with other fields.
PointCloud2 cloudOf(const std::vector<double>& x, const std::vector<CloudFieldNumbers>& others,
                    ByteOrder order = ByteOrder::kLittle, std::uint32_t height = 1) {
  const std::vector<double> zeros(x.size(), 0.0);
  std::vector<CloudFieldNumbers> fields = {{"x", PointField::FLOAT32, x},
                                           {"y", PointField::FLOAT32, zeros},
                                           {"z", PointField::FLOAT32, zeros}};
  fields.insert(fields.end(), others.begin(), others.end());
  return cloudMessage("top", kStamp, fields, order, height);
}

std::vector<std::int64_t> timesIn(const PointCloud2& cloud) {
  std::vector<std::int64_t> times;
  for (const MeasuredPoint& point : measuredCloud(cloud).points) {
    times.push_back(point.time.count());
  }
  return times;
}

std::vector<std::string> problemsOf(const PointCloud2& cloud) {
  return test::messagesOf([&] { (void)measuredCloud(cloud); });
}

TEST(CloudPoints, AreReadInBothByteOrdersAndSizes) {
  for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
    for (const std::uint8_t type : {PointField::FLOAT32, PointField::FLOAT64}) {
      const MeasuredCloud measured =
          measuredCloud(cloudMessage("top", kStamp,
                                     {{"x", type, {1, 4}},
                                      {"y", type, {2, 5}},
                                      {"z", type, {-3.5, 6}},
                                      {"intensity", PointField::UINT16, {300, 7}},
                                      {"ring", PointField::UINT16, {3, 1}}},
                                     order));
      ASSERT_EQ(measured.points.size(), 2U);
      EXPECT_EQ(measured.points[0].position, Eigen::Vector3d(1, 2, -3.5));
      EXPECT_EQ(measured.points[1].position, Eigen::Vector3d(4, 5, 6));
      EXPECT_EQ(measured.points[0].intensity, 300.0);
      EXPECT_EQ(measured.points[0].ring, 3U);
      EXPECT_EQ(measured.rings, 4U);
      EXPECT_EQ(measured.columns, 1U);
      EXPECT_EQ(measured.points[0].time, Duration(0)) << "without a field, at the stamp";
    }
  }
}

TEST(CloudPoints, AreLeftOutWhereNothingWasMeasured) {
  const PointCloud2 cloud = cloudOf({1, kNan, 0, 4}, {});
  const MeasuredCloud measured = measuredCloud(cloud);
  ASSERT_EQ(measured.points.size(), 2U);
  EXPECT_EQ(measured.points[1].position.x(), 4.0);
  EXPECT_EQ(measured.points[1].column, 3U) << "they have their places all the same";
  EXPECT_EQ(positionsOf(cloud).size(), 3U) << "the scanner's own place may be one";
}

TEST(CloudPoints, OfRowsHaveTheirRings) {
  const MeasuredCloud measured = measuredCloud(cloudOf({1, 2, kNan, 4, 5, 6}, {}, {}, 2));
  ASSERT_EQ(measured.points.size(), 5U);
  EXPECT_EQ(measured.rings, 2U);
  EXPECT_EQ(measured.columns, 3U);
  EXPECT_EQ(measured.points[2].ring, 1U);
  EXPECT_EQ(measured.points[2].column, 0U);
  EXPECT_EQ(measured.points[4].position.x(), 6.0) << "rows end with bytes of no point";
}

TEST(CloudPoints, HaveAPlaceOfTheirOwnInTheirRing) {
  const MeasuredCloud measured =
      measuredCloud(cloudOf({1, 2, 3, 4}, {{"ring", PointField::UINT8, {5, 0, 5, 5}}}));
  EXPECT_EQ(measured.points[3].column, 2U);
  EXPECT_EQ(measured.points[1].column, 0U);
  EXPECT_EQ(measured.columns, 3U);
}

TEST(CloudPoints, HaveTheTimesOfVelodynesDriver) {
  EXPECT_THAT(timesIn(cloudOf({1, 1}, {{"time", PointField::FLOAT32, {-0.0625, 0.0}}})),
              ElementsAre(-62'500'000, 0));
}

TEST(CloudPoints, HaveTheTimesOfOustersDriver) {
  EXPECT_THAT(timesIn(cloudOf({1, 1}, {{"t", PointField::UINT32, {12'345, 99'000'000}}})),
              ElementsAre(12'345, 99'000'000));
}

TEST(CloudPoints, HaveTheTimesOfHesaisDriver) {
  const std::vector<double> times = {1'600'000'000.25, 1'600'000'000.3125};
  EXPECT_THAT(timesIn(cloudOf({1, 1}, {{"timestamp", PointField::FLOAT64, times}})),
              ElementsAre(0, 62'500'000));
}

TEST(CloudPoints, HaveTheTimesOfLivoxsDriver) {
  const std::vector<double> times = {1'600'000'000'250'000'128.0, 1'600'000'000'350'000'128.0};
  EXPECT_THAT(timesIn(cloudOf({1, 1}, {{"timestamp", PointField::FLOAT64, times}})),
              ElementsAre(128, 100'000'128));
}

TEST(CloudPoints, HaveTimesThatOtherDriversNameAlike) {
  EXPECT_THAT(timesIn(cloudOf({1}, {{"timestamp", PointField::FLOAT32, {0.125}}})),
              ElementsAre(125'000'000));
  EXPECT_THAT(timesIn(cloudOf({1}, {{"time", PointField::FLOAT64, {1'600'000'000.5}}})),
              ElementsAre(250'000'000));
}

TEST(CloudPoints, HaveTimesThatNobodyUnderstands) {
  EXPECT_THAT(problemsOf(cloudOf({1, 1}, {{"t", PointField::UINT32, {0, 2e9}}})),
              ElementsAre(AllOf(HasSubstr("in its field t"),
                                HasSubstr("more than 1 s from its stamp in all units"))));
  EXPECT_THAT(timesIn(cloudOf({1, kNan}, {{"t", PointField::UINT32, {5, 2e9}}})), ElementsAre(5))
      << "where nothing was measured, it does not matter";
}

TEST(CloudPoints, HaveTheirRange) {
  const TimeRange range = timesOf(
      cloudOf({1, 1, 1, 0}, {{"t", PointField::UINT32, {50'000, 10'000, 30'000, 99'000'000}}}));
  EXPECT_EQ(range.first, Duration(10'000));
  EXPECT_EQ(range.last, Duration(50'000));
}

TEST(CloudPoints, HaveAnIntensityOrAReflectivity) {
  const CloudFieldNumbers reflectivity = {"reflectivity", PointField::UINT8, {200}};
  EXPECT_EQ(measuredCloud(cloudOf({1}, {reflectivity})).points[0].intensity, 200.0);
  EXPECT_EQ(measuredCloud(cloudOf({1}, {reflectivity, {"intensity", PointField::FLOAT32, {0.5}}}))
                .points[0]
                .intensity,
            0.5);
  EXPECT_EQ(measuredCloud(cloudOf({1}, {})).points[0].intensity, 0.0);
}

TEST(CloudPoints, NeedAllCoordinates) {
  EXPECT_THAT(problemsOf(cloudMessage("top", kStamp, {{"x", PointField::FLOAT32, {1}}})),
              ElementsAre(HasSubstr("has no field y; it has x")));
  PointCloud2 cloud = cloudOf({1, 2}, {});
  cloud.fields[2].datatype = PointField::INT16;
  EXPECT_THAT(problemsOf(cloud), ElementsAre(HasSubstr("has a field z of type 3; it should be")));
  cloud.fields[2].datatype = 9;
  EXPECT_THAT(problemsOf(cloud), ElementsAre(HasSubstr("which sensor_msgs/PointField does not")));
}

TEST(CloudPoints, NeedTheBytesThatTheySay) {
  PointCloud2 cloud = cloudOf({1, 2}, {});
  cloud.data.resize(20);
  EXPECT_THAT(problemsOf(cloud), ElementsAre(HasSubstr("has 20 bytes; its 2 x 1 points need 30")));
  cloud = cloudOf({1, 2}, {{"ring", PointField::UINT16, {0, 1}}});
  cloud.point_step = 16;
  EXPECT_THAT(problemsOf(cloud), ElementsAre(HasSubstr("its field ring ends at 18")));
  cloud = cloudOf({1, 2}, {{"ring", PointField::UINT16, {0, 5000}}});
  EXPECT_THAT(problemsOf(cloud), ElementsAre(HasSubstr("has the ring 5000.0")));
}

}  // namespace cloud_points_test
}  // namespace synthetic_dataset::motion
