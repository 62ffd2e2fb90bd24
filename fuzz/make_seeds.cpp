// Writes the fuzzers' seeds that are binary or repetitive: make_seeds FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <nav_msgs/OccupancyGrid.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2_msgs/TFMessage.h>

#include <opencv2/imgcodecs.hpp>
#include "base/sqlite.h"
#include "motion/ros2_bags.h"
#include "output/manifest/manifest_schema.h"
#include "output/manifest/truth_tables.h"

namespace {

namespace fs = std::filesystem;

/// A robot that drives along x of the map.
tf2_msgs::TFMessage transforms(double x) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.header.stamp = ros::Time(100.0 + x);
  transform.child_frame_id = "robot";
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

sensor_msgs::CameraInfo calibration() {
  sensor_msgs::CameraInfo info;
  info.header.frame_id = "camera";
  info.width = 64;
  info.height = 48;
  info.distortion_model = "plumb_bob";
  info.D = {0.1, -0.05, 0.0, 0.0, 0.0};
  info.K = {50, 0, 31.5, 0, 50, 23.5, 0, 0, 1};
  info.P = {50, 0, 31.5, 0, 0, 50, 23.5, 0, 0, 0, 1, 0};
  return info;
}

nav_msgs::OccupancyGrid map() {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 0.5F;
  grid.info.width = 3;
  grid.info.height = 2;
  grid.info.origin.orientation.w = 1.0;
  grid.data = {0, 10, 20, 100, -1, 50};
  return grid;
}

void writeBag(const fs::path& file, rosbag::CompressionType compression) {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.setCompression(compression);
  bag.setChunkThreshold(400);
  bag.write("/camera_info", ros::Time(100.0), calibration());
  bag.write("/map", ros::Time(100.0), map());
  for (const double x : {0.0, 1.0, 2.0}) bag.write("/tf", ros::Time(100.0 + x), transforms(x));
}

void writeRos2Bags(const fs::path& folder) {
  using namespace synthetic_dataset::motion;
  const TestBag bag = drivingBag();
  const auto write = [&](const char* name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
  };
  write("plain.mcap", mcapOf(bag, {0}));
  write("chunks.mcap", mcapOf(bag, {2, "", true, true, false}));
  write("zstd.mcap", mcapOf(bag, {2, "zstd", true, false, false}));
  write("lz4.mcap", mcapOf(bag, {2, "lz4", false, true, false}));
  fs::remove(folder / "a.db3");
  writeSqlite(folder / "a.db3", bag);
}

template <class Message>
void writeMessage(const fs::path& file, const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  std::ofstream(file, std::ios::binary) << bytes;
}

void writePictures(const fs::path& folder) {
  cv::Mat picture(6, 5, CV_8UC3);
  cv::randu(picture, 0, 256);
  for (const char* kind : {"png", "jpg", "bmp", "tiff", "webp"}) {
    cv::imwrite((folder / "colours.").string() + kind, picture);
  }
  cv::imwrite((folder / "heights.png").string(), cv::Mat(4, 4, CV_16UC1, cv::Scalar(1000)));
  std::string tga(18, '\0');
  tga[2] = 10;  // colours, in packets
  tga[12] = tga[14] = 2;
  tga[16] = 24;
  std::ofstream(folder / "packed.tga", std::ios::binary) << tga << '\x83' << "rgb";
}

void writeManifest(const fs::path& file) {
  using synthetic_dataset::base::SqliteDatabase;
  fs::remove(file);
  const SqliteDatabase database(file.string(), SqliteDatabase::Mode::kCreate);
  database.execute("PRAGMA page_size = 512");
  database.execute(synthetic_dataset::output::kManifestTables);
  database.execute(synthetic_dataset::output::kTruthTables);
  database.execute(std::string("INSERT INTO run VALUES ('format_version', '") +
                   synthetic_dataset::output::kManifestVersion + R"('), ('state', 'unfinished'),
        ('scene_count', '2'), ('shard', '0/2');
      INSERT INTO setting VALUES ('seed', '0', 1);
      INSERT INTO software VALUES ('synthetic_dataset', '1');
      INSERT INTO writer VALUES (0, 'yolo', 'synthetic_dataset/Yolo', 'yolo/');
      INSERT INTO class VALUES (0, 'robot');
      INSERT INTO motion VALUES (0, '0', 0, 2);
      INSERT INTO camera VALUES (0, 'camera', 'lens', 64, 48);
      INSERT INTO object VALUES (0, 'robot', 0, 'robot');
      INSERT INTO scene VALUES (0, 0, 5, 'camera', 64, 48, '', 1, 0, 0, 0, 0, 0, 0, 1, 'complete');
      INSERT INTO file VALUES ('yolo/00000000.png', 0, 0, 9, '', NULL);
      INSERT INTO record VALUES (0, 0, 0, 'a' || char(10) || '00000000.png');
      INSERT INTO warning VALUES (0, 0, 1, 'kind', 'detail');)");
}

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

void writeText(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// Inputs that nest deeper than any stack, and inputs whose time grows with the square of their
/// size.
void writeRepetitions(const fs::path& folder) {
  const std::string brackets = repeated("[", 9000) + repeated("]", 9000);
  writeText(folder / "config/nested", "a: " + brackets);
  writeText(folder / "config/nested_dashes", repeated("- ", 9000) + "x");
  writeText(folder / "camera_info/nested", "camera_matrix: " + brackets);
  writeText(folder / "sdf/nested", repeated("<model>", 1200) + repeated("</model>", 1200));
  writeText(folder / "urdf/nested", repeated("<link>", 1200) + repeated("</link>", 1200));
  std::string attributes;
  std::string names;
  for (int i = 0; i < 1800; ++i) {
    attributes += " a" + std::to_string(i) + "=\"1\"";
    names += "n" + std::to_string(i) + ": 1\n";
  }
  writeText(folder / "sdf/attributes", "<sdf version=\"1.6\"><model" + attributes + "/></sdf>");
  writeText(folder / "config/names", names);
  for (const char format : {'A', 'B', 'D', 'E', 'F'}) {  // those that read JSON are among them
    writeText(folder / "readback" / (std::string("nested_") + format), format + brackets);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_seeds FOLDER\n");
    return 1;
  }
  const fs::path folder = arguments[1];
  for (const char* target : {"bag", "ros2_bag", "cdr", "message", "picture", "manifest"}) {
    fs::create_directories(folder / target);
  }
  writeBag(folder / "bag/plain.bag", rosbag::compression::Uncompressed);
  writeBag(folder / "bag/bz2.bag", rosbag::compression::BZ2);
  writeBag(folder / "bag/lz4.bag", rosbag::compression::LZ4);
  writeRos2Bags(folder / "ros2_bag");
  using namespace synthetic_dataset::motion;
  std::ofstream(folder / "cdr/transform", std::ios::binary)
      << '\0' << cdrTransform("map", "robot", std::chrono::seconds(1), 1.0);
  std::ofstream(folder / "cdr/definition", std::ios::binary) << '\7' << kTransformsDefinition;
  writeMessage(folder / "message/transforms", transforms(1.0));
  writeMessage(folder / "message/calibration", calibration());
  writeMessage(folder / "message/map", map());
  writePictures(folder / "picture");
  writeManifest(folder / "manifest/manifest.sqlite");
  writeRepetitions(folder);
  return 0;
}
