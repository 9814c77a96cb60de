#include "kit/kit_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "kit/sdk_paths.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Returns a line of the log file of a build: `words` with tabs between them.  A tab or line end
// inside a word becomes a blank.
std::string Line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += '\t';
    for (const char c : word) line += c == '\t' || c == '\n' ? ' ' : c;
  }
  return line + '\n';
}

void Append(const std::vector<std::string>& words) {
  const char* const file = std::getenv(kLogVariable);
  if (file == nullptr) return;
  const int descriptor = open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return;
  const std::string line = Line(words);
  // Writes the whole line by a single call, because other processes append to the file at the same
  // time, and parts of lines could mix.
  [[maybe_unused]] const ssize_t written = write(descriptor, line.data(), line.size());
  close(descriptor);
}

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == '\t') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

// Returns `words` without the first `n` words.
std::vector<std::string> From(size_t n, const std::vector<std::string>& words) {
  return {words.begin() + static_cast<long>(n), words.end()};
}

// Returns the number of compilations in the log `file`, including those of earlier builds.
uint64_t CountCompiles(const std::string& file) {
  uint64_t count = 0;
  std::istringstream stream(ReadFile(file).value_or(""));
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("compile\t")) ++count;
  return count;
}

std::vector<std::string> ImageWords(const KitLog::Image& image) {
  std::vector<std::string> words{"image", image.file, image.object, image.ocf};
  words.insert(words.end(), image.parts.begin(), image.parts.end());
  return words;
}

std::vector<std::string> CompileWords(const KitLog::Compile& compile) {
  std::vector<std::string> words{"compile", compile.file, compile.folder};
  words.insert(words.end(), compile.flags.begin(), compile.flags.end());
  return words;
}

std::vector<std::string> CommandWords(const KitLog::Command& command) {
  std::vector<std::string> words{"command", command.file, command.folder};
  words.insert(words.end(), command.words.begin(), command.words.end());
  return words;
}

std::string Absolute(const std::string& file) { return fs::absolute(file).lexically_normal(); }

void EraseFailuresOf(const std::string& output, KitLog* log) {
  std::erase_if(log->failures,
                [&](const KitLog::Failure& failure) { return failure.output == output; });
}

}  // namespace

void LogImage(const KitLog::Image& image) {
  KitLog::Image entry{Absolute(image.file), image.object, Absolute(image.ocf), {}};
  for (const std::string& part : image.parts) entry.parts.push_back(Absolute(part));
  Append(ImageWords(entry));
}

void LogFailure(const KitLog::Failure& failure) {
  const std::string& output = failure.output;
  Append({"failure", Absolute(failure.file), failure.why, output.empty() ? "" : Absolute(output)});
}

void LogCompile(const KitLog::Compile& compile) {
  Append(CompileWords({Absolute(compile.file), Absolute(compile.folder), compile.flags}));
}

void LogCommand(const KitLog::Command& command) {
  Append(CommandWords({Absolute(command.file), Absolute(command.folder), command.words}));
}

void LogSuccess(const std::string& output) { Append({"made", Absolute(output)}); }

void LogRepair(const KitLog::Repair& repair) { Append({"repair", repair.place, repair.what}); }

KitLog ReadKitLog(const std::string& file) {
  KitLog log;
  std::istringstream stream(ReadFile(file).value_or(""));
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = Split(line);
    if (words.size() >= 4 && words[0] == "image") {
      // Keeps only the last record of each file, because a file may be made more than once in a
      // build.
      std::erase_if(log.images, [&](const KitLog::Image& other) { return other.file == words[1]; });
      log.images.push_back({words[1], words[2], words[3], From(4, words)});
      EraseFailuresOf(words[1], &log);
    } else if (words.size() == 4 && words[0] == "failure") {
      std::erase_if(log.failures, [&](const KitLog::Failure& other) {
        return other.file == words[1] && other.why == words[2] && other.output == words[3];
      });
      log.failures.push_back({words[1], words[2], words[3]});
    } else if (words.size() >= 3 && words[0] == "compile") {
      std::erase_if(log.compiles, [&](const KitLog::Compile& other) {
        return other.file == words[1] && other.folder == words[2];
      });
      log.compiles.push_back({words[1], words[2], From(3, words)});
    } else if (words.size() >= 3 && words[0] == "command") {
      std::erase_if(log.commands, [&](const KitLog::Command& other) {
        return other.file == words[1] && other.folder == words[2];
      });
      log.commands.push_back({words[1], words[2], From(3, words)});
    } else if (words.size() == 2 && words[0] == "made") {
      EraseFailuresOf(words[1], &log);
    } else if (words.size() == 3 && words[0] == "repair") {
      log.repairs.push_back({words[1], words[2]});
    }
  }
  return log;
}

uint64_t CompileCounter::CountIn(const std::string& file) {
  const uint64_t count = CountCompiles(file);
  Lines& lines = logs_.try_emplace(file, Lines{count, 0}).first->second;
  // Keeps the largest number of compilations that the log has had, because the number shrinks when
  // CleanKitLog() removes repeated compilations from the log.
  if (count > lines.before) lines.now = std::max(lines.now, count - lines.before);
  uint64_t all = 0;
  for (const auto& [name, each] : logs_) all += each.now;
  return all;
}

void AppendKitLog(const std::string& file, const KitLog& log) {
  std::ofstream stream(file, std::ios::app);
  for (const KitLog::Image& image : log.images) stream << Line(ImageWords(image));
  for (const KitLog::Compile& compile : log.compiles) stream << Line(CompileWords(compile));
  for (const KitLog::Command& command : log.commands) stream << Line(CommandWords(command));
  for (const KitLog::Failure& failure : log.failures)
    stream << Line({"failure", failure.file, failure.why, failure.output});
  for (const KitLog::Repair& repair : log.repairs)
    stream << Line({"repair", repair.place, repair.what});
}

void WriteKitLog(const std::string& file, const KitLog& log) {
  std::ofstream(file, std::ios::trunc);
  AppendKitLog(file, log);
}

void CleanKitLog(const std::string& file) {
  KitLog log = ReadKitLog(file);
  std::erase_if(log.images, [](const KitLog::Image& image) { return !fs::exists(image.file); });
  log.failures.clear();
  log.repairs.clear();
  WriteKitLog(file, log);
}

}  // namespace openr_host
