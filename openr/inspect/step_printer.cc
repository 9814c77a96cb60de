#include "openr/inspect/step_printer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>
#include <vector>

#include "cli/counted.h"
#include "openr/decode/decode_message.h"
#include "openr/inspect/trace_text.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {

void StepPrinter::Show() {
  if (replayer_->count() == 0) {
    fmt::print("at the start; 'help' tells the commands\n");
  } else {
    fmt::print("{}\n", DescribeMessage(replayer_->reader(), replayer_->last().record));
    const std::string said = OneLineOf(LastInWords());
    if (!said.empty()) fmt::print("        {}\n", said);
  }
  if (!replayer_->difference().empty()) fmt::print("difference: {}\n", replayer_->difference());
  if (!replayer_->loss().empty()) fmt::print("{}\n", replayer_->loss());
  if (replayer_->at_end()) fmt::print("at the end of the recording\n");
}

std::string StepPrinter::LastInWords() const {
  const TraceEntry& last = replayer_->last();
  if (last.payload.empty()) return "";
  const std::string entry = replayer_->reader().EntryName(last.record.target, last.record.selector);
  return DecodeContent(replayer_->simulation().model(), entry, last.payload);
}

// Prints the values in the message that was delivered last.
void StepPrinter::PrintMessage() {
  if (replayer_->count() == 0) {
    fmt::print("no message has come yet\n");
  } else if (replayer_->last().payload.empty()) {
    fmt::print("the recording has no bytes of it\n");
  } else {
    fmt::print("{}\n", LastInWords());
  }
}

void StepPrinter::PrintQueue() {
  System& system = replayer_->system();
  system.queue().ForEach([&](const Message& message) {
    const Object* const target = system.object(message.target);
    const std::string said = OneLineOf(DecodeHandled(system, message));
    fmt::print("{:>7} due t={:.6f} to {} \"{}\"{}{}\n", message.number,
               static_cast<double>(message.due_us) / 1e6, target->name,
               target->EntryName(message.is_reply ? UNDEF : message.selector),
               said.empty() ? "" : ": ", said);
  });
}

void StepPrinter::Print(const std::string& what) {
  System& system = replayer_->system();
  if (what == "queue") {
    PrintQueue();
  } else if (what == "waiting") {
    const std::vector<std::string> waits = DescribeWaits(system);
    for (const std::string& line : waits) fmt::print("{}\n", line);
    if (waits.empty()) fmt::print("nobody\n");
  } else if (what == "objects") {
    for (const auto& object : system.objects()) {
      if (object != nullptr)
        fmt::print(
            "{:<20} {}, {} waiting, {} dropped{}\n", object->name,
            Counted(object->message_count(), "message"), object->waiting(),
            object->statistics().dropped_count(),
            object->statistics().state().empty() ? "" : ", state: " + object->statistics().state());
    }
  } else if (what == "joints") {
    for (const VirtualRobot* const robot : replayer_->simulation().robots()) {
      const auto& joints = robot->model().joints;
      for (size_t j = 0; j < joints.size(); ++j)
        fmt::print("{:<14} {:9.3f} deg\n", joints[j].name,
                   Degrees(robot->body().state().joints[j].angle_rad));
    }
  } else if (what == "findings") {
    for (const Finding& finding : system.findings().all())
      fmt::print("{}: {}{}\n", finding.object, finding.text,
                 MessageInParentheses(finding.message, finding.said));
    if (system.findings().all().empty()) fmt::print("none so far\n");
  } else if (what == "message") {
    PrintMessage();
  } else if (what == "hash") {
    fmt::print("trace {:016x} state {:016x}\n", system.trace_hash(), system.state_hash());
  } else {
    PrintQuantity(what);
  }
}

void StepPrinter::PrintQuantity(const std::string& name) {
  try {
    const Value value = FindQuantity(name, view_->run())(view_->run());
    std::visit([&](const auto& known) { fmt::print("{} is {}\n", name, known); }, value);
  } catch (const std::runtime_error& error) {
    fmt::print("{}; print queue, waiting, objects, joints, findings, hash, message or a quantity\n",
               error.what());
  }
}

}  // namespace openr_host
