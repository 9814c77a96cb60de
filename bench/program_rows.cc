// Rows that start the program openr: the start of a run, and many robots with one and two workers.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "cli/install_paths.h"
#include "runtime/base/program_start.h"

namespace openr_host {
namespace {

// Starts `openr run --stick STICK` with the further words `words`.  Returns its process id.
pid_t StartOpenr(const std::string& stick, const std::vector<std::string>& words) {
  std::vector<std::string> all = {ProgramFolder() + "/openr", "run", "--stick", stick};
  all.insert(all.end(), words.begin(), words.end());
  ProgramStart start(std::move(all));
  start.OpenNull(STDOUT_FILENO, O_WRONLY);
  start.OpenNull(STDERR_FILENO, O_WRONLY);
  pid_t child = -1;
  if (start.Start(&child) != 0) throw std::runtime_error("bench: openr cannot be started");
  return child;
}

// Waits for the end of a process of StartOpenr().
void AwaitOpenr(pid_t child) {
  int status = -1;
  waitpid(child, &status, 0);
  if (status != 0) throw std::runtime_error("bench: openr run has failed");
}

void RunOpenr(const std::string& stick, const std::vector<std::string>& words) {
  AwaitOpenr(StartOpenr(stick, words));
}

// Returns a variant that runs `openr run` with `words`.
Variant RunOf(const std::string& name, const std::string& stick,
              const std::vector<std::string>& words, std::vector<Limit> limits) {
  return {name,
          [stick, words](int64_t count) {
            for (; count > 0; --count) RunOpenr(stick, words);
          },
          std::move(limits)};
}

Row StartRow(const std::string& stick) {
  Row row{"process start to all objects started, and end", "ns a start", 1};
  row.rounds = 15;
  row.variants = {
      RunOf("openr run --for 8ms", stick,
            {"--for", "8ms", "--rate", "max", "--no-panel", "--body", "ideal", "--rc-port", "0"},
            {{Limit::Kind::kTime, 15e6}})};
  return row;
}

// Returns the words of `openr run` for `robots` robots with `body` for 20 s, followed by `more`.
std::vector<std::string> WordsFor(int robots, const std::string& body,
                                  const std::vector<std::string>& more) {
  std::vector<std::string> words = {
      "--robots",  std::to_string(robots), "--for", "20s", "--rate", "max", "--body", body,
      "--no-panel"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Returns a row that compares one worker with two, which are processes.  Its last two variants are
// two runs that know nothing of each other.  Their ratio shows what the second processor of this
// machine is worth: less than 2 if both processors share parts, as two threads of a core do.
Row WorkersRow(const std::string& stick, const std::string& body) {
  Row row{fmt::format("100 robots for 20 s, {} body; a run", body), "ns a run", 1};
  row.rounds = 5;
  row.warm_up = 0;
  if (std::thread::hardware_concurrency() < 2) {
    row.note = "not measured: one processor";
    return row;
  }
  const auto run = [&](const std::string& jobs, std::vector<Limit> limits) {
    return RunOf("--jobs " + jobs, stick, WordsFor(100, body, {"--jobs", jobs}), std::move(limits));
  };
  const auto half = [stick, words = WordsFor(50, body, {"--rc-port", "0"})] {
    return StartOpenr(stick, words);
  };
  row.variants = {run("2", {}),
                  run("1", {{Limit::Kind::kRatioAtLeast, 1.8}}),
                  {"two runs of 50, at once",
                   [half](int64_t count) {
                     for (; count > 0; --count) {
                       const pid_t first = half(), second = half();
                       AwaitOpenr(first);
                       AwaitOpenr(second);
                     }
                   }},
                  {"two runs of 50, one by one", [half](int64_t count) {
                     for (; count > 0; --count) {
                       AwaitOpenr(half());
                       AwaitOpenr(half());
                     }
                   }}};
  return row;
}

}  // namespace

std::vector<Row> ProgramRows(const std::string& stick) {
  return {StartRow(stick), WorkersRow(stick, "ideal"), WorkersRow(stick, "ode")};
}

}  // namespace openr_host
