#pragma once

#include <optional>
#include <string>
#include <vector>

namespace openr_host {

// Starts `arguments` (the first one is looked for in PATH), gives it `input` on its standard
// input and returns what it wrote to its standard output; nullopt when it cannot be started or
// ends with anything but 0.  For programs that read all of their input before they write.
std::optional<std::string> Filter(const std::vector<std::string>& arguments,
                                  const std::string& input);

}  // namespace openr_host
