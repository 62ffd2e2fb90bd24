#include "programs/inspect/server_descriptions.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <exception>
#include <memory>

#include <ros/init.h>
#include <ros/master.h>
#include <ros/param.h>

#include "motion/bag_contents.h"

namespace synthetic_dataset::programs {
namespace {

/// Whether a connection succeeds within a time; ROS itself would wait as long as the system does.
bool connects(const addrinfo& address, int milliseconds) {
  const int socket = ::socket(address.ai_family, address.ai_socktype, address.ai_protocol);
  if (socket < 0) return false;
  ::fcntl(socket, F_SETFL, O_NONBLOCK);
  bool is_there = ::connect(socket, address.ai_addr, address.ai_addrlen) == 0;
  pollfd waiting{socket, POLLOUT, 0};
  if (!is_there && ::poll(&waiting, 1, milliseconds) == 1) {
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
    is_there = error == 0;
  }
  ::close(socket);
  return is_there;
}

bool masterListens() {
  constexpr int kPatience = 500;  // [ms]
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(ros::master::getPort());
  if (::getaddrinfo(ros::master::getHost().c_str(), port.c_str(), &wanted, &found) != 0) {
    return false;
  }
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    if (connects(*each, kPatience)) return true;
  }
  return false;
}

}  // namespace

std::vector<ServerDescription> descriptionsOnServer() {
  try {
    ros::init(ros::M_string(), "inspect",
              ros::init_options::AnonymousName | ros::init_options::NoSigintHandler |
                  ros::init_options::NoRosout);
  } catch (const std::exception&) {  // for example, no ROS_MASTER_URI
    return {};
  }
  std::vector<std::string> names;
  if (!masterListens() || !ros::master::check() || !ros::param::getParamNames(names)) return {};
  std::vector<ServerDescription> found;
  for (const std::string& name : names) {
    std::string text;
    const bool is_description = name.find("robot_description") != std::string::npos;
    if (!is_description || !ros::param::get(name, text)) continue;
    const std::string robot = motion::robotOf(text);
    if (!robot.empty()) found.push_back({name, robot});
  }
  return found;
}

}  // namespace synthetic_dataset::programs
