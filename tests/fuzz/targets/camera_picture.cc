// The fuzz target camera_picture: pictures for the camera (PNG, PPM).
#include <algorithm>
#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

bool fuzz::camera_picture(std::string_view bytes) {
  const FuzzFile file(bytes);
  try {
    const Picture picture = ReadPicture(file.path());
    Picture sensor{88, 72, std::vector<uint8_t>(88 * 72 * 3)};
    ScalePicture(picture, &sensor);
    // Notes the size of an accepted picture, because pictures of all sizes have the same branches.
    ReachFuzzState(
        static_cast<uint64_t>(std::min(picture.width, 15) * 16 + std::min(picture.height, 15)));
    return picture.width == 3 && picture.height == 3;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
