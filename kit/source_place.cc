#include "kit/source_place.h"

#include <algorithm>

namespace openr_host {

FilePosition PlaceAt(const std::string& file, std::string_view text, size_t offset) {
  const size_t begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
  const size_t end = std::min(text.find('\n', offset), text.size());
  const std::string_view before = text.substr(0, begin);
  return {file, static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(offset - begin) + 1, std::string(text.substr(begin, end - begin))};
}

}  // namespace openr_host
