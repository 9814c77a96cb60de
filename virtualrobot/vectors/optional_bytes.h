// Optional bytes in the headers of vectors (Level 2 Reference Guide, 4.1).  With optional bytes,
// programs that send commands or sound pass data to programs that read sensors.
//
// The header of a command or sound vector names a range of its optional bytes.  The range is copied
// when the vector begins to play, and every later sensor vector carries the copy.  The robot may
// copy the bytes earlier, when it receives the vector; this is not known.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

class OptionalBytes {
 public:
  // Copies into this OptionalBytes the range of bytes that the header `sent` names.  Does nothing
  // when the range is empty.  If the range is out of bounds, copies nothing and adds a message to
  // `problems`.
  void CopyFrom(const ODataVectorInfo& sent, std::vector<std::string>* problems);

  // Writes the bytes that CopyFrom() has copied from a command or sound vector, and their range, to
  // `header`, the header of a sensor vector.
  void Put(ODataVectorInfo* header) const;

  void HashState(Hasher* hasher) const;

 private:
  longword offset_ = 0;
  longword size_ = 0;
  std::array<byte, odataOPTIONAL_MAX> bytes_{};
};

}  // namespace openr_host
