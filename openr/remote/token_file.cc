#include "openr/remote/token_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace openr::remote {
namespace {

bool IsToken(std::string_view text) {
  return text.size() >= kTokenMin && text.size() <= kTokenMax &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

}  // namespace

std::string ReadTokenFile(const std::string& file) {
  struct stat facts {};
  if (stat(file.c_str(), &facts) != 0)
    throw std::runtime_error(fmt::format("{}: {}", file, std::strerror(errno)));
  if (!S_ISREG(facts.st_mode))
    throw std::runtime_error(fmt::format("{}: is no file, so it has no token", file));
  if (facts.st_uid != geteuid()) {
    throw std::runtime_error(fmt::format(
        "{}: belongs to another user, who knows this token: make a file of your own", file));
  }
  if ((facts.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw std::runtime_error(
        fmt::format("{0}: other users may read this token: chmod 600 {0}", file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: {}", file, std::strerror(errno)));
  std::array<char, kTokenMax + 2> bytes;
  stream.read(bytes.data(), bytes.size());
  const std::string_view text(bytes.data(), static_cast<size_t>(stream.gcount()));
  std::string_view line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (!IsToken(line)) {
    throw std::runtime_error(fmt::format(
        "{}: has no token: its first line must have {} to {} letters, digits, '-' or '_'", file,
        kTokenMin, kTokenMax));
  }
  return std::string(line);
}

}  // namespace openr::remote
