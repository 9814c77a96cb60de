// The private copies of a user's sources that `openr build` makes, as pairs of folders: the copy
// and the original.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct SourceCopy {
  std::string copy;  // absolute path of a folder without a slash at the end, as is `original`
  std::string original;
};

// Returns the private copies that `openr build` lists in an environment variable; none when the
// tool was not started by `openr build`.
std::vector<SourceCopy> SourceCopies();
std::string ToEnvironment(const std::vector<SourceCopy>& copies);

// Returns `text` with the paths of copies replaced by the paths of the originals.
std::string InTermsOfOriginals(std::string text, const std::vector<SourceCopy>& copies);

// Returns the user's file of which `file`, an absolute path, is the private copy; "" when `file` is
// in no private copy.
std::string OriginalOf(const std::string& file, const std::vector<SourceCopy>& copies);

}  // namespace openr_host
