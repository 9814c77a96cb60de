// StepPrinter: prints what the user of openr replay --step asks for.
#pragma once

#include <string>

#include "openr/explore/quantity.h"
#include "openr/inspect/replayer.h"

namespace openr_host {

class StepPrinter {
 public:
  // Makes a StepPrinter that prints the present state of `replayer`, and quantities of `view`.
  // Both must outlive the StepPrinter.
  StepPrinter(Replayer* replayer, SimulationView* view) : replayer_(replayer), view_(view) {}

  // Prints where the replay is: the message that was delivered last, and differences from the
  // recording.
  void Show();

  // Prints what the command "print" names in `what`: "queue", "waiting", "objects", "joints",
  // "findings", "message", "hash" or a quantity.
  void Print(const std::string& what);

 private:
  // Returns the recorded content of the message that was delivered last, in words; "" if the
  // recording does not have it.
  std::string LastInWords() const;
  void PrintMessage();
  void PrintQueue();
  void PrintQuantity(const std::string& name);

  Replayer* const replayer_;
  SimulationView* const view_;
};

}  // namespace openr_host
