// Where a replay stops by itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "openr/explore/property_file.h"
#include "openr/explore/quantity.h"
#include "openr/inspect/replayer.h"

namespace openr_host {

// A replay as quantities see it (openr/explore/quantity.h).
class ReplayView {
 public:
  explicit ReplayView(Replayer* replayer);

  // After every message: what has to be looked at once a frame.
  void Sample();
  const RunView& run() const { return run_; }

 private:
  Replayer* const replayer_;
  PreparedRun prepared_;
  std::vector<StandingMonitor> standing_;
  RunView run_;
  int64_t frame_ = -1;
};

// As text, so that they survive going back: "object JointMover", "service Effector",
// "state JointMover accepting-commands", "when robots[0].pitch_deg > 10", "finding".
class Breakpoints {
 public:
  Breakpoints(Replayer* replayer, const ReplayView* view) : replayer_(replayer), view_(view) {}

  // Returns what is wrong with `text`, or "".
  std::string Add(const std::string& text);
  // Returns false when there is no such number (from 1).
  bool Remove(size_t number);
  size_t size() const { return all_.size(); }
  const std::string& text(size_t number) const { return all_[number - 1].text; }

  // Conditions that hold now count when they hold again after they did not.
  void Arm();
  // The first one that holds after the message delivered last; 0: none.
  size_t Hit();

  // One line each.
  std::string Save() const;
  void Load(const std::string& text);

 private:
  struct Break {
    std::string text;
    std::optional<PropertyRule> rule;  // of "when"
    Quantity quantity;                 // of `rule`
    bool held = false;
  };

  Break Read(const std::string& text) const;
  // Throw std::runtime_error when there is none such.
  void CheckObject(const std::string& name) const;
  void CheckService(const std::string& part) const;
  bool Holds(const Break& one) const;
  bool HoldsText(const std::string& text) const;

  Replayer* const replayer_;
  const ReplayView* const view_;
  std::vector<Break> all_;
};

}  // namespace openr_host
