// The private copies of a user's sources that `openr build` makes, as pairs of folders: the copy
// and the original.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct SourceCopy {
  std::string copy;  // absolute path of a folder; no slash at its end, and none in `original`
  std::string original;
};

// Returns the private copies that `openr build` lists in an environment variable; none when the
// tool was not started by `openr build`.
std::vector<SourceCopy> SourceCopies();
std::string ToEnvironment(const std::vector<SourceCopy>& copies);

// Returns `text` with the paths of copies replaced by the paths of the originals.
std::string InTermsOfOriginals(std::string text, const std::vector<SourceCopy>& copies);

// Returns the path that `file`, an absolute path in a private copy, has in the user's own folder.
// Returns "" if `file` is in no private copy.
std::string OriginalOf(const std::string& file, const std::vector<SourceCopy>& copies);

}  // namespace openr_host
