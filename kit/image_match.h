// Finds out which image a line of OBJECT.CFG means when no Makefile tells.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct ImageCandidate {
  std::vector<std::string> names;  // names of its object, file, folder and class, in any order
};

// Returns for each of `wanted` ("BLNKLED.BIN") the index of its candidate, or -1.  The rules are
// tried in this order, each for the names that are left, and a rule counts only where it fits one
// pair alone:
//   - the names are equal, in any case;
//   - one name is the beginning of the other;
//   - the letters of the wanted name occur in the candidate's in this order, beginning with the
//   first;
//   - one name is a part of the other;
//   - the letters of the wanted name occur in the candidate's in this order;
//   - both have the same four letters in a row;
//   - one wanted name and one candidate are left.
std::vector<int> MatchImages(const std::vector<std::string>& wanted,
                             const std::vector<ImageCandidate>& candidates);

// Returns an 8.3 name for an image that no file names: "BALLTRAC.BIN" for "BallTracker".
std::string ShortImageName(const std::string& name);

}  // namespace openr_host
