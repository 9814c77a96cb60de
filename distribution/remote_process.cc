#include "distribution/remote_process.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "distribution/questions.h"
#include "distribution/remote_object.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int kSliceMs = 100;  // between looks at the process
constexpr int64_t kDelayMaxUs = int64_t{1} << 53;
constexpr int64_t kSilenceMs = 2'000;  // before people are told
// Boxes by which proxies wait for handlers of free runs; those of objects count from 1.
constexpr uint64_t kFirstFreeBox = uint64_t{1} << 40;

}  // namespace

RemoteProcess::RemoteProcess(Bus* bus, std::string name, std::function<std::string()> health,
                             std::function<void(const std::string&)> say)
    : name_(std::move(name)),
      health_(std::move(health)),
      say_(std::move(say)),
      line_(bus, name_, LineEnd::kMaster) {}

void RemoteProcess::Refuse(const std::string& what) {
  throw ProcessLost(
      fmt::format("process '{}' (pid {}) sent {}; is it the same openr?", name_, facts_.pid, what));
}

openr_wire_Down RemoteProcess::NewDown(openr_wire_DownKind kind) {
  openr_wire_Down down{};
  down.turn = ++turn_;
  down.body._d = kind;
  return down;
}

void RemoteProcess::Send(const openr_wire_Down& down) {
  try {
    line_.Send(down);
  } catch (const std::runtime_error& error) {  // nobody takes it, or DDS has no room
    throw ProcessLost(fmt::format("process '{}' (pid {}) takes nothing any more: {}", name_,
                                  facts_.pid, error.what()));
  }
}

RemoteProcess::Loan RemoteProcess::Next() {
  bool told = false;
  for (int64_t silent_ms = 0;; silent_ms += kSliceMs) {
    Loan up = line_.Receive(kSliceMs);
    if (up) {
      if (told) say_(fmt::format("process '{}' answers again", name_));
      return up;
    }
    const std::string problem = WhatIsWrong();
    if (!problem.empty()) {  // its last word may be on the way still
      Loan last = line_.Receive(kSliceMs);
      if (last) return last;
      throw ProcessLost(problem);
    }
    if (told || silent_ms < kSilenceMs) continue;
    told = true;
    say_(
        fmt::format("process '{}' (pid {}) has not answered for {} s: stopped, or busy; the run "
                    "waits for it",
                    name_, facts_.pid, kSilenceMs / 1000));
  }
}

std::string RemoteProcess::WhatIsWrong() const {
  std::string problem = health_();
  if (problem.empty() && !line_.IsConnected())
    problem = fmt::format("process '{}' (pid {} on {}) cannot be reached any more", name_,
                          facts_.pid, facts_.host);
  return problem;
}

void RemoteProcess::WaitForHello(int64_t limit_ms) {
  for (int64_t waited_ms = 0;; waited_ms += kSliceMs) {
    const Loan up = line_.Receive(kSliceMs);
    if (up) {
      if (up->body._d != openr_wire_UP_HELLO) Refuse("something before its name");
      const openr_wire_Hello& hello = up->body._u.hello;
      facts_ = {StringOf(hello.host), hello.pid};
      if (hello.version != openr_wire_VERSION)
        Refuse(fmt::format("version {} of the protocol, this is {}", hello.version,
                           openr_wire_VERSION));
      WaitUntilHeard(limit_ms - waited_ms);
      return;
    }
    const std::string problem = health_();
    if (!problem.empty()) throw ProcessLost(problem);
    if (waited_ms >= limit_ms)
      throw ProcessLost(
          fmt::format("process '{}' did not come within {} s; start it there with: "
                      "openr join --process {}",
                      name_, limit_ms / 1000, name_));
  }
}

