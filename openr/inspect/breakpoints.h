// Conditions at which a replay stops.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "openr/explore/property_file.h"
#include "openr/explore/quantity.h"
#include "openr/inspect/replayer.h"

namespace openr_host {

// The state of a replay as quantities see it (openr/explore/quantity.h).
class ReplayView {
 public:
  explicit ReplayView(Replayer* replayer);

  // Updates the values once a frame.  Called after every message.
  void Sample();
  const RunView& run() const { return run_; }

 private:
  Replayer* const replayer_;
  PreparedRun prepared_;
  std::vector<StandingMonitor> standing_;
  RunView run_;
  int64_t frame_ = -1;
};

// The breakpoints of a session.  They are kept as text, so that they survive going back: "object
// JointMover", "service Effector", "state JointMover accepting-commands", "when robots[0].pitch_deg
// > 10", "finding".
class Breakpoints {
 public:
  Breakpoints(Replayer* replayer, const ReplayView* view) : replayer_(replayer), view_(view) {}

  // Adds a breakpoint.  Returns "" or what is wrong with `text`.
  std::string Add(const std::string& text);
  // Removes breakpoint `number`, from 1.  Returns false if there is none.
  bool Remove(size_t number);
  size_t size() const { return all_.size(); }
  const std::string& text(size_t number) const { return all_[number - 1].text; }

  // Makes Hit() ignore conditions that hold now until they have been false once.
  void Arm();
  // Returns the number, from 1, of the first breakpoint that holds after the last message; 0 if
  // none does.
  size_t Hit();

  // Returns the breakpoints as text, one per line.
  std::string Save() const;
  void Load(const std::string& text);

 private:
  struct Break {
    std::string text;
    std::optional<PropertyRule> rule;  // for "when"
    Quantity quantity;                 // the quantity of `rule`
    bool held = false;
  };

  Break Read(const std::string& text) const;
  // The next two functions throw std::runtime_error when there is no object or service of this
  // name.
  void CheckObject(const std::string& name) const;
  void CheckService(const std::string& part) const;
  bool Holds(const Break& one) const;
  bool HoldsText(const std::string& text) const;

  Replayer* const replayer_;
  const ReplayView* const view_;
  std::vector<Break> all_;
};

}  // namespace openr_host
