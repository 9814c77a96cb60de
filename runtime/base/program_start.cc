#include "runtime/base/program_start.h"

#include <signal.h>

#include <utility>

#include "runtime/base/assert.h"

extern char** environ;

namespace openr_host {
namespace {

// Returns an array of pointers to `texts` that ends with a null pointer, as posix_spawn() needs it.
std::vector<char*> PointersTo(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

ProgramStart::ProgramStart(std::vector<std::string> words)
    : words_(std::move(words)), arguments_(PointersTo(words_)) {
  ASSERT(!words_.empty());
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  sigaddset(&signals, SIGXFSZ);
  posix_spawn_file_actions_init(&actions_);
  posix_spawnattr_init(&attributes_);
  posix_spawnattr_setsigdefault(&attributes_, &signals);
  posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
}

ProgramStart::~ProgramStart() {
  posix_spawnattr_destroy(&attributes_);
  posix_spawn_file_actions_destroy(&actions_);
}

void ProgramStart::OpenNull(int descriptor, int mode) {
  posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", mode, 0);
}

void ProgramStart::Give(int ours, int theirs) {
  posix_spawn_file_actions_adddup2(&actions_, ours, theirs);
}

void ProgramStart::CloseFrom(int first) {
  posix_spawn_file_actions_addclosefrom_np(&actions_, first);
}

void ProgramStart::EnterFolder(const std::string& folder) {
  posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
}

void ProgramStart::SetEnvironment(std::vector<std::string> environment) {
  environment_ = std::move(environment);
  variables_ = PointersTo(environment_);
}

void ProgramStart::LeaveGroup() {
  posix_spawnattr_setpgroup(&attributes_, 0);
  AddFlag(POSIX_SPAWN_SETPGROUP);
}

void ProgramStart::LeaveSession() { AddFlag(POSIX_SPAWN_SETSID); }

void ProgramStart::UnblockSignals() {
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes_, &none);
  AddFlag(POSIX_SPAWN_SETSIGMASK);
}

int ProgramStart::Start(const std::string& file, pid_t* process) const {
  return posix_spawnp(process, file.c_str(), &actions_, &attributes_, arguments_.data(),
                      variables_.empty() ? environ : variables_.data());
}

void ProgramStart::AddFlag(short flag) {
  short flags = 0;
  posix_spawnattr_getflags(&attributes_, &flags);
  posix_spawnattr_setflags(&attributes_, static_cast<short>(flags | flag));
}

}  // namespace openr_host
