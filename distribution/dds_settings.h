// Checks a file with settings of Cyclone DDS (--dds-config) for an error that Cyclone DDS does not
// report.
#pragma once

#include <string>

namespace openr_host {

// Returns why the settings in `file` do not apply to `domain`, with advice; "" if they do.
//
// Cyclone DDS silently ignores settings for another domain, so a run could be unprotected although
// the user gave security settings.  A file that cannot be read returns "", since Cyclone DDS
// reports that itself.
std::string WhyNotForDomain(const std::string& file, int domain);

}  // namespace openr_host
