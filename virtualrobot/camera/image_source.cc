#include "virtualrobot/camera/image_source.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

using Colour = std::array<uint8_t, 3>;

constexpr Colour kBars[] = {{255, 255, 255}, {255, 255, 0}, {0, 255, 255}, {0, 255, 0},
                            {255, 0, 255},   {255, 0, 0},   {0, 0, 255},   {0, 0, 0}};
// The colour of the ball.  In the image it has Cr 216 and Cb 140.  This is well inside the colour
// tables by which programs find the pink ball, such as Cr 150 to 230 and Cb 120 to 190.
constexpr Colour kPink = {250, 115, 174};
constexpr int kCells = 16;   // cells of the test pattern: each shows a bit of the image's number
constexpr int kRound = 100;  // number of images until the ball is back at the left: 4 s at 25 Hz

void Put(Picture* picture, int x, int y, const Colour& colour) {
  std::copy(colour.begin(), colour.end(), picture->At(x, y));
}

void Fill(Picture* picture, int x0, int y0, int x1, int y1, const Colour& colour) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) Put(picture, x, y, colour);
  }
}

Picture FixedPart(int width, int height) {
  Picture picture{
      width, height,
      std::vector<uint8_t>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
  const int bars_end = height * 3 / 4;
  for (int bar = 0; bar < 8; ++bar) {
    Fill(&picture, width * bar / 8, 0, width * (bar + 1) / 8, bars_end, kBars[bar]);
  }
  for (int x = 0; x < width; ++x) {
    const auto grey = static_cast<uint8_t>(x * 255 / std::max(width - 1, 1));
    Fill(&picture, x, bars_end, x + 1, height, {grey, grey, grey});
  }
  return picture;
}

// Draws the ball of image `number`.  From image to image, the ball moves at half height from the
// left of the picture to the right and back.
void DrawBall(int64_t number, Picture* picture) {
  const int radius = picture->height / 8;
  const int way = picture->width - 2 * radius;
  const auto step = static_cast<int>(number % kRound);
  const int out = step < kRound / 2 ? step : kRound - step;
  const int cx = radius + way * out / (kRound / 2);
  const int cy = picture->height / 2;
  for (int y = cy - radius; y < cy + radius; ++y) {
    for (int x = cx - radius; x < cx + radius; ++x) {
      const int dx = x - cx, dy = y - cy;
      if (dx * dx + dy * dy < radius * radius) Put(picture, x, y, kPink);
    }
  }
}

void DrawNumber(int64_t number, Picture* picture) {
  const int height = picture->height / 18;
  for (int cell = 0; cell < kCells; ++cell) {
    const uint8_t level = number >> (kCells - 1 - cell) & 1 ? 255 : 0;
    Fill(picture, picture->width * cell / kCells, 0, picture->width * (cell + 1) / kCells, height,
         {level, level, level});
  }
}

}  // namespace

std::string TestPattern::Capture(const CameraShot& shot, Picture* picture) {
  if (still_.width != picture->width || still_.height != picture->height)
    still_ = FixedPart(picture->width, picture->height);
  picture->rgb = still_.rgb;
  DrawBall(shot.number, picture);
  DrawNumber(shot.number, picture);
  return "";
}

MemoryImageSource::MemoryImageSource(std::vector<Picture> pictures)
    : pictures_(std::move(pictures)) {
  ASSERT(!pictures_.empty(), "a source without pictures");
}

std::string MemoryImageSource::Capture(const CameraShot& shot, Picture* picture) {
  const auto count = static_cast<int64_t>(pictures_.size());
  ScalePicture(pictures_[static_cast<size_t>((shot.number - 1) % count)], picture);
  return "";
}

void ScalePicture(const Picture& from, Picture* to) {
  if (from.width == to->width && from.height == to->height) {
    to->rgb = from.rgb;
    return;
  }
  for (int y = 0; y < to->height; ++y) {
    const auto row =
        static_cast<size_t>(y * from.height / to->height) * static_cast<size_t>(from.width);
    for (int x = 0; x < to->width; ++x) {
      const auto column = static_cast<size_t>(x * from.width / to->width);
      std::copy_n(&from.rgb[(row + column) * 3], 3, to->At(x, y));
    }
  }
}

}  // namespace openr_host
