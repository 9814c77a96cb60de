// Tools of the SDK that do little or nothing on the host.
#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "openr/kit/process.h"
#include "openr/kit/sdk_tools.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

int Fail(const char* tool, const std::string& file) {
  std::fprintf(stderr, "%s: %s: %s\n", tool, file.c_str(), std::strerror(errno));
  return 1;
}

// Where FROM is to go when TO may be a folder.
fs::path Target(const fs::path& from, const fs::path& to) {
  std::error_code error;
  return fs::is_directory(to, error) ? to / from.filename() : to;
}

}  // namespace

int RunGzcp(const Arguments& arguments) {
  Arguments files;
  for (const std::string& word : arguments) {
    if (word[0] != '-') files.push_back(word);
  }
  if (files.size() != 2) {
    std::fputs("usage: gzcp FROM TO\n", stderr);
    return 2;
  }
  errno = 0;
  std::ifstream in(files[0], std::ios::binary);
  if (!in) return Fail("gzcp", files[0]);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::string to = Target(files[0], files[1]);
  const gzFile out = gzopen(to.c_str(), "wb6");
  if (out == nullptr) return Fail("gzcp", to);
  const bool written =
      bytes.empty() || gzwrite(out, bytes.data(), static_cast<unsigned>(bytes.size())) ==
                           static_cast<int>(bytes.size());
  return gzclose(out) == Z_OK && written ? 0 : Fail("gzcp", to);
}

int RunStrip(const Arguments& arguments) {
  Arguments files;
  std::string output;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const bool takes_value = word == "-o" || word == "-F" || word == "-R" || word == "-K" ||
                             word == "-N" || word == "-I" || word == "-O";
    if (takes_value && i + 1 < arguments.size()) {
      if (word == "-o") output = arguments[i + 1];
      ++i;
    } else if (word[0] != '-') {
      files.push_back(word);
    }
  }
  std::error_code error;
  for (const std::string& file : files) {
    if (!fs::exists(file, error)) {
      errno = ENOENT;
      return Fail("strip", file);
    }
  }
  if (!output.empty() && files.size() == 1 &&
      !fs::copy_file(files[0], output, fs::copy_options::overwrite_existing, error)) {
    errno = error.value();
    return Fail("strip", output);
  }
  return 0;
}

int RunHostTool(const std::string& tool, const Arguments& arguments) {
  Arguments all{tool};
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const bool is_processor = word == "-EL" || word == "-EB" || word.starts_with("-mips") ||
                              word == "-KPIC" || word == "-non_shared" || word == "-G0";
    const bool is_processor_pair = word == "-G" || (word == "-m" && tool == "ld");
    if (is_processor_pair) ++i;
    if (!is_processor && !is_processor_pair) all.push_back(word);
  }
  const ProcessResult result = RunProcess(all);
  if (!result.not_found.empty()) std::fprintf(stderr, "%s\n", result.not_found.c_str());
  return result.status;
}

}  // namespace openr_host