// Its writer may be known here before its reader is; what is sent in between is lost.
void RemoteProcess::WaitUntilHeard(int64_t limit_ms) {
  for (int64_t waited_ms = 0; !line_.IsConnected(); ++waited_ms) {
    const std::string problem = health_();
    if (!problem.empty()) throw ProcessLost(problem);
    if (waited_ms >= limit_ms)
      throw ProcessLost(fmt::format("process '{}' does not hear this one", name_));
    usleep(1000);
  }
}

void RemoteProcess::Welcome(System* system, const openr_wire_Welcome& welcome) {
  system_ = system;
  courier_ = std::make_unique<Courier>(system, false);
  openr_wire_Down down = NewDown(openr_wire_DOWN_WELCOME);
  down.body._u.welcome = welcome;
  Send(down);
}

void RemoteProcess::Add(RemoteObject* object) { objects_[object->id] = object; }

void RemoteProcess::Load(const openr_wire_Load& load) {
  openr_wire_Down down = NewDown(openr_wire_DOWN_LOAD);
  down.body._u.load = load;
  Send(down);
  for (;;) {
    const Loan up = Next();
    if (Serve(*up)) continue;
    if (up->body._d == openr_wire_UP_CRASHED)
      throw ProcessCrashed(StringOf(up->body._u.crashed.text));
    if (up->body._d != openr_wire_UP_LOADED) Refuse("no list of its objects");
    Apply(*up, nullptr);
    const auto& loaded = up->body._u.loaded.objects;
    for (uint32_t i = 0; i < loaded._length; ++i) {
      const openr_wire_LoadedObject& entry = loaded._buffer[i];
      const auto found = objects_.find(entry.id);
      if (found == objects_.end()) Refuse("an object that is not its own");
      if (entry.problem != nullptr && *entry.problem != '\0') throw ProcessLost(entry.problem);
      TakeDescription(entry, found->second);
    }
    return;
  }
}

void RemoteProcess::RunHandler(RemoteObject* object, const Message& message) {
  if (crashed_) throw ProcessCrashed(loss_);
  if (!loss_.empty()) throw ProcessLost(loss_);
  {
    WireArena arena;
    openr_wire_Down down = NewDown(openr_wire_DOWN_DELIVER);
    openr_wire_Deliver& deliver = down.body._u.deliver;
    deliver.now_us = system_->now_us();
    const auto is_there = [this](uint32_t region) {
      return objects_.contains(system_->regions().OwnerOf(region));
    };
    courier_->Encode(message, is_there, &arena, &deliver.message);
    Send(down);
    courier_->Sent(message);
  }
  const Latency::Timer timer(&latency_);
  while (!is_lost_) {
    const Stop stop = is_free_ ? AwaitStop(object) : WaitForStop(object);
    if (stop.kind == openr_wire_STOP_DONE) return;
    if (stop.kind == openr_wire_STOP_READS) {
      ResumeWithLine(object, stop);
    } else {
      ResumeWithReply(object, stop);
    }
  }
}

RemoteProcess::Stop RemoteProcess::WaitForStop(RemoteObject* object) {
  for (;;) {
    const Loan up = Next();
    if (Serve(*up)) continue;
    if (up->body._d == openr_wire_UP_CRASHED)
      throw ProcessCrashed(StringOf(up->body._u.crashed.text));
    if (up->body._d != openr_wire_UP_STOPPED) Refuse("something in the middle of a handler");
    if (up->body._u.stopped.object != object->id) Refuse("the end of another object's handler");
    return TakeStop(*up);
  }
}

RemoteProcess::Stop RemoteProcess::TakeStop(const openr_wire_Up& up) {
  const openr_wire_Stopped& stopped = up.body._u.stopped;
  Object* const object = ObjectOf(stopped.object);
  Apply(up, object);
  object->state = StringOf(stopped.state);
  object->dropped_count += stopped.dropped - std::exchange(dropped_[object->id], stopped.dropped);
  object->stack_max = stopped.stack_max;
  return {stopped.kind, stopped.box, stopped.timeout_us, stopped.size, StringOf(stopped.why)};
}

