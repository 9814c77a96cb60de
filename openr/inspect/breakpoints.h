// Where a replay stops by itself.
#pragma once

#include <string>
#include <vector>

#include "openr/inspect/replayer.h"

namespace openr_host {

// As text, so that they survive going back: "object JointMover", "service Effector",
// "state JointMover accepting-commands", "finding".
class Breakpoints {
 public:
  // Returns what is wrong with `text`, or "".
  std::string Add(const std::string& text);
  // Returns false when there is no such number (from 1).
  bool Remove(size_t number);
  const std::vector<std::string>& all() const { return all_; }

  // The first one that holds after the message delivered last; 0: none.
  size_t Hit(Replayer* replayer) const;

  // One line each.
  std::string Save() const;
  void Load(const std::string& text);

 private:
  static bool Holds(const std::string& text, Replayer* replayer);
  std::vector<std::string> all_;
};

}  // namespace openr_host
