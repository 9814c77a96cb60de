// Files with settings of Cyclone DDS (--dds-config), as far as it does not say what is wrong.
#pragma once

#include <string>

namespace openr_host {

// Cyclone DDS leaves settings for another domain out, without a word: a run would be open that
// somebody believes to be protected.  "" or which domains the settings of this file are for, none
// of them `domain`, and what to do.  A file that cannot be read is left to Cyclone DDS.
std::string WhyNotForDomain(const std::string& file, int domain);

}  // namespace openr_host
