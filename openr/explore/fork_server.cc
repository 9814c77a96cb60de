#include "openr/explore/fork_server.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/process_copy.h"
#include "openr/ending/end_guards.h"
#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

enum class ReadEnd { kClosed, kTimeLimit, kError };

// Appends all data from `descriptor` to `text`, until the other end of `descriptor` is closed
// (kClosed) or no data come for `wall_s` seconds (kTimeLimit).  After an error of the system
// (kError), errno has its number.
ReadEnd ReadAll(int descriptor, int wall_s, std::string* text) {
  for (;;) {
    pollfd wanted = {descriptor, POLLIN, 0};
    const int ready = poll(&wanted, 1, wall_s * 1000);
    if (ready < 0 && errno == EINTR) continue;
    if (ready < 0) return ReadEnd::kError;
    if (ready == 0) return ReadEnd::kTimeLimit;
    char buffer[65536];
    const ssize_t size = read(descriptor, buffer, sizeof buffer);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return ReadEnd::kError;
    if (size == 0) return ReadEnd::kClosed;
    text->append(buffer, static_cast<size_t>(size));
  }
}

}  // namespace

ForkServer::ForkServer(PreparedRun prepared, RunOptions options, ForkLimits limits)
    : prepared_(std::move(prepared)), options_(std::move(options)), limits_(limits) {
  ASSERT(prepared_.system != nullptr && !prepared_.system->booted());
  void* const memory = mmap(nullptr, sizeof(DeviationLog), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory for the log of deviations");
  log_ = static_cast<DeviationLog*>(memory);
}

ForkServer::~ForkServer() { munmap(log_, sizeof(DeviationLog)); }

Json ForkServer::Broken(const Json& plan, const char* property, const std::string& text) {
  Json deviations = Json::array();
  for (uint64_t i = 0; i < log_->count; ++i) {
    deviations.push_back(DeviationToJson(log_->entries[i], *prepared_.system));
  }
  const bool hangs = std::string_view(property) == kHandlersReturn;
  return {{"seed", plan.at("seed")},
          {"ended_by", EndName(hangs ? EndKind::kHandlerLimit : EndKind::kCrash)},
          {"broken",
           {{"property", property}, {"time_us", nullptr}, {"message", nullptr}, {"text", text}}},
          {"deviations", std::move(deviations)}};
}

// Returns the answer (the JSON that describes the result of a run) for a copy of the process that
// ended early, for example by a crash.  `said` is the text that the copy has written.  Normally
// `said` is the answer, which the copy writes while it ends.  If `said` is only an error
// (EndGuards), the answer is made from this error.  If `said` is "", the answer is made from
// `status`, the exit status of the copy.
Json ForkServer::AnswerOfEndedCopy(const Json& plan, const std::string& said, int status) {
  const Json json = TryParseJson<Json>(said);
  if (json.is_object() && json.contains("broken")) return json;
  if (json.is_object() && json.contains("error")) {
    return Broken(plan, PropertyOfEnding(json.value("ended_by", "")),
                  json["error"].get<std::string>());
  }
  return Broken(plan, kNoCrash,
                WIFSIGNALED(status)
                    ? fmt::format("the process ended with signal {} ({})", WTERMSIG(status),
                                  strsignal(WTERMSIG(status)))
                    : fmt::format("the process ended with status {} before the end of the run",
                                  WEXITSTATUS(status)));
}

void ForkServer::RunInCopy(const Json& plan, int answer) {
  const EndGuards guards({.answer = answer, .handler_limit_us = limits_.handler_us});
  Json result;
  try {
    result = RunPlan(&prepared_, plan, options_, log_,
                     [answer](const Json& last) { WriteAll(answer, JsonText(last)); });
  } catch (const std::exception& error) {
    result = {{"problem", error.what()}};
  }
  WriteAll(answer, JsonText(result));
  EndCopy();  // ends without destructors of objects, which would only cost time
}

Json ForkServer::Run(const Json& plan) {
  // Each copy boots the system, which can be booted only once.
  ASSERT(!prepared_.system->booted());
  log_->count = 0;
  const ProcessCopy copy = StartCopy(Orphan::kGoesOn, [&](int answer) { RunInCopy(plan, answer); });
  std::string said;
  const ReadEnd end = ReadAll(copy.answers, limits_.wall_s, &said);
  const int error = errno;
  close(copy.answers);
  if (end != ReadEnd::kClosed) kill(copy.pid, SIGKILL);
  const int status = WaitForEnd(copy.pid);
  // Throws and returns no answer, because an answer would report a fault of the explored program,
  // and that program has not caused this error.
  if (end == ReadEnd::kError)
    throw std::runtime_error(
        fmt::format("cannot read the result of a run: {}", std::strerror(error)));
  if (end == ReadEnd::kTimeLimit) {
    Json answer =
        Broken(plan, kHandlersReturn,
               fmt::format("the run did not end within {} s of real time", limits_.wall_s));
    answer[kNotEnded] = true;
    return answer;
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return AnswerOfEndedCopy(plan, said, status);
  // A copy may end with status 0 and without an answer, if its program makes a system call that
  // ends the process.
  const Json answer = TryParseJson<Json>(said);
  return answer.is_object() ? answer : AnswerOfEndedCopy(plan, said, status);
}

}  // namespace openr_host
