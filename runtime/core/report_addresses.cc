// Reports messages that hold an address of this process.  Such an address differs from run to run.
// The hash of a run includes the data of messages, so an address in a message gives equal runs
// different hashes.
#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include "runtime/core/host_addresses.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Describes for a finding what sent `message`: "the subject 'A.B.C.S'" for a notification, "an
// answer" for a reply.  A message of any other kind has no subject, so the text names the entry to
// which the message goes: "a message to JointMover, Move (Notify)".
std::string SenderOf(const Message& message, const Object& sender) {
  if (message.is_reply) return "an answer";
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (const auto& subject : sender.subjects()) {
      if (subject->id == notify.subjectID) return fmt::format("the subject '{}'", subject->service);
    }
  }
  const Object* const target = sender.system->object(message.target);
  return fmt::format(
      "a message to {}",
      target == nullptr ? "nobody"
                        : fmt::format("{}, {}", target->name, target->EntryName(message.selector)));
}

}  // namespace

void HostAddresses::Report(const Message& message) {
  const Object& sender = *t_current.object;
  if (sender.system->object(message.target) == nullptr) return;
  const ApiScope scope;
  int64_t offset = -1;
  int datum = 0;
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (; datum < notify.numOfData; ++datum) {
      const RCRegion* const region = notify.data[datum].srcRCR;
      offset = FindIn(region->Base(), notify.data[datum].size);
      if (offset >= 0) break;
    }
  } else if (message.kind == PayloadKind::kBytes) {
    offset = FindIn(message.payload, message.size);
  }
  if (offset < 0) return;
  std::string where = fmt::format("{} sends an address of this process at offset {}",
                                  SenderOf(message, sender), offset);
  if (datum > 0) where += fmt::format(" of datum {}", datum);
  sender.system->AddFinding(
      Severity::kWarning,
      where + "; each run has another one there, and other hashes (docs/cli.md, Equal runs)");
}

}  // namespace openr_host
