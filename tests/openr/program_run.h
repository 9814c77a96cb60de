// The built program, run by a test, with its two outputs kept apart.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern char** environ;

namespace openr_host {

struct ProgramResult {
  int status = -1;  // exit status; 128 + n after signal n
  std::string out;
  std::string err;
};

class ProgramRun {
 public:
  explicit ProgramRun(const std::vector<std::string>& arguments,
                      const std::string& program = OPENR_PROGRAM) {
    int out[2], err[2];
    if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    posix_spawnattr_t attributes;
    MakeAttributes(&attributes);
    if (posix_spawn(&child_, program.c_str(), &actions, &attributes, argv.data(), environ) != 0) {
      child_ = -1;
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(out[1]);
    close(err[1]);
    out_ = out[0];
    err_ = err[0];
  }
  ~ProgramRun() {
    if (child_ > 0) kill(child_, SIGKILL);
    Finish();
  }
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  // Waits until `text` has been said on standard error, behind `from`; false when the program ended
  // without, or has said other things for kPatienceMs.
  bool WaitFor(const std::string& text, size_t from = 0) {
    return WaitUntil([&] { return result_.err.find(text, from) != std::string::npos; });
  }

  // The same for standard output.
  bool WaitForOutput(const std::string& text) {
    return WaitUntil([&] { return result_.out.find(text) != std::string::npos; });
  }

  // The same for what it has said so far, in whatever way.
  template <typename Condition>
  bool WaitUntil(const Condition& holds) {
    const auto deadline = Clock::now() + std::chrono::milliseconds(kPatienceMs);
    while (!holds()) {
      if (Clock::now() > deadline) Signal(SIGKILL);
      if (!ReadSome()) return false;
    }
    return true;
  }

  // Returns what the program has printed to standard error so far.
  const std::string& heard() const { return result_.err; }
  // Returns what the program has printed to standard output so far.
  const std::string& said() const { return result_.out; }

  pid_t pid() const { return child_; }
  void Signal(int signal) const {
    if (child_ > 0) kill(child_, signal);
  }

  // Waits for the end.
  const ProgramResult& Finish() {
    while (ReadSome()) {
    }
    if (child_ > 0) {
      int status = 0;
      waitpid(child_, &status, 0);
      result_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      child_ = -1;
    }
    return result_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Ctrl-C reaches it, though tests that a shell has put into the background ignore it.
  static void MakeAttributes(posix_spawnattr_t* attributes) {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGHUP);  // nohup ignores it
    posix_spawnattr_init(attributes);
    posix_spawnattr_setsigdefault(attributes, &signals);
    posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF);
  }

  // False when both outputs have ended.
  bool ReadSome() {
    pollfd wanted[2] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
    if (out_ < 0 && err_ < 0) return false;
    if (poll(wanted, 2, kPatienceMs) <= 0) {
      Signal(SIGKILL);
      return false;
    }
    ReadFrom(wanted[0], &out_, &result_.out);
    ReadFrom(wanted[1], &err_, &result_.err);
    return true;
  }

  static void ReadFrom(const pollfd& ready, int* descriptor, std::string* text) {
    if (*descriptor < 0 || ready.revents == 0) return;
    char buffer[4096];
    const ssize_t n = read(*descriptor, buffer, sizeof buffer);
    if (n > 0) {
      text->append(buffer, static_cast<size_t>(n));
    } else {
      close(*descriptor);
      *descriptor = -1;
    }
  }

  // A program that says nothing for this long hangs, and is ended: status 137.
#if defined(__SANITIZE_THREAD__)  // programs run about ten times as long
  static constexpr int kPatienceMs = 600'000;
#else
  static constexpr int kPatienceMs = 120'000;
#endif

  pid_t child_ = -1;
  int out_ = -1, err_ = -1;
  ProgramResult result_;
};

inline ProgramResult RunProgram(const std::vector<std::string>& arguments) {
  return ProgramRun(arguments).Finish();
}

// A folder of the test's own, gone afterwards.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "openr-test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  // Makes the folder `path`, empty; a folder like any other if `path` is "".
  explicit ScratchFolder(const std::filesystem::path& path) : ScratchFolder() {
    if (path.empty()) return;
    std::filesystem::remove_all(path_);
    path_ = path;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path() const { return path_.string(); }
  std::string File(const std::string& name) const { return (path_ / name).string(); }

  void Write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string Read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  // Makes it a stick whose only object is tests/images/Trouble, told to do `word`.
  void MakeTrouble(const std::string& word) const {
    Write("OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TROUBLE.BIN\n");
    Write("OPEN-R/MW/CONF/CONNECT.CFG", "");
    Write("OPEN-R/MW/DATA/P/TROUBLE.TXT", word);
    Write("OPEN-R/MW/OBJS/README.TXT", "");
    for (const char* const file : {"TROUBLE.BIN", "TROUBLE.DBG"}) {
      const std::filesystem::path from = std::filesystem::path(OPENR_IMAGES) / file;
      if (std::filesystem::exists(from))  // images with sanitizers keep their debug information
        std::filesystem::copy_file(from, path_ / "OPEN-R/MW/OBJS" / file);
    }
  }

 private:
  std::filesystem::path path_;
};

}  // namespace openr_host
