#include "randomize/appearance/natural_picture.h"

#include <array>
#include <cstddef>
#include <vector>

#include "randomize/appearance/natural/canvas.h"
#include "randomize/appearance/natural/lens.h"
#include "randomize/appearance/natural/scenes.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize {
namespace {

struct TextureKind {
  const char* name;
  natural::Surface (*make)(base::RandomSource&, int bits);
};

constexpr std::array<TextureKind, 15> kTextureKinds = {{{"brick", natural::brick},
                                                        {"tiles", natural::tiles},
                                                        {"concrete", natural::concrete},
                                                        {"asphalt", natural::asphalt},
                                                        {"plaster", natural::plaster},
                                                        {"grass", natural::grass},
                                                        {"foliage", natural::foliage},
                                                        {"gravel", natural::gravel},
                                                        {"rock", natural::rock},
                                                        {"bark", natural::bark},
                                                        {"wood", natural::wood},
                                                        {"cloth", natural::cloth},
                                                        {"metal", natural::metal},
                                                        {"print", natural::print},
                                                        {"leaves", natural::leaves}}};

struct SceneKind {
  const char* name;
  void (*draw)(natural::Canvas&, base::RandomSource&);
};

// Streets and rooms are listed twice, so they are drawn twice as often.
constexpr std::array<SceneKind, 10> kSceneKinds = {{{"street", natural::drawStreet},
                                                    {"street", natural::drawStreet},
                                                    {"country", natural::drawCountry},
                                                    {"forest", natural::drawForest},
                                                    {"wall", natural::drawWallFront},
                                                    {"room", natural::drawRoom},
                                                    {"room", natural::drawRoom},
                                                    {"shelf", natural::drawShelf},
                                                    {"floor", natural::drawFloor},
                                                    {"clutter", natural::drawClutter}}};

}  // namespace

NaturalPicture drawNaturalTexture(base::RandomSource& random, int side) {
  const TextureKind& kind = kTextureKinds[random.index(kTextureKinds.size())];
  const natural::Surface surface = kind.make(random, side == 512 ? 9 : 8);
  const std::vector<cv::Vec4b> pixels = natural::litPixels(surface, random);
  return {kind.name, cv::Mat(pixels, true).reshape(4, surface.side)};
}

NaturalPicture drawNaturalPicture(base::RandomSource& random, int width, int height) {
  const SceneKind& kind = kSceneKinds[random.index(kSceneKinds.size())];
  natural::Canvas canvas(cv::Mat(cv::Mat::zeros(height, width, CV_8UC4)));
  kind.draw(canvas, random);
  natural::develop(canvas, random);
  return {kind.name, canvas};
}

}  // namespace synthetic_dataset::randomize