RemoteProcess::Stop RemoteProcess::AwaitStop(RemoteObject* object) {
  const uint64_t box = kFirstFreeBox + turn_;
  object->boxes.insert(box);
  under_way_[object->id] = box;
  bool timed_out = false;
  Message* const wake =
      system_->AwaitReply(box, -1, fmt::format("its handler in process '{}'", name_), &timed_out);
  system_->queue().Release(wake);
  if (crashed_) throw ProcessCrashed(loss_);
  if (!loss_.empty()) throw ProcessLost(loss_);
  const Stop stop = std::move(stops_[object->id]);
  stops_.erase(object->id);
  return stop;
}

void RemoteProcess::Poll() {
  try {
    while (const Loan up = line_.Receive(0)) {
      if (loss_.empty()) TakeFree(*up);
    }
    if (!loss_.empty()) return;
    const std::string problem = WhatIsWrong();
    if (problem.empty()) return;
    if (const Loan last = line_.Receive(kSliceMs)) return TakeFree(*last);  // what it said at last
    throw ProcessLost(problem);
  } catch (const ProcessCrashed& crash) {
    LoseFree(crash.what(), true);
  } catch (const ProcessLost& lost) {
    LoseFree(lost.what(), false);
  }
}

void RemoteProcess::TakeFree(const openr_wire_Up& up) {
  if (Serve(up)) return;
  if (up.body._d == openr_wire_UP_CRASHED) throw ProcessCrashed(StringOf(up.body._u.crashed.text));
  if (up.body._d != openr_wire_UP_STOPPED) Refuse("something that is no end of a handler");
  const ObjectId object = up.body._u.stopped.object;
  if (!under_way_.contains(object)) Refuse("the end of a handler that was not begun");
  stops_[object] = TakeStop(up);
  WakeHandler(object);
}

// All handlers under way end here.  Objects that have none hear of it with their next message.
void RemoteProcess::LoseFree(const std::string& why, bool crashed) {
  loss_ = why;
  crashed_ = crashed;
  while (!under_way_.empty()) WakeHandler(under_way_.begin()->first);
}

void RemoteProcess::WakeHandler(ObjectId object) {
  Message* const wake = system_->NewMessage(object, 0);
  wake->message_class = MessageClass::kInput;
  wake->is_reply = true;
  wake->reply_box = under_way_[object];
  under_way_.erase(object);
  system_->Post(wake);
}

// The proxy's handler waits as the real one does; what comes meanwhile is other objects' turn.
void RemoteProcess::ResumeWithReply(RemoteObject* object, const Stop& stop) {
  openr_wire_Down down = NewDown(openr_wire_DOWN_RESUME);
  openr_wire_Resume& resume = down.body._u.resume;
  Message* const reply =
      system_->AwaitReply(stop.box, stop.timeout_us, stop.why, &resume.timed_out);
  if (is_lost_) {  // another object of the process brought it down meanwhile
    system_->queue().Release(reply);
    return;
  }
  WireArena arena;
  resume.now_us = system_->now_us();
  courier_->Encode(*reply, nullptr, &arena, &resume.reply);
  resume.reply.target = object->id;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  Send(down);
  system_->queue().Release(reply);
}

void RemoteProcess::ResumeWithLine(RemoteObject* object, const Stop& stop) {
  char line[Message::kPayloadMax];
  const size_t size = system_->console_input().Read(
      line, std::min<size_t>(std::max<uint32_t>(stop.size, 1), sizeof line));
  if (is_lost_) return;
  WireArena arena;
  openr_wire_Down down = NewDown(openr_wire_DOWN_RESUME);
  openr_wire_Resume& resume = down.body._u.resume;
  resume.now_us = system_->now_us();
  resume.reply.target = object->id;
  resume.reply.sender = kNoObject;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  resume.reply.payload._d = openr_wire_PAYLOAD_BYTES;
  resume.reply.payload._u.bytes = arena.Bytes(line, size);
  Send(down);
}

