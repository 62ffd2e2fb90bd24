// Occupancy maps: map_server's YAML and, after a line of "%%", the picture that it names.
#include "fuzzing.h"
#include "randomize/placement/map_reader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::vector<std::string> contents = fuzzing::pieces(fuzzing::view(data, size));
  const std::string file = fuzzing::write("map.yaml", contents.front()).string();
  fuzzing::write("map.pgm", contents.size() > 1 ? contents[1] : "");
  fuzzing::tolerating([&] {
    const randomize::OccupancyMap map = randomize::readMapFile(file);
    static_cast<void>(map.isFree({map.pose().x, map.pose().y}));
  });
  return 0;
}
