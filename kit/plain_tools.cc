// Tools of the SDK that do little or nothing on the host.
#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/sdk_tools.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

int Fail(const char* tool, const std::string& file) {
  PrintPlain(stderr, "{}: {}: {}\n", tool, file, std::strerror(errno));
  return 1;
}

// Prints `problem` as an error of `tool`, unless it is "".  Returns the exit code of the tool.
int Check(const char* tool, const std::string& problem) {
  if (problem.empty()) return 0;
  PrintPlain(stderr, "{}: {}\n", tool, problem);
  return 1;
}

// Returns `bytes` compressed, in the file format of gzip.
std::string Gzipped(std::string bytes) {
  // Number to add to the size of zlib's window, so that zlib writes the file format of gzip.
  constexpr int kGzipFormat = 16;
  z_stream stream{};
  // Compresses with level 6, as gzip -6 does, because the robot is known to read such images
  // (field-notes.md 5.8).
  if (deflateInit2(&stream, 6, Z_DEFLATED, kGzipFormat + MAX_WBITS, MAX_MEM_LEVEL - 1,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// Returns the path for a copy of the file `from`: `to`, or if `to` is a folder, a file of the same
// name in this folder.
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
  const std::optional<std::string> bytes = ReadFile(files[0]);
  if (!bytes) return Fail("gzcp", files[0]);
  const std::string to = Target(files[0], files[1]);
  return Check("gzcp", WriteFile(to, Gzipped(*bytes)));
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
  if (output.empty() || files.size() != 1) return 0;
  return Check("strip", CopyToFile(files[0], output));
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
  if (!result.start_error.empty()) PrintPlain(stderr, "{}\n", result.start_error);
  return result.status;
}

}  // namespace openr_host