// What does not end a turn.  True when `up` was that.
bool RemoteProcess::Serve(const openr_wire_Up& up) {
  switch (up.body._d) {
    case openr_wire_UP_SAID:
      system_->Print(StringOf(up.body._u.said));
      return true;
    case openr_wire_UP_QUESTION: {
      const openr_wire_Question& in = up.body._u.question;
      Object* const self = ObjectOf(in.object);
      Apply(up, self);
      const CurrentScope scope(system_, self);
      SendAnswer(AnswerQuestion(system_, self,
                                {static_cast<QuestionKind>(in.kind), VectorOf(in.numbers),
                                 StringOf(in.text), StringOf(in.bytes)}));
      return true;
    }
    case openr_wire_UP_ENTRY: {
      const Object* const object = system_->object(up.body._u.entry.object);
      const bool has = object != nullptr && object->HasEntry(up.body._u.entry.selector);
      SendAnswer({has ? 1 : 0});
      return true;
    }
    case openr_wire_UP_POST: {
      Object* const self = ObjectOf(up.body._u.post.object);
      Apply(up, self);
      SendAnswer({Post(up.body._u.post.posted, self)});
      return true;
    }
    default:
      return false;
  }
}

Object* RemoteProcess::ObjectOf(ObjectId id) {
  const auto found = objects_.find(id);
  if (found == objects_.end()) Refuse("a request of an object that is not its own");
  return found->second;
}

void RemoteProcess::SendAnswer(const Answer& answer) {
  WireArena arena;
  openr_wire_Down down = NewDown(openr_wire_DOWN_ANSWER);
  down.body._u.answer = {answer.status, arena.Numbers(answer.numbers),
                         WireArena::View(answer.bytes.data(), answer.bytes.size())};
  Send(down);
}

void RemoteProcess::Apply(const openr_wire_Up& up, Object* self) {
  const CurrentScope scope(system_, self);
  for (uint32_t i = 0; i < up.effects._length; ++i) {
    const openr_wire_Effect& effect = up.effects._buffer[i];
    if (effect._d == openr_wire_EFFECT_POST) {
      Post(effect._u.posted, self);
    } else {
      const openr_wire_Note& note = effect._u.note;
      ApplyNote(static_cast<NoteKind>(note.kind), VectorOf(note.numbers), StringOf(note.text));
    }
  }
}

int32_t RemoteProcess::Post(const openr_wire_Posted& posted, Object* self) {
  const CurrentScope scope(system_, self);
  Message* const message = system_->NewMessage(posted.message.target, posted.message.selector);
  const MessageClass message_class = message->message_class;
  const uint64_t cause = message->cause;
  const std::string problem = courier_->Decode(posted.message, message);
  if (!problem.empty()) Refuse(problem);
  if (posted.delay_us < 0 || posted.delay_us > kDelayMaxUs) Refuse("a message for another time");
  message->number = 0;
  message->cause = cause;
  message->message_class = message_class;
  if (message->is_reply) {
    const Object* const asker = system_->object(message->target);
    if (asker == nullptr || !asker->boxes.contains(message->reply_box)) {
      system_->queue().Release(message);
      return sRBOXWASCLEANED;
    }
  }
  return system_->Post(message, posted.delay_us);
}

