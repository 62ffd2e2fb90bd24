// A world plugin for Gazebo 11: writes the measurements of the world's scanner to PATH/ray.txt and PATH/gpu_ray.txt, a
// range per line, ring after ring, while everything stands where its file puts it. record.py builds it and adds it to a
// world.
#include <cstdio>
#include <fstream>
#include <string>

#include <gazebo/common/Plugin.hh>
#include <gazebo/msgs/msgs.hh>
#include <gazebo/physics/physics.hh>
#include <gazebo/transport/transport.hh>

namespace gazebo {

// In the first sweeps of a rendering sensor, the scene is not complete yet.
constexpr int kKeptSweep = 5;

class ScanPlugin : public WorldPlugin {
 public:
  void Load(physics::WorldPtr world, sdf::ElementPtr sdf) override {
    path_ = sdf->Get<std::string>("path");
    world->SetPhysicsEnabled(false);
    node_.reset(new transport::Node());
    node_->Init(world->Name());
    rays_ = node_->Subscribe("~/scanner/link/ray/scan", &ScanPlugin::onRays, this);
    pictures_ = node_->Subscribe("~/scanner/link/gpu_ray/scan", &ScanPlugin::onPictures, this);
  }

 private:
  void onRays(ConstLaserScanStampedPtr& scan) { write("ray", *scan, ++ray_sweeps_); }
  void onPictures(ConstLaserScanStampedPtr& scan) { write("gpu_ray", *scan, ++picture_sweeps_); }

  void write(const std::string& name, const msgs::LaserScanStamped& message, int sweep) const {
    if (sweep != kKeptSweep) return;
    const std::string file = path_ + "/" + name + ".txt";
    std::ofstream stream(file + ".part");
    for (int i = 0; i < message.scan().ranges_size(); ++i) {
      stream << message.scan().ranges(i) << "\n";
    }
    stream.close();
    std::rename((file + ".part").c_str(), file.c_str());
  }

  std::string path_;
  transport::NodePtr node_;
  transport::SubscriberPtr rays_;
  transport::SubscriberPtr pictures_;
  int ray_sweeps_ = 0;
  int picture_sweeps_ = 0;
};

GZ_REGISTER_WORLD_PLUGIN(ScanPlugin)

}  // namespace gazebo
