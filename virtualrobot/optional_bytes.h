// The mail slot between whoever sends commands or sound and whoever reads sensors: bytes
// that ride in the header of a vector (Level 2 Reference Guide, 4.1).
//
// The marked range of a command or sound vector is copied when the vector begins to play,
// and stands in every sensor vector that is made from then on.  Whether the robot copies
// at reception instead is not known.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

class OptionalBytes {
 public:
  // Copies the range that `sent` marks, if any; one that is out of bounds is a problem.
  void Take(const ODataVectorInfo& sent, std::vector<std::string>* problems);

  // Into the header of a sensor vector.
  void Put(ODataVectorInfo* header) const;

  void HashState(Hasher* hasher) const;

 private:
  longword offset_ = 0;
  longword size_ = 0;
  std::array<byte, odataOPTIONAL_MAX> bytes_{};
};

}  // namespace openr_host
