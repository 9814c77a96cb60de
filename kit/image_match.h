// Which image is meant by which line of OBJECT.CFG, where no Makefile says so.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct ImageCandidate {
  std::vector<std::string> names;  // of its object, file, folder and class, in any order
};

// For each of `wanted` ("BLNKLED.BIN") the index of its candidate, or -1.  Tried in turn, each
// time for what is left and only where it is unambiguous: equal names, in any case; the wanted
// name is the beginning of a candidate's, or the other way round; its letters occur in a
// candidate's name in this order, the first one first; either name is a part of the other; the
// letters occur in this order; both have four letters in a row in common; one is left on either
// side.
std::vector<int> MatchImages(const std::vector<std::string>& wanted,
                             const std::vector<ImageCandidate>& candidates);

// The 8.3 name for an image that nobody has named: "BallTracker" gives "BALLTRAC.BIN".
std::string ShortImageName(const std::string& name);

}  // namespace openr_host
