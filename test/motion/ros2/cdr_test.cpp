#include "motion/ros2/cdr.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include "motion/bag/known_messages.h"
#include "motion/recorded.h"
#include "motion/ros2_bags.h"

namespace synthetic_dataset::motion {
namespace cdr_test {

using ::testing::HasSubstr;

std::string ros1Of(const std::string& cdr, const std::string& type) {
  return ros1Serialized(cdr, *knownMessage(type)->layout);
}

template <class Message>
std::string serialized(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

std::string errorOf(const std::string& cdr, const std::string& type = "tf2_msgs/TFMessage") {
  return messageOf([&] { (void)ros1Of(cdr, type); });
}

TEST(Cdr, BecomesWhatRos1WritesInBothByteOrders) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.stamp = ros::Time(12, 34);
  message.transforms[0].header.frame_id = "map";
  message.transforms[0].child_frame_id = "robot";
  message.transforms[0].transform.translation.x = 1.25;
  message.transforms[0].transform.rotation.w = 1.0;
  const Stamp stamp = std::chrono::seconds(12) + std::chrono::nanoseconds(34);
  for (const auto order : {CdrText::Order::kLittle, CdrText::Order::kBig}) {
    EXPECT_EQ(ros1Of(cdrTransform("map", "robot", stamp, 1.25, order), "tf2_msgs/TFMessage"),
              serialized(message));
  }
}

TEST(Cdr, ListsThatAreEmptyTakeNoPadding) {
  sensor_msgs::JointState message;
  message.name = {"shoulder"};
  message.position = {0.5};
  CdrText cdr;
  cdr.header(Stamp{0}, "").number(std::uint32_t{1}).text("shoulder");
  cdr.number(std::uint32_t{1}).number(0.5);
  cdr.number(std::uint32_t{0}).number(std::uint32_t{0});
  EXPECT_EQ(ros1Of(cdr.str(), "sensor_msgs/JointState"), serialized(message));
}

TEST(Cdr, HasTheNumbersOfACamera) {
  sensor_msgs::CameraInfo message;
  message.height = 48;
  message.width = 64;
  message.distortion_model = "plumb_bob";
  message.D = {0.1, 0.2, 0.0, 0.0, 0.3};
  for (std::size_t i = 0; i < 9; ++i) message.K[i] = message.R[i] = static_cast<double>(i);
  for (std::size_t i = 0; i < 12; ++i) message.P[i] = static_cast<double>(i);
  message.roi.do_rectify = 1;
  CdrText cdr;
  cdr.header(Stamp{0}, "").number(std::uint32_t{48}).number(std::uint32_t{64}).text("plumb_bob");
  cdr.number(std::uint32_t{5});
  for (const double each : message.D) cdr.number(each);
  for (const double each : message.K) cdr.number(each);
  for (const double each : message.R) cdr.number(each);
  for (const double each : message.P) cdr.number(each);
  for (int i = 0; i < 6; ++i) cdr.number(std::uint32_t{0});
  cdr.number(std::uint8_t{1});
  EXPECT_EQ(ros1Of(cdr.str(), "sensor_msgs/CameraInfo"), serialized(message));
}

TEST(Cdr, OtherEncodingsAreNamed) {
  std::string cdr = cdrTransform("map", "robot", Stamp{0}, 0.0);
  const std::map<char, std::string> names = {{'\x03', "parameter list (PL_CDR)"},
                                             {'\x07', "XCDR2 (PLAIN_CDR2)"},
                                             {'\x09', "XCDR2 (DELIMITED_CDR2)"},
                                             {'\x0B', "PL_CDR2"},
                                             {'\x44', "unknown (68)"}};
  for (const auto& [identifier, name] : names) {
    cdr[1] = identifier;
    EXPECT_THAT(errorOf(cdr), HasSubstr(name));
  }
}

TEST(Cdr, RefusesEachLengthThatLeadsBeyondItsEnd) {
  const std::string cdr = cdrTransform("map", "robot", Stamp{0}, 0.0);
  for (std::size_t size = 0; size < cdr.size(); ++size) {
    EXPECT_NE(errorOf(cdr.substr(0, size)), "") << size;
  }
  std::string many = cdr;
  many.replace(4, 4, "\xFF\xFF\xFF\x7F");
  EXPECT_THAT(errorOf(many), HasSubstr("a list 'transforms' of 2147483647 entries, more than"));
  std::string long_name = cdr;
  long_name.replace(16, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_THAT(errorOf(long_name), HasSubstr("breaks off"));
}

TEST(Cdr, RefusesATextWithoutItsEndAndBytesThatNoFieldHas) {
  std::string open = cdrTransform("map", "robot", Stamp{0}, 0.0);
  open[23] = 'x';
  EXPECT_THAT(errorOf(open), HasSubstr("a text 'frame_id' without its end"));
  const std::string cdr = cdrTransform("map", "robot", Stamp{0}, 0.0);
  EXPECT_EQ(ros1Of(cdr + std::string(3, '\0'), "tf2_msgs/TFMessage"),  // padding
            ros1Of(cdr, "tf2_msgs/TFMessage"));
  EXPECT_THAT(errorOf(cdr + std::string(8, '\0')), HasSubstr("8 bytes more than its type"));
}

}  // namespace cdr_test
}  // namespace synthetic_dataset::motion
