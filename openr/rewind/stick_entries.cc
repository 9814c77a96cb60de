#include "openr/rewind/stick_entries.h"

#include <utility>

#include "openr/inspect/trace_file.h"
#include "openr/rewind/saved_files.h"

namespace openr_host {

std::vector<TraceEntry> EntriesOf(const SavedStick& changed) {
  std::vector<TraceEntry> entries;
  // A replay restores the last entry first.  It must restore a folder before the files in the
  // folder, so the entry of a folder comes after the entries of its files.
  for (auto file = changed.files().rbegin(); file != changed.files().rend(); ++file) {
    const SavedStick::SavedFile& saved = file->second;
    TraceEntry entry;
    entry.kind = TraceEntry::Kind::kStick;
    entry.name = file->first;
    entry.what = saved.is_folder ? TraceEntry::PathKind::kFolder
                 : saved.content ? TraceEntry::PathKind::kFile
                                 : TraceEntry::PathKind::kNothing;
    entry.payload = saved.content.value_or("");
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace openr_host
