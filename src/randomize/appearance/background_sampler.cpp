#include "randomize/appearance/background_sampler.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "randomize/appearance/picture_options.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace {

const char* const kEntry = "background/pictures";

std::string entryName() { return std::string("randomize/") + kEntry; }

bool isPanorama(const BackgroundPictures& pictures) {
  return pictures.projection == BackgroundProjection::kPanorama;
}

}  // namespace

BackgroundSampler::BackgroundSampler(const BackgroundRandomization& config) : config_(config) {
  if (!config_.pictures) return;
  if (config_.pictures->folder == kNatural) {
    natural_.emplace(NaturalUse::kBackground);
    return;
  }
  base::namingPlace(entryName(), [&] {
    pictures_.emplace(config_.pictures->folder, PictureKind::kAny);
    if (isPanorama(*config_.pictures)) checkProportions();
  });
}

/// Rejects photographs used as panoramas: they would be stretched around the world.
void BackgroundSampler::checkProportions() const {
  constexpr double kSlack = 0.05;
  for (std::size_t i = 0; i < pictures_->files().size(); ++i) {
    const base::PictureSize& size = pictures_->sizes()[i];
    const double ratio = static_cast<double>(size.width) / static_cast<double>(size.height);
    if (std::abs(ratio - 2.0) <= kSlack) continue;
    throw Error("found '" + pictures_->files()[i] + "' of " + std::to_string(size.width) + " x " +
                std::to_string(size.height) +
                " pixels; a panorama goes all round, so it should be twice as wide as high "
                "(photographs are for `projection: backdrop`)");
  }
}

void BackgroundSampler::sample(EntryDraws& draws, world::Look& look) {
  if (const auto colour = draws.vector(config_.colour_name, config_.colour)) {
    look.background = colour->cast<float>();
  }
  if (!config_.pictures) return;
  const std::optional<double>& present = config_.pictures->present;
  if (present && !draws.happens("background/present", *present)) return;
  look.background_picture = drawPicture(draws);
}

std::shared_ptr<const world::Texture> BackgroundSampler::readPicture(base::RandomSource& random) {
  if (natural_) return natural_->read(random.index(NaturalPool::kSize));
  return pictures_->read(random.index(pictures_->files().size()));
}

world::BackgroundPicture BackgroundSampler::drawPicture(EntryDraws& draws) {
  using Projection = world::BackgroundPicture::Projection;
  const BackgroundPictures& config = *config_.pictures;
  base::RandomSource random = draws.source(kEntry);
  world::BackgroundPicture drawn;
  drawn.picture = base::namingPlace(entryName(), [&] { return readPicture(random); });
  draws.note(kEntry, drawn.picture->file);
  drawn.projection = isPanorama(config) ? Projection::kPanorama : Projection::kBackdrop;
  drawn.yaw = draws.number("background/yaw", config.yaw).value_or(0.0);
  drawn.brightness = draws.number("background/brightness", config.brightness).value_or(1.0);
  return drawn;
}

}  // namespace synthetic_dataset::randomize
