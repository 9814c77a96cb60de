#include "distribution/questions.h"

#include <MCOOP.h>
#include <OPENR/OPENR.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <vector>

#include "distribution/remote_object.h"
#include "distribution/remote_services.h"
#include "runtime/api/mcoop_limits.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

// Longer times are refused; a RelativeTime cannot hold them anyway.
constexpr uint64_t kTimeMaxUs = uint64_t{1} << 53;

uint64_t Number(const Question& question, size_t i) {
  return i < question.numbers.size() ? question.numbers[i] : 0;
}

// Whether object `id` is in the same process as `self`.
bool IsBeside(const System& system, const Object* self, ObjectId id) {
  const auto* const asker = dynamic_cast<const RemoteObject*>(self);
  const auto* const other = dynamic_cast<const RemoteObject*>(system.object(id));
  return asker != nullptr && other != nullptr && asker->process() == other->process();
}

Answer NewRegion(System* system, const Object* self, const Question& question) {
  const auto owner = static_cast<ObjectId>(Number(question, 1));
  if (Number(question, 0) > kRobotMemoryBytes ||
      (owner != kNoObject && !IsBeside(*system, self, owner)))
    return {0, {RegionTable::kNoRegion}};
  return {0, {system->regions().New(Number(question, 0), owner)}};
}

// Resizes a region; false if that failed or the region belongs to another process.
bool ResizeRegion(System* system, const Object* self, const Question& question) {
  const auto region = static_cast<uint32_t>(Number(question, 0));
  return IsBeside(*system, self, system->regions().OwnerOf(region)) &&
         system->regions().Resize(region, Number(question, 1));
}

// Whether the question sets a colour table in memory of another process, which is an error finding.
bool IsCdtOfAnother(System* system, const Object* self, const Question& question) {
  // The bytes of a colour table are copied to its region, so the region must be one that the worker
  // may write.
  if (!IsSetCdt(question)) return false;
  const auto region = static_cast<uint32_t>(Number(question, 1));
  const RegionTable& regions = system->regions();
  if (regions.BaseOf(region) == nullptr || IsBeside(*system, self, regions.OwnerOf(region)) ||
      IsBeside(*system, self, regions.MakerOf(region)))
    return false;
  system->AddFindingAbout(
      self, Severity::kError,
      fmt::format("SetCdtVectorData({:#x}): the memory is in another process of a distributed run; "
                  "place both objects in one",
                  region));
  return true;
}

// Does what OObject::RegisterServiceEntry() does.
Answer RegisterService(System* system, Object* self, const Question& question) {
  const auto target = static_cast<ObjectId>(Number(question, 0));
  const auto selector = static_cast<uint32_t>(Number(question, 1));
  if (!IsBeside(*system, self, target)) return {oFAIL};
  auto& directory = system->robot(self->robot).directory;
  if (!directory.emplace(question.text, std::pair(target, selector)).second)
    return {oALREADY_EXIST};
  self->services[selector] = question.text;
  return {oSUCCESS};
}

TimeEvents::Letter LetterOf(Object* self, const Question& question) {
  const std::string bytes = question.bytes.substr(0, Message::kPayloadMax);
  return {self->id,
          static_cast<ObjectId>(Number(question, 0)),
          static_cast<uint32_t>(Number(question, 1)),
          {bytes.begin(), bytes.end()}};
}

Answer AnswerEvents(System* system, Object* self, const Question& question) {
  TimeEvents& events = system->time_events();
  switch (question.kind) {
    case QuestionKind::kTimedEvent:
      if (Number(question, 2) > kTimeMaxUs || Number(question, 3) > kTimeMaxUs) return {0, {0}};
      return {0,
              {events.AddTimed(LetterOf(self, question), static_cast<int64_t>(Number(question, 2)),
                               static_cast<int64_t>(Number(question, 3)))}};
    // The reply may have arrived before the question about it.
    case QuestionKind::kReplyEvent: {
      const uint64_t box = Number(question, 2);
      const uint32_t event = events.AddReply(LetterOf(self, question), box);
      if (self->replies.contains(box)) events.ReplyArrived(self->id, box);
      return {0, {event}};
    }
    case QuestionKind::kCancelEvent:
      return {events.Cancel(self->id, static_cast<uint32_t>(Number(question, 0))) ? 1 : 0};
    default:
      return {0, {static_cast<uint64_t>(events.CountOf(self->id))}};
  }
}

Answer AnswerNames(const Question& question) {
  OID oid;
  switch (question.kind) {
    case QuestionKind::kRegisterName:
      return {Register(OidOf(static_cast<ObjectId>(Number(question, 0))), question.text.c_str())};
    case QuestionKind::kFindName: {
      const sError error = Find(question.text.c_str(), &oid);
      return {error, {static_cast<uint64_t>(ObjectIdOf(oid))}};
    }
    default:
      return {Unregister(question.text.c_str())};
  }
}

}  // namespace

Answer AnswerQuestion(System* system, Object* self, const Question& question) {
  switch (question.kind) {
    case QuestionKind::kNewRegion:
      return NewRegion(system, self, question);
    case QuestionKind::kResizeRegion:
      return {ResizeRegion(system, self, question) ? 1 : 0};
    case QuestionKind::kRegisterService:
      return RegisterService(system, self, question);
    case QuestionKind::kTimedEvent:
    case QuestionKind::kReplyEvent:
    case QuestionKind::kCancelEvent:
    case QuestionKind::kEventCount:
      return AnswerEvents(system, self, question);
    case QuestionKind::kRegisterName:
    case QuestionKind::kFindName:
    case QuestionKind::kUnregisterName:
      return AnswerNames(question);
    case QuestionKind::kCheckShare:
      return {system->region_shares().Serve(self->id, question.numbers)};
    case QuestionKind::kWriteFile:
      if (MemoryStick* const stick = system->robot(self->robot).stick.get())
        stick->NoteWritten(question.text);
      return {0};
    case QuestionKind::kService:
      if (IsCdtOfAnother(system, self, question)) return {oINVALID_ARG};
      return ServeRobotCall(system, self->robot, question);
  }
  return {oNOT_SUPPORTED};
}

void MapBuffer(Object* self, uint32_t cookie, uint32_t region, bool mapped) {
  const CurrentScope scope(self->system, self);
  IpStack* const stack = IpStack::OfCurrent();
  if (stack == nullptr) return;
  const antSharedBuffer buffer(region, 0, cookie);
  void* base = nullptr;
  if (mapped) {
    stack->buffers().Map(buffer, &base);
  } else {
    stack->buffers().UnMap(buffer);
  }
}

void ApplyDescription(const openr_wire_LoadedObject& in, RemoteObject* object) {
  object->limits.priority = std::clamp(in.priority, 0, 255);
  object->limits.stack_bytes = in.stack_bytes;
  object->limits.heap_bytes = in.heap_bytes;
  std::set<uint32_t> selectors;
  for (uint32_t i = 0; i < in.selectors._length; ++i)
    selectors.insert(static_cast<uint32_t>(in.selectors._buffer[i]));
  object->set_selectors(std::move(selectors));
  for (uint32_t i = 0; i < in.names._length; ++i)
    object->entry_names[in.names._buffer[i].selector] = in.names._buffer[i].name;
}

}  // namespace openr_host
