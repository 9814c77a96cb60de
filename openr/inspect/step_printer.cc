#include "openr/inspect/step_printer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>
#include <vector>

#include "cli/counted.h"
#include "cli/print_plain.h"
#include "openr/decode/decode_message.h"
#include "openr/inspect/trace_text.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {

void StepPrinter::Show() {
  if (replayer_->count() == 0) {
    PrintPlain("at the start; 'help' tells the commands\n");
  } else {
    PrintPlain("{}\n", DescribeMessage(replayer_->reader(), replayer_->last().record));
    const std::string said = OneLineOf(LastInWords());
    if (!said.empty()) PrintPlain("        {}\n", said);
  }
  if (!replayer_->difference().empty()) PrintPlain("difference: {}\n", replayer_->difference());
  if (!replayer_->loss().empty()) PrintPlain("{}\n", replayer_->loss());
  if (replayer_->at_end()) PrintPlain("at the end of the recording\n");
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
    PrintPlain("no message has come yet\n");
  } else if (replayer_->last().payload.empty()) {
    PrintPlain("the recording has no bytes of it\n");
  } else {
    PrintPlain("{}\n", LastInWords());
  }
}

void StepPrinter::PrintQueue() {
  System& system = replayer_->system();
  system.queue().ForEach([&](const Message& message) {
    const Object* const target = system.object(message.target);
    const std::string said = OneLineOf(DecodeHandled(system, message));
    PrintPlain("{:>7} due t={:.6f} to {} \"{}\"{}{}\n", message.number,
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
    for (const std::string& line : waits) PrintPlain("{}\n", line);
    if (waits.empty()) PrintPlain("nobody\n");
  } else if (what == "objects") {
    for (const auto& object : system.objects()) {
      if (object != nullptr)
        PrintPlain(
            "{:<20} {}, {} waiting, {} dropped{}\n", object->name,
            Counted(object->message_count(), "message"), object->waiting(),
            object->statistics().dropped_count(),
            object->statistics().state().empty() ? "" : ", state: " + object->statistics().state());
    }
  } else if (what == "joints") {
    for (const VirtualRobot* const robot : replayer_->simulation().robots()) {
      const auto& joints = robot->model().joints;
      for (size_t j = 0; j < joints.size(); ++j)
        PrintPlain("{:<14} {:9.3f} deg\n", joints[j].name,
                   Degrees(robot->body().state().joints[j].angle_rad));
    }
  } else if (what == "findings") {
    for (const Finding& finding : system.findings().all())
      PrintPlain("{}: {}{}\n", finding.object, finding.text,
                 MessageInParentheses(finding.message, finding.said));
    if (system.findings().all().empty()) PrintPlain("none so far\n");
  } else if (what == "message") {
    PrintMessage();
  } else if (what == "hash") {
    PrintPlain("trace {:016x} state {:016x}\n", system.trace_hash(), system.state_hash());
  } else {
    PrintQuantity(what);
  }
}

void StepPrinter::PrintQuantity(const std::string& name) {
  try {
    const Value value = FindQuantity(name, view_->run())(view_->run());
    std::visit([&](const auto& known) { PrintPlain("{} is {}\n", name, known); }, value);
  } catch (const std::runtime_error& error) {
    PrintPlain("{}; print queue, waiting, objects, joints, findings, hash, message or a quantity\n",
               error.what());
  }
}

}  // namespace openr_host
