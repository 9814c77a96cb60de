// The source of what a host image says of itself (struct ImageInfo of runtime/core/image.h), and of
// what every image needs besides.
#pragma once

#include <string>

namespace openr_host {

// `ocf`: text of the .ocf file.  C that is C++ as well; it is to be linked last of all.
std::string MakeImageSource(const std::string& ocf);

}  // namespace openr_host
