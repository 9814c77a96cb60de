// ODA containers: several motions, sounds and light patterns in one file (docs/openr/mtn-format.md,
// section 4).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

struct OdaMember {
  std::string type;  // type of the member: "OMTN", "WAVE", "MIDI", "LED", "SYN" or "OSND"
  std::string name;  // name in the container: at most 128 bytes, not always readable text
  // Name for a file that has the content of this member, such as a motion.  The name has 8+3
  // characters, and each member of an ODA container has a different name.
  std::string file;
  std::string_view bytes;  // content, a part of the container's bytes
};

// The largest number of members (files) that an ODA container may have.  A container with more
// members is refused.  Containers of the robots' software have at most some hundred members.
constexpr size_t kOdaMembersMax = 4096;

// Returns the members of an ODA container (the files in it), in its order.  `bytes` must outlive
// the members.  If the bytes are no container, throws std::runtime_error with the mistake, such as
// "offset 8: ...".
std::vector<OdaMember> ReadOda(std::string_view bytes);

}  // namespace openr_host
