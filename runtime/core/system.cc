#include "runtime/core/system.h"

#include <fmt/format.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/code_object.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/guard_pages.h"
#include "runtime/core/local_calls.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/run_folder.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system_inputs.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {

static_assert(sizeof(ONotifyMessage) <= Message::kPayloadMax);
static_assert(sizeof(OReadyMessage) <= Message::kPayloadMax);

namespace {

// Returns the state of the run for the message of a failed assertion.  Clears t_current, so that
// printing the message uses the host's heap and files and not those of the object.
std::string RunContext() {
  const System* const system = t_current.system;
  const Object* const object = t_current.object;
  t_current = {};
  if (system == nullptr) return "";
  return fmt::format(
      "  t={} us, object {}, message {}, seed {}\n", system->now_us(),
      object == nullptr ? "(none)" : object->name,
      object == nullptr || object->running() == nullptr ? 0 : object->running()->number,
      system->options().seed);
}

// Makes the C library allocate the buffer of stdout now.  Otherwise the C library allocates the
// buffer at the first print, on the heap of the object that prints, and the buffer is freed
// together with that object.
void AllocateStandardOutput() {
  if (__fbufsize(stdout) > 0) return;
  setvbuf(stdout, nullptr, _IOFBF, 0);
  if (isatty(STDOUT_FILENO)) setvbuf(stdout, nullptr, _IOLBF, 0);
}

}  // namespace

System::System(SystemOptions options)
    : options_(std::move(options)),
      calls_are_local_(!options_.make_calls),
      calls_(options_.make_calls ? options_.make_calls(this) : std::make_unique<LocalCalls>(this)),
      poster_(calls_are_local_, options_.seed),
      dispatcher_(std::make_unique<Dispatcher>(this)) {
  AllocateStandardOutput();
  assert_context = &RunContext;
  using GivenBack = GuardPages::GivenBack;
  if (options_.guard_regions) {
    guard_pages_ = std::make_unique<GuardPages>(GivenBack::kGone);
  } else if (options_.strict) {
    guard_pages_ = std::make_unique<GuardPages>(GivenBack::kReused);
  }
  manager_ = AddObject<ObjectManager>(0, "oobjectManager");
  manager_->host().set_system(true);
  manager_->host().set_priority(0);
  AddSystemInputs(this);
  table_.OnEnd([this](ObjectId id) { time_events_.ForgetObject(id); });
}

System::~System() = default;

int System::AddRobot(const std::string& design, std::shared_ptr<MemoryStick> stick) {
  const int index = robot_table_.Add(design, std::move(stick));
  if (options_.cost) {
    dispatcher_->AddProcessor();
    poster_.NoteProcessors();
  }
  dispatcher_->CheckDeliveries();
  return index;
}

Object* System::NewCodeHost(int robot, const std::string& name) {
  auto host = std::make_unique<CodeHost>(this, table_.IdFor(robot, name), robot);
  host->name = name;
  return table_.Adopt(std::move(host));
}

CodeObject* System::FinishCodeObject(Object* host, std::unique_ptr<CodeObject> code) {
  auto* const code_host = static_cast<CodeHost*>(host);
  code_host->SetCode(std::move(code));
  return code_host->code.get();
}

RunFolder* System::run_folder() {
  if (run_folder_ == nullptr) run_folder_ = std::make_unique<RunFolder>();
  return run_folder_.get();
}

void System::Connect(Connection connection) {
  const Robot& dog = robot(connection.robot);
  ASSERT(!booted() || dog.powered_off, "robot {} is on already", connection.robot);
  robot_table_.Connect(std::move(connection));
}

void System::set_schedule(Schedule* schedule) {
  ASSERT(poster_.last_number() == 0, "the run has begun with another schedule");
  poster_.set_schedule(schedule);
}

bool System::booted() const { return manager_->has_booted(); }

void System::Boot() { manager_->PostBoot(); }

void System::PostTask(std::function<void()> task) { manager_->PostTask(std::move(task)); }

void System::Shutdown(int robot, const RunEnd& why) { calls_->Shutdown(robot, why); }

void System::Reseed(uint64_t seed) {
  ASSERT(poster_.last_number() == 0, "a run that has begun has drawn its numbers");
  options_.seed = seed;
  for (const auto& robot : robot_table_.all()) robot->services->Reseed(seed);
}

void System::Shutdown(const RunEnd& why) {
  // Shuts down at least robot 0, because in a System without robots, as in some tests, all objects
  // belong to robot 0.
  for (int i = 0; i < std::max(1, robot_count()); ++i) Shutdown(i, why);
}

void System::PowerOff(int robot, const RunEnd& why) { calls_->PowerOff(robot, why); }

