// Data races that are planted, and programs without one.  thread_tests.py runs each of them and
// checks that ThreadSanitizer reports the planted races, and nothing else.
//
// usage: planted_races NAME
#include <dds/dds.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "cli/standard_streams.h"
#include "forgetful_answer_queue.h"  // made by CMakeLists.txt: Close() takes no lock
#include "openr/panel/answer_queue.h"
#include "runtime/core/fiber.h"

namespace openr_host {
namespace {

constexpr int kRounds = 1000;
// Each round begins kDepth calls that never return.  ThreadSanitizer has room for 65,536 open
// calls of one stack, so it would crash if it took all of these calls for calls of one stack.
constexpr int kFiberRounds = 5000;
constexpr int kDepth = 20;

// A number that two threads use.  The functions are not inline, so that a report names them.
int g_number = 0;
std::mutex g_mutex;

[[gnu::noinline]] void AddWithoutLock() { ++g_number; }
[[gnu::noinline]] void AddWithLock() {
  const std::lock_guard lock(g_mutex);
  ++g_number;
}

// Calls function(0) in a thread and function(1) in this thread.
template <typename Function>
void RunTwice(const Function& function) {
  std::thread other([function] { function(0); });
  function(1);
  other.join();
}

// Lets no thread be more than one round ahead of the other, so that each run of this program has
// the planted race.  With std::memory_order_relaxed, what one thread did before is not put in order
// with what the other thread does next, so the race stays a race.
void KeepStep(int thread) {
  static std::atomic<int> rounds[2] = {0, 0};
  const int round = rounds[thread].fetch_add(1, std::memory_order_relaxed);
  while (rounds[1 - thread].load(std::memory_order_relaxed) < round) std::this_thread::yield();
}

void CallInTwoThreads(void (*function)()) {
  RunTwice([function](int thread) {
    for (int i = 0; i < kRounds; ++i) {
      KeepStep(thread);
      function();
    }
  });
}

// Two stacks of one thread that take turns, as the dispatcher's fibers do, and a third stack that
// is given up in the middle of its calls, as Dispatcher::Abandon() does.
class Turns {
 public:
  // Calls `function` on one of the fibers.
  explicit Turns(void (*function)()) : function_(function) { steady_.Prepare(&RunSteady, this); }

  void Run(int rounds) {
    for (int i = 0; i < rounds; ++i) {
      abandoned_.Prepare(&RunAbandoned, this);
      abandoned_.SwitchFrom(&home_);
      steady_.SwitchFrom(&home_);
    }
  }

 private:
  static void RunSteady(void* self) {
    for (;;) static_cast<Turns*>(self)->GoHomeFromDepth(kDepth);
  }
  static void RunAbandoned(void* self) { static_cast<Turns*>(self)->GiveUpInDepth(kDepth); }

  // The statement after the recursive call keeps the compiler from making a loop of the recursion.
  [[gnu::noinline]] void GoHomeFromDepth(int depth) {
    if (depth == 0) {
      function_();
      home_.SwitchFrom(&steady_);
    } else {
      GoHomeFromDepth(depth - 1);
    }
    ++returns_;
  }
  [[gnu::noinline]] void GiveUpInDepth(int depth) {
    if (depth == 0) {
      home_.SwitchFrom(nullptr);
    } else {
      GiveUpInDepth(depth - 1);
    }
    ++returns_;
  }

  void (*const function_)();
  MainFiber home_;
  Fiber steady_, abandoned_;
  int returns_ = 0;
};

// Calls `function` on fibers in two threads, each of which has fibers of its own.
void CallOnFibers(void (*function)()) {
  RunTwice([function](int thread) {
    Turns turns(function);
    for (int i = 0; i < kFiberRounds; ++i) {
      KeepStep(thread);
      turns.Run(1);
    }
  });
}

// A number that fibers of one thread use.  The fibers run one after the other, so they need no
// lock.
thread_local int t_number = 0;
void AddInThread() { ++t_number; }

// Goes on in a copy of this process, made by fork(), as checkpoints of a run do (openr/rewind).
void CallOnFibersOfCopy() {
  Turns turns(&AddInThread);
  turns.Run(kRounds);
  const pid_t copy = fork();
  turns.Run(kRounds);
  if (copy == 0) _exit(0);
  int status = -1;
  if (waitpid(copy, &status, 0) != copy || status != 0) std::abort();
}

// Gives an answer for a page in a thread, and closes the queue of the page in another thread.
template <typename AnAnswerQueue>
void CloseAnswerQueue() {
  AnAnswerQueue answers([] {});
  std::thread thread([&answers] { answers.Add("answer"); });
  answers.Close();
  thread.join();
}

// Calls `function` in this thread and in threads of Cyclone DDS, a library without instrumentation:
// its threads call this sink for each line of its trace.
std::atomic<int> g_calls_of_dds = 0;
thread_local bool t_is_ours = false;
void TakeLine(void* function, const dds_log_data_t*) {
  if (t_is_ours) return;
  reinterpret_cast<void (*)()>(function)();
  ++g_calls_of_dds;
}
void CallInDds(void (*function)()) {
  constexpr char kSettings[] =
      "<CycloneDDS><Domain id=\"any\"><General><Interfaces>"
      "<NetworkInterface address=\"127.0.0.1\"/></Interfaces><AllowMulticast>false"
      "</AllowMulticast></General><Tracing><Verbosity>finest</Verbosity></Tracing>"
      "</Domain></CycloneDDS>";
  constexpr dds_domainid_t kDomain = 77;
  constexpr int kCalls = 20;
  t_is_ours = true;
  dds_set_trace_sink(&TakeLine, reinterpret_cast<void*>(function));
  const dds_entity_t domain = dds_create_domain(kDomain, kSettings);
  dds_create_participant(kDomain, nullptr, nullptr);
  while (g_calls_of_dds < kCalls) {
    function();
    usleep(1000);
  }
  dds_delete(domain);
}

// Writes to standard error in two threads.  The lock of the stream is part of the C library, so
// ThreadSanitizer does not see this lock.
void WriteErrors() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0 || dup2(nowhere, STDERR_FILENO) < 0) std::abort();
  PrepareStandardStreams();
  CallInTwoThreads([] { std::fputs("error\n", stderr); });
}

struct Planted {
  std::string_view name;
  void (*run)();
};

constexpr Planted kPlanted[] = {
    {"threads", [] { CallInTwoThreads(&AddWithoutLock); }},
    {"threads-good", [] { CallInTwoThreads(&AddWithLock); }},
    {"fibers", [] { CallOnFibers(&AddWithoutLock); }},
    {"fibers-good", [] { CallOnFibers(&AddInThread); }},
    {"fibers-of-copy-good", &CallOnFibersOfCopy},
    {"dds", [] { CallInDds(&AddWithoutLock); }},
    {"dds-good", [] { CallInDds(&AddWithLock); }},
    {"answers", &CloseAnswerQueue<forgetful::AnswerQueue>},
    {"answers-good", &CloseAnswerQueue<AnswerQueue>},
    {"errors-good", &WriteErrors},
};

}  // namespace
}  // namespace openr_host

int main(int argc, char** argv) {
  for (const auto& planted : openr_host::kPlanted) {
    if (argc != 2 || planted.name != argv[1]) continue;
    planted.run();
    std::puts("done");
    return 0;
  }
  std::fputs("usage: planted_races NAME\n", stderr);
  return 2;
}
