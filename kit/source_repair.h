// Repairs old sources that the SDK's g++ 3.3 accepted and today's g++ does not.  Changes only the
// private copy that `openr build` has made, never the user's own files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kit/kit_log.h"
#include "kit/repair_rules.h"
#include "kit/source_copies.h"

namespace openr_host {

// The repairs during one compilation.  While a session exists, other processes wait with their
// repairs, because headers are shared.
class RepairSession {
 public:
  RepairSession();
  ~RepairSession();
  RepairSession(const RepairSession&) = delete;
  RepairSession& operator=(const RepairSession&) = delete;

  // Returns whether there are private copies, which may be changed.
  bool may_repair() const { return !copies_.empty(); }

  // Makes one round of repairs.  `diagnostics` is the output of g++ with -fdiagnostics-format=json
  // for `sources`.  Returns false if nothing could be repaired.
  bool Apply(const std::string& diagnostics, const std::vector<std::string>& sources);

  // Keeps the repairs, and notes them in the log with the paths of the originals.
  void Keep();

  // Restores the files that were changed.
  void Undo();

 private:
  void AddMacroEdits(const Complaint& complaint, const std::string& text,
                     std::map<std::string, std::vector<Edit>>* edits_of);

  const std::vector<SourceCopy> copies_;
  int lock_ = -1;
  std::map<std::string, std::string> former_;  // by file: its text before the first repair
  std::vector<KitLog::Repair> repairs_;
};

}  // namespace openr_host