void RemoteProcess::ApplyNote(NoteKind kind, const std::vector<uint64_t>& numbers,
                              const std::string& text) {
  const auto number = [&](size_t i) { return i < numbers.size() ? numbers[i] : 0; };
  const auto region = static_cast<uint32_t>(number(0));
  Object* const self = t_current.object;
  switch (kind) {
    case NoteKind::kFinding:
      system_->AddFindingAbout(system_->object(static_cast<ObjectId>(number(1)) - 1),
                               static_cast<Severity>(number(0)), text);
      return;
    case NoteKind::kShutdown:
    case NoteKind::kPowerOff:
      if (number(0) >= static_cast<uint64_t>(system_->robot_count())) Refuse("an unknown robot");
      if (kind == NoteKind::kPowerOff) return system_->PowerOff(static_cast<int>(number(0)));
      return system_->Shutdown(static_cast<int>(number(0)));
    case NoteKind::kDeleteRegion:
      if (!objects_.contains(system_->regions().OwnerOf(region)))
        Refuse("the end of a region that is not its own");
      system_->regions().Delete(region);
      return;
    case NoteKind::kPin:
      ++pins_[region];
      return system_->regions().Pin(region);
    case NoteKind::kUnpin:
      if (--pins_[region] < 0) Refuse("a region given back twice");
      return system_->regions().Unpin(region);
    case NoteKind::kOwner:
      if (!objects_.contains(system_->regions().OwnerOf(region)))
        Refuse("a region that is not its own");
      return system_->regions().SetOwner(region, static_cast<ObjectId>(number(1)));
    default:
      break;
  }
  if (self == nullptr) return;
  switch (kind) {
    case NoteKind::kOpenBox:
      self->boxes.insert(number(0));
      self->last_box = std::max(self->last_box, number(0));
      return;
    case NoteKind::kCloseBox:
      self->boxes.erase(number(0));
      if (const auto reply = self->replies.find(number(0)); reply != self->replies.end()) {
        system_->queue().Release(reply->second);
        self->replies.erase(reply);
      }
      return;
    case NoteKind::kQueueMax:
      self->queue_max = static_cast<int>(number(0));
      return;
    case NoteKind::kMapBuffer:
      return MapBuffer(self, static_cast<uint32_t>(number(0)), static_cast<uint32_t>(number(1)),
                       number(2) != 0);
    case NoteKind::kEntryName:
      self->entry_names[static_cast<uint32_t>(number(0))] = text;
      return;
    default:
      Refuse(fmt::format("note {}", static_cast<uint32_t>(kind)));
  }
}

std::string RemoteProcess::FetchState(ObjectId object) {
  if (is_free_) return "";  // it has gone on meanwhile
  openr_wire_Down down = NewDown(openr_wire_DOWN_ASK_STATE);
  down.body._u.state_of = object;
  Send(down);
  const Loan up = Next();
  if (up->body._d != openr_wire_UP_STATE) Refuse("no state");
  const openr_wire_State& state = up->body._u.state;
  for (uint32_t i = 0; i < state.regions._length; ++i) {
    const openr_wire_RegionBytes& in = state.regions._buffer[i];
    if (courier_->HasBorrowed(in.region)) continue;
    char* const base = system_->regions().BaseOf(in.region);
    if (base == nullptr || in.bytes._length != system_->regions().SizeOf(in.region))
      Refuse(fmt::format("bytes of region {:#x}, which is not so", in.region));
    std::copy_n(in.bytes._buffer, in.bytes._length, reinterpret_cast<uint8_t*>(base));
  }
  return StringOf(state.subjects);
}

// To each subject as from its observer, which will not be ready any more.
void RemoteProcess::GiveBack() {
  for (const Courier::Lent& lent : courier_->TakeLent()) {
    const auto observer = objects_.find(lent.observer);
    if (observer == objects_.end()) continue;
    observer->second->Deassert(lent.observer_selector,
                               OServiceEntry(OidOf(lent.subject), lent.subject_selector),
                               {lent.region});
  }
}

void RemoteProcess::End() {
  courier_.reset();  // what it has borrowed is the System's
  if (is_lost_) return;
  openr_wire_Down down = NewDown(openr_wire_DOWN_END);
  try {
    Send(down);
  } catch (const ProcessLost&) {
    is_lost_ = true;
  }
}

}  // namespace openr_host
