// Entries of a recording that restore files of the stick.
#pragma once

#include <vector>

namespace openr_host {

class SavedStick;
struct TraceEntry;

// Returns entries for the recording of a branch.  By these entries, a replay of the branch restores
// the files `changed`, which the first run has changed on its stick.
std::vector<TraceEntry> EntriesOf(const SavedStick& changed);

}  // namespace openr_host
