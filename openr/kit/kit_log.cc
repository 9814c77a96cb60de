#include "openr/kit/kit_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "openr/kit/sdk_paths.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Words of a line are separated by tabs; what has one inside is shown with a blank.
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

std::string Absolute(const std::string& file) { return fs::absolute(file).lexically_normal(); }

}  // namespace

void LogImage(const KitLog::Image& image) {
  Append({"image", Absolute(image.file), image.object, Absolute(image.ocf)});
}

void LogFailure(const KitLog::Failure& failure) {
  Append({"failure", Absolute(failure.file), failure.why});
}

void LogRepair(const KitLog::Repair& repair) { Append({"repair", repair.place, repair.what}); }

KitLog ReadKitLog(const std::string& file) {
  KitLog log;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = Split(line);
    if (words.size() == 4 && words[0] == "image") {
      std::erase_if(log.images, [&](const KitLog::Image& other) { return other.file == words[1]; });
      log.images.push_back({words[1], words[2], words[3]});
    } else if (words.size() == 3 && words[0] == "failure") {
      log.failures.push_back({words[1], words[2]});
    } else if (words.size() == 3 && words[0] == "repair") {
      log.repairs.push_back({words[1], words[2]});
    }
  }
  return log;
}

void AppendKitLog(const std::string& file, const KitLog& log) {
  std::ofstream stream(file, std::ios::app);
  for (const KitLog::Image& image : log.images)
    stream << Line({"image", image.file, image.object, image.ocf});
  for (const KitLog::Failure& failure : log.failures)
    stream << Line({"failure", failure.file, failure.why});
  for (const KitLog::Repair& repair : log.repairs)
    stream << Line({"repair", repair.place, repair.what});
}

void CleanKitLog(const std::string& file) {
  KitLog log = ReadKitLog(file);
  std::erase_if(log.images, [](const KitLog::Image& image) { return !fs::exists(image.file); });
  log.failures.clear();
  log.repairs.clear();
  std::ofstream(file, std::ios::trunc);
  AppendKitLog(file, log);
}

}  // namespace openr_host
