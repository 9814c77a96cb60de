// Writes the source that every host image needs beside its own code: the description of the image
// (struct ImageInfo of runtime/core/image.h) and helper functions.
#pragma once

#include <string>

namespace openr_host {

// Returns the source for the text `ocf` of an .ocf file.  It is valid C and C++, and must be linked
// last.
std::string MakeImageSource(const std::string& ocf);

}  // namespace openr_host
