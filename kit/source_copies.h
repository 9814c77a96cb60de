// Which folders are private copies of a person's sources, made by `openr build`.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct SourceCopy {
  std::string copy;  // both absolute, without a slash at the end
  std::string original;
};

// As told by `openr build` in the environment; empty when a tool runs by itself.
std::vector<SourceCopy> SourceCopies();
std::string ToEnvironment(const std::vector<SourceCopy>& copies);

// `text` with the names of copies turned into those of the originals.
std::string InTermsOfOriginals(std::string text, const std::vector<SourceCopy>& copies);

// The original of `file`, an absolute path; "" when it lies in no copy.
std::string OriginalOf(const std::string& file, const std::vector<SourceCopy>& copies);

}  // namespace openr_host
