// Checks the file with settings of Cyclone DDS that the user has given (--dds-config).  Finds
// settings that are for another DDS domain than the domain of the run.  Cyclone DDS ignores such
// settings without a message.
#pragma once

#include <string>

namespace openr_host {

// Returns why the settings in `file` do not apply to `domain`, with advice; "" if they apply.
//
// Cyclone DDS silently ignores settings for another domain, so a run could be unprotected although
// the user gave security settings.  Returns "" for a file that cannot be read, because Cyclone DDS
// reports this error itself.
std::string DomainProblem(const std::string& file, int domain);

}  // namespace openr_host
