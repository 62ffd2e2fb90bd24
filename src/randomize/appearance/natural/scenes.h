#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/canvas.h"

/// Complete pictures, like photographs that are full of things.
namespace synthetic_dataset::randomize::natural {

// Outdoors: scenes_outdoors.cpp.
void drawStreet(Canvas& canvas, base::RandomSource& random);
void drawCountry(Canvas& canvas, base::RandomSource& random);
void drawForest(Canvas& canvas, base::RandomSource& random);

// In front of walls: scenes_near_walls.cpp.
void drawWallFront(Canvas& canvas, base::RandomSource& random);
void drawRoom(Canvas& canvas, base::RandomSource& random);
void drawShelf(Canvas& canvas, base::RandomSource& random);

// Close up: scenes_close.cpp.
void drawFloor(Canvas& canvas, base::RandomSource& random);
void drawClutter(Canvas& canvas, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural
