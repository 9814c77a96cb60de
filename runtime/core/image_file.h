// Files of images, as they lie on a stick: shared objects for this machine, perhaps compressed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

struct ImageFile {
  std::string bytes;           // of the shared object; decompressed
  bool is_compressed = false;  // as gzip does it, and as install rules of Makefiles do with it
  bool is_for_robot = false;   // a MIPS binary
  std::string problem;         // why it cannot be loaded; "" if it can
};

// Reads `path` whole.  What can be said about the file without loading it has been said then:
// another machine, cut off, no image at all.
ImageFile ReadImageFile(const std::string& path);

// The .ocf text of a host image, without loading it; "" when it has none.
std::string OcfTextOf(const std::string& bytes);

// Texts of at least 8 characters in the bytes of an image, as `strings` shows them.
std::vector<std::string_view> TextsIn(std::string_view bytes);

// Those that are names of services.
std::vector<std::string> ServicesInImage(std::string_view bytes);

}  // namespace openr_host
