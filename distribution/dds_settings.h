// Checks the file with settings of Cyclone DDS that the user has given (--dds-config).  Finds
// settings for another DDS domain than that of the run, which Cyclone DDS ignores without a
// message.
#pragma once

#include <string>

namespace openr_host {

// Returns why the settings in `file` do not apply to `domain`, with advice; "" if they apply.
//
// Cyclone DDS silently ignores settings for another domain, so a run could be unprotected although
// the user gave security settings.  A file that cannot be read returns "", since Cyclone DDS
// reports that itself.
std::string WhyNotForDomain(const std::string& file, int domain);

}  // namespace openr_host
