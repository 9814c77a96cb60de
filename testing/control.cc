// Defines pthread_create() and socket(), so that a bench can refuse them to objects.  All calls in
// the program reach these functions, because the linker prefers definitions in a program to
// definitions in libraries.
#include "testing/control.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

#include "runtime/core/current.h"
#include "runtime/core/object.h"
#include "runtime/hooks/hook.h"

namespace openr::testing {
namespace {

thread_local ControlledScope* t_scope = nullptr;
std::atomic<bool> g_thread_was_made = false;

// Returns the number of threads of this process, counted in its folder of /proc.
int ListedThreads() {
  int count = 0;
  std::error_code error;
  for ([[maybe_unused]] const auto& task :
       std::filesystem::directory_iterator("/proc/self/task", error)) {
    ++count;
  }
  return count;
}

}  // namespace

void NoteThread() { g_thread_was_made = true; }

ControlledScope::ControlledScope() : outer_(t_scope) { t_scope = this; }

ControlledScope::~ControlledScope() { t_scope = outer_; }

bool ControlledScope::Refuse(const char* what) {
  if (t_scope == nullptr) return false;
  const openr_host::ApiScope scope;
  const openr_host::Object* const object = openr_host::t_current.object;
  std::string who = "the test";
  if (object != nullptr) who = object->name;
  if (object != nullptr && object->running() != nullptr) {
    who += fmt::format(", in {} (message #{}),", object->EntryName(object->running()->selector),
                       object->running()->number);
  }
  t_scope->refused_.push_back(fmt::format("{} asked for {}", who, what));
  return true;
}

int ThreadCount() {
  if (!g_thread_was_made) return 1;  // no thread was ever made, so only this thread exists
  // Counts the threads again every millisecond, for up to 50 ms, until only this thread is left.
  // One count is not enough, because pthread_join() may return while the kernel still lists the
  // joined thread.
  constexpr int kTries = 50;
  int count = ListedThreads();
  for (int i = 0; i < kTries && count > 1; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    count = ListedThreads();
  }
  return count;
}

}  // namespace openr::testing

using openr::testing::ControlledScope;
using openr_host::NextSymbol;

extern "C" {

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
  static const auto next = NextSymbol<decltype(pthread_create)>("pthread_create");
  if (ControlledScope::Refuse("a thread")) return EAGAIN;
  openr::testing::NoteThread();
  return next(thread, attributes, start, argument);
}

int socket(int domain, int type, int protocol) noexcept {
  static const auto next = NextSymbol<decltype(socket)>("socket");
  if (ControlledScope::Refuse("a socket of the host")) {
    errno = EACCES;
    return -1;
  }
  return next(domain, type, protocol);
}

}  // extern "C"
