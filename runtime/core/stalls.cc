#include "runtime/core/stalls.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

double Seconds(int64_t us) { return static_cast<double>(us) * 1e-6; }

constexpr char kReadyAdvice[] =
    "an observer gets nothing until it asserts ready, again after every notification";

// Adds to `stalls` the wait for a ready on the connection `link` of `subject`.  Adds nothing if the
// observer has deasserted ready (link.ready < 0), because the observer does not want data then.
// Adds nothing if the observer is ready (link.ready > 0).  Data that wait for a ready observer may
// wait on purpose, because the observer can ask for several notifications in one message
// (ObserverLink::min).
void FindInLink(const Object& object, const SubjectState& subject, const ObserverLink& link,
                int64_t now_us, std::vector<Stall>* stalls) {
  if (link.ready != 0) return;
  const bool is_chosen = object.is_system() || link.sent >= 2;
  if (link.waiting_since_us >= 0) {
    stalls->push_back({object.id, link.waiting_since_us,
                       fmt::format("{} waits for ready of {} on {} since t={:.3f} s", object.name,
                                   link.name, subject.service, Seconds(link.waiting_since_us)),
                       kReadyAdvice, false, is_chosen});
  } else if (link.sent == 0 && now_us >= kStallUs) {
    stalls->push_back({object.id, 0,
                       fmt::format("{} has never asserted ready to {}", link.name, subject.service),
                       kReadyAdvice, true, is_chosen});
  } else if (now_us - link.sent_us >= kStallUs) {
    stalls->push_back({object.id, link.sent_us,
                       fmt::format("{} has not asserted ready to {} since its notification of "
                                   "t={:.3f} s",
                                   link.name, subject.service, Seconds(link.sent_us)),
                       kReadyAdvice, true, is_chosen});
  }
}

void FindIn(const Object& object, int64_t now_us, std::vector<Stall>* stalls) {
  if (object.delivery().blocked() != nullptr) {
    stalls->push_back(
        {object.id, object.wait().since_us(),
         fmt::format("{} waits for {} since t={:.3f} s", object.name, object.wait().why(),
                     Seconds(object.wait().since_us())),
         object.wait().why() == ConsoleInput::kWaitReason
             ? "nobody has typed one: openr run --stdin FILE"
             : "two objects that Call() each other wait for ever; with --cost, a handler "
               "may take that long"});
  }
  if (object.processor().starving_since_us() >= 0) {
    stalls->push_back({object.id, object.processor().starving_since_us(),
                       fmt::format("{} waits for the processor since t={:.3f} s", object.name,
                                   Seconds(object.processor().starving_since_us())),
                       "others of the same or a higher priority leave it none"});
  }
  for (const auto& subject : object.subjects()) {
    for (const ObserverLink& link : subject->links)
      FindInLink(object, *subject, link, now_us, stalls);
  }
}

}  // namespace

std::vector<Stall> FindStalls(const System& system, int64_t least_us) {
  std::vector<Stall> stalls;
  for (const auto& object : system.objects()) {
    if (object != nullptr && !object->delivery().is_off())
      FindIn(*object, system.now_us(), &stalls);
  }
  std::erase_if(stalls, [latest_us = system.now_us() - least_us](const Stall& stall) {
    return stall.since_us > latest_us;
  });
  return stalls;
}

std::vector<std::string> DescribeWaits(const System& system) {
  std::vector<std::string> lines;
  for (Stall& stall : FindStalls(system, 0)) lines.push_back(std::move(stall.text));
  return lines;
}

void ReportStalls(System* system, bool is_silent) {
  for (const Stall& stall : FindStalls(*system, kStallUs)) {
    if (stall.may_be_done && !is_silent) continue;
    system->AddFindingAbout(system->object(stall.object),
                            stall.is_chosen ? Severity::kNote : Severity::kWarning,
                            fmt::format("{}; {}", stall.text, stall.advice));
  }
}

}  // namespace openr_host
