// Optional bytes in the headers of vectors (Level 2 Reference Guide, 4.1).  With them, programs
// that send commands or sound pass data to programs that read sensors.
//
// A command or sound vector marks a range of bytes in its header.  The range is copied when the
// vector begins to play, and every later sensor vector carries the copy.  It is not known whether
// the robot copies when it receives the vector instead.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

class OptionalBytes {
 public:
  // Copies the range that `sent` marks, if any.  Describes in `problems` a range that is out of
  // bounds.
  void Take(const ODataVectorInfo& sent, std::vector<std::string>* problems);

  // Writes the copy into the header of a sensor vector.
  void Put(ODataVectorInfo* header) const;

  void HashState(Hasher* hasher) const;

 private:
  longword offset_ = 0;
  longword size_ = 0;
  std::array<byte, odataOPTIONAL_MAX> bytes_{};
};

}  // namespace openr_host
