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

// The repairs during one compilation.  While a session exists, other compiler processes wait before
// they repair files, because two processes must not repair the same header at the same time.
class RepairSession {
 public:
  RepairSession();
  ~RepairSession();
  RepairSession(const RepairSession&) = delete;
  RepairSession& operator=(const RepairSession&) = delete;

  // Returns whether files may be repaired.  This is true only if `openr build` has made private
  // copies, because the user's own files are never changed.
  bool may_repair() const { return !copies_.empty(); }

  // Repairs the files for the errors in `diagnostics`, the output of g++ with
  // -fdiagnostics-format=json for `sources`.  Returns false if nothing could be repaired.
  bool Apply(const std::string& diagnostics, const std::vector<std::string>& sources);

  // Adds the repairs that this session has made to the log (kit_log.h).  The log names the user's
  // own files and not their private copies.  Called if the repaired sources compile; otherwise
  // Undo() is called.
  void Keep();

  // Restores the text that the changed private copies had before this session repaired them.
  void Undo();

 private:
  void AddMacroEdits(const CompilerError& error, const std::string& text,
                     std::map<std::string, std::vector<Edit>>* edits_of);

  const std::vector<SourceCopy> copies_;
  int lock_ = -1;
  std::map<std::string, std::string> former_;  // texts of files before their first repair
  std::vector<KitLog::Repair> repairs_;
};

}  // namespace openr_host
