// Unpacks files of a stick that are compressed with gzip: images and design data.
#pragma once

#include <string>

namespace openr_host {

bool IsGzip(const std::string& bytes);

enum class GzipResult { kWhole, kCutOff, kDamaged };

// Unpacks `packed` and appends the result to `bytes`.  If the file is cut off or damaged, appends
// the bytes before the fault.
GzipResult Gunzip(const std::string& packed, std::string* bytes);

}  // namespace openr_host