bool System::Step() {
  const uint64_t before = trace_.count();
  dispatcher_->Run({.messages = 1});
  return trace_.count() != before;
}

void System::RunOne(int64_t time_us) { dispatcher_->Run({.time_us = time_us, .messages = 1}); }

void System::RunMessages(uint64_t count) { dispatcher_->Run({.messages = count}); }

void System::RunUntil(int64_t time_us) {
  ASSERT(time_us >= now_us(), "{} us is in the past, now is {} us", time_us, now_us());
  dispatcher_->Run({.time_us = time_us});
}

bool System::RunUntil(const std::function<bool()>& predicate, int64_t budget_us) {
  ASSERT(budget_us >= 0, "budget is {} us", budget_us);
  dispatcher_->Run({.time_us = now_us() + budget_us, .until = &predicate});
  return predicate();
}

// Posts `message`, a notification or a ready, with SystemCalls::Post(), which can refuse or delay
// the message.  Called if the faster MessagePoster::PostAtOnce() has not queued the message.
[[gnu::noinline]] int32_t System::PostByCalls(Message* message) {
  return calls_->Post(OwnedMessage(message), 0);
}

void System::Readmit(OwnedMessage message) {
  const Object& target = *object(message->target);
  poster_.Readmit(std::move(message), target);
}

void System::AbandonHandler() { dispatcher_->Abandon(); }

void System::AddFinding(Severity severity, std::string text) {
  AddFindingAbout(t_current.object, severity, std::move(text));
}

void System::AddFindingAbout(const Object* object, Severity severity, std::string text) {
  calls_->AddFinding(object, severity, text);
}

void System::AddFindingAboutRobot(int robot, Severity severity, std::string text, std::string cause,
                                  std::string place) {
  findings_.Add({.severity = severity,
                 .robot = robot,
                 .object = "",
                 .time_us = now_us(),
                 .text = std::move(text),
                 .cause = std::move(cause),
                 .place = std::move(place)});
}

void System::RecordFinding(const Object* object, Severity severity, std::string text) {
  const Object* const current = t_current.object;
  const Message* const running = current == nullptr ? nullptr : current->running();
  Finding finding;
  finding.severity = severity;
  finding.robot = object == nullptr ? 0 : object->robot;
  finding.object = object == nullptr ? "" : object->name;
  finding.message = running == nullptr ? 0 : running->number;
  finding.time_us = now_us();
  finding.text = std::move(text);
  // Describes the message that is being handled, but only if the finding is new.  The description
  // takes time, and some findings are added again in every frame.
  Finding* const added = findings_.Add(std::move(finding));
  if (added != nullptr && running != nullptr && options_.say != nullptr)
    added->said = options_.say(*this, *running);
}

void System::Print(std::string_view text) {
  if (options_.console) {
    options_.console(text);
  } else {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  }
}

uint64_t System::state_hash() {
  Hasher hasher;
  hasher.Add(now_us());
  hasher.Add(poster_.last_number());
  hasher.Add(options_.seed);
  poster_.queue().ForEach([&](const Message& message) {
    uint32_t size = 0;
    const uint64_t payload = PayloadHash(message, &size);
    hasher.Add(message.due_us);
    hasher.Add(message.number);
    hasher.Add(message.target);
    hasher.Add(message.selector);
    hasher.Add(size);
    hasher.Add(payload);
  });
  for (const auto& object : objects()) {
    hasher.AddText(object->name);
    hasher.Add(object->waiting());
    for (const auto& subject : object->subjects()) subject->HashState(&hasher);
    object->HashState(&hasher);
    for (const OwnedMessage& message : object->delivery().held()) hasher.Add(message->number);
    for (const ProcessorState::Outgoing& outgoing : object->processor().outbox())
      // Hashes the number of the message whose handler has posted this message.  This message has
      // no number of its own yet, because it is in an outbox (the processor time of that handler is
      // not over).
      hasher.Add(outgoing.message->cause);
  }
  for (const auto& cpu : dispatcher_->cpus()) cpu->HashState(&hasher);
  inputs_.HashState(&hasher);
  robot_table_.off_robots().HashState(&hasher);
  console_input_.HashState(&hasher);
  time_events_.HashState(&hasher);
  if (options_.cost) options_.cost->HashState(&hasher);
  regions_.HashState(&hasher);
  for (const auto& robot : robot_table_.all()) {
    hasher.Add(robot->powered_off);
    if (robot->boots > 1) hasher.Add(robot->booted_us);
    hasher.Add(robot->stick_hash);
    robot->services->HashState(&hasher);
    if (robot->stick) robot->stick->HashState(&hasher);
  }
  return hasher.Digest();
}

}  // namespace openr_host
