// Files a command is to read.
#pragma once

#include <string>

namespace openr_host {

// "" unless `path` is a folder; then "is a folder; give a motion file" (the `kind`), and a file in
// it that ends in `extension` (".MTN", in any case) as an example if there is one.
std::string WhyNoFile(const std::string& path, const std::string& kind,
                      const std::string& extension);

}  // namespace openr_host
