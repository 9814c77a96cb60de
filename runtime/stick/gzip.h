// Files of a stick that are compressed as gzip does it: images and design data.
#pragma once

#include <string>

namespace openr_host {

bool IsGzip(const std::string& bytes);

enum class GzipResult { kWhole, kCutOff, kDamaged };

// Appends what `packed` holds to `bytes`, as far as it can be read.
GzipResult Gunzip(const std::string& packed, std::string* bytes);

}  // namespace openr_host
