#include "openr/upload/file_checks.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "ImageFile.h"
#include "MtnFile.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

[[noreturn]] void ThrowFor(const std::string& file, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}", file, why));
}

// Returns the bytes of an image that are sent to the robot.  Does not check the number of bytes,
// because ImageToSend() does that.
std::string BytesOfImage(const std::string& file, std::string packed, const RcInfo& info) {
  ImageFile image = CheckImage(packed);
  if (info.processor == imageMIPS) {
    if (image.is_for_robot) return packed;
    ThrowFor(file, fmt::format("is no image for {}", ImageProcessorName(imageMIPS)));
  }
  if (image.is_for_robot) {
    ThrowFor(file, fmt::format("is an image for {}; this robot needs one for {}",
                               ImageProcessorName(imageMIPS), ImageProcessorName(info.processor)));
  }
  if (!image.problem.empty()) ThrowFor(file, image.problem);
  // Sends the image unpacked, because RCServer treats each packed image as an image for a real
  // robot.
  return std::move(image.bytes);
}

}  // namespace

void CheckMotion(const std::string& file, const std::string& bytes, const RcInfo& info) {
  if (bytes.size() > info.largestMotion) {
    ThrowFor(file, fmt::format("has {} bytes; the robot takes motions of at most {}", bytes.size(),
                               info.largestMotion));
  }
  MtnFile motion;
  const RobotConstants* const robot = FindRobot(info.design.c_str());
  const bool good = motion.Read(reinterpret_cast<const Uint8*>(bytes.data()), bytes.size()) &&
                    (robot == nullptr || motion.MapTo(robot));
  if (!good) ThrowFor(file, motion.Error());
}

std::string ImageToSend(const std::string& file, std::string bytes, const RcInfo& info) {
  std::string to_send = BytesOfImage(file, std::move(bytes), info);
  if (to_send.size() > info.largestImage) {
    ThrowFor(file, fmt::format("has {} bytes; the robot takes images of at most {}", to_send.size(),
                               info.largestImage));
  }
  return to_send;
}

}  // namespace openr_host
