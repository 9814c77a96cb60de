// Old sources that today's g++ refuses and the SDK's g++ 3.3 took: small changes to the private
// copy that `openr build` made of them.  The person's own files are never touched.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kit/kit_log.h"
#include "kit/repair_rules.h"
#include "kit/source_copies.h"

namespace openr_host {

// The repairs one compilation needs.  While it lives, no other one repairs: headers are shared.
class RepairSession {
 public:
  RepairSession();
  ~RepairSession();
  RepairSession(const RepairSession&) = delete;
  RepairSession& operator=(const RepairSession&) = delete;

  // Whether there is anything that may be changed at all.
  bool may_repair() const { return !copies_.empty(); }

  // Repairs what it can in one round.  `diagnostics`: the answer of g++ about `sources` with
  // -fdiagnostics-format=json.  False when it can repair nothing.
  bool Apply(const std::string& diagnostics, const std::vector<std::string>& sources);

  // They helped: says in the log what was done, in terms of the originals.
  void Keep();

  // They did not: the files are as they were.
  void Undo();

 private:
  void AddMacroEdits(const Complaint& complaint, const std::string& text,
                     std::map<std::string, std::vector<Edit>>* edits_of);

  const std::vector<SourceCopy> copies_;
  int lock_ = -1;
  std::map<std::string, std::string> former_;  // text of changed files
  std::vector<KitLog::Repair> repairs_;
};

}  // namespace openr_host
