// Finds, by comparing names, the built image that a line of OBJECT.CFG means.  The search is needed
// when no rule of a Makefile copies an image to the name in that line.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct ImageCandidate {
  // The names by which OBJECT.CFG may mean the image, in any order: the names of its object, its
  // file, its folder and its class.
  std::vector<std::string> names;
};

// Returns for each name of `wanted` ("BLNKLED.BIN") the index of its candidate (the built image
// that OBJECT.CFG means by this name), or -1.  The rules below are tried one after the other, each
// for the names that have no candidate yet.  A rule pairs a name and a candidate only if no other
// candidate fits the name and no other name fits the candidate.  All rules ignore upper and lower
// case:
//   - the names are equal;
//   - one name is the beginning of the other;
//   - the letters of the wanted name occur in the candidate's name in this order, and both names
//     have the same first letter;
//   - one name is a part of the other;
//   - the letters of the wanted name occur in the candidate's name in this order;
//   - both have the same four letters in a row;
//   - only one wanted name and one candidate are left.
std::vector<int> MatchImages(const std::vector<std::string>& wanted,
                             const std::vector<ImageCandidate>& candidates);

// Returns a file name for an image that neither OBJECT.CFG nor a Makefile names, with at most eight
// letters or digits before the dot: "BALLTRAC.BIN" for "BallTracker".
std::string ShortImageName(const std::string& name);

}  // namespace openr_host
