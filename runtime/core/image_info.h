// The description of an image, and the versions with which the build marks it.
#pragma once

#include <cstdint>

namespace openr_host {

// The version of struct ImageInfo, and of the tables that the runtime reads from a loaded image.
constexpr uint32_t kImageVersion = 1;

// The version of the SDK headers (runtime/include).  Must be raised when a change of the headers
// affects images: a change of the size, the members or the virtual functions of a class, or of the
// value of a constant.  tests/runtime/include/layout_test.cc has the sizes.
constexpr uint32_t kHeadersVersion = 1;

// The description of an image, which the build puts into every image under the symbol
// openr_image_info.
struct ImageInfo {
  uint32_t version;  // the value of kImageVersion in the build that made the image
  // The value of kHeadersVersion in the build that made the image; 0 in images of old builds, which
  // did not know kHeadersVersion yet.
  uint32_t headers_version;
  const char* ocf;  // the text of the .ocf file
};

}  // namespace openr_host
