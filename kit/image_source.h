// Generates the source that every image for the host needs beside its own code: the description of
// the image (struct ImageInfo of runtime/core/image_info.h) and helper functions.
#pragma once

#include <string>

namespace openr_host {

// Returns the source for an image whose .ocf file has the text `ocf`.  The source is valid C and
// C++; it is compiled and linked into the image.
std::string MakeImageSource(const std::string& ocf);

}  // namespace openr_host
