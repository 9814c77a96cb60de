// Breakpoints: conditions at which a replay of a recorded run stops.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "openr/explore/property_file.h"
#include "openr/explore/quantity.h"
#include "openr/inspect/replayer.h"

namespace openr_host {

// The breakpoints of openr replay --step.  Each breakpoint is a text: "object JointMover", "service
// Effector", "state JointMover accepting-commands", "when robots[0].pitch_deg > 10", "finding".
// When the user goes back, another process carries out the commands (stepper.h), and the texts are
// passed to that process.
class Breakpoints {
 public:
  Breakpoints(Replayer* replayer, const SimulationView* view) : replayer_(replayer), view_(view) {}

  // Adds the breakpoint `text`.  Returns "", or the error in `text`.
  std::string Add(const std::string& text);
  // Removes the breakpoint `number`, counted from 1.  Returns false if no breakpoint has this
  // number.
  bool Remove(size_t number);
  size_t size() const { return all_.size(); }
  const std::string& text(size_t number) const { return all_[number - 1].text; }

  // Prepares the breakpoints; must be called before the replay runs on.  A "when" breakpoint whose
  // condition holds now would stop the replay again at the next message, so FindHit() ignores this
  // breakpoint until its condition has been false once.
  void Arm();
  // Tests all breakpoints.  Called when the replay has delivered a message.  Returns the number,
  // counted from 1, of the first breakpoint that stops the replay here; 0 if the replay goes on.
  size_t FindHit();

  // Returns all breakpoints as text, one per line.  Called when the user goes back, because another
  // process then carries out the user's commands and needs the breakpoints.
  std::string Save() const;
  // Replaces all breakpoints by those in `text`, which Save() has returned in another process of
  // openr replay --step, before the user went back.
  void Load(const std::string& text);

 private:
  struct Break {
    std::string text;
    std::optional<PropertyRule> rule;  // condition of a breakpoint "when"
    Quantity quantity;                 // the quantity that `rule` compares
    bool held = false;
  };

  Break Read(const std::string& text) const;
  // Throws std::runtime_error if no object has the name `name`.
  void CheckObject(const std::string& name) const;
  // Throws std::runtime_error if no entry (handler for messages) of any object has `part` in its
  // name.
  void CheckService(const std::string& part) const;
  bool Holds(const Break& one) const;
  bool HoldsText(const std::string& text) const;

  Replayer* const replayer_;
  const SimulationView* const view_;
  std::vector<Break> all_;
};

}  // namespace openr_host
