#include "openr/simulation/sanitizer_start.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/install_paths.h"
#include "cli/process_arguments.h"
#include "runtime/core/image_file.h"
#include "runtime/core/memory_tools.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Name of the environment variable that is set when openr starts a second time
// (StartWithSanitizerOf()).  If the library of AddressSanitizer is still not loaded then, openr
// ends with an error instead of starting a third time.
constexpr char kStartedVariable[] = "OPENR_SANITIZER";

// Settings of AddressSanitizer.  AddressSanitizer must not handle the signals of crashes, because
// the run handles them itself.  It must not report memory that an object keeps until the end,
// because this memory is freed with the object.  It must not report that memory from new is freed
// with free(), or memory from malloc() with delete, because some functions of the SDK mix the two.
constexpr char kSettings[] =
    "detect_leaks=0:handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:"
    "alloc_dealloc_mismatch=0:allocator_may_return_null=1";

// Returns the path of the AddressSanitizer library that an image on the stick needs; "" if no image
// needs it.  Skips folders that cannot be read, because the run itself reports such folders when it
// loads the stick.
std::string SanitizerOfStick(const std::string& stick) {
  std::error_code error;
  constexpr auto kSkip = fs::directory_options::skip_permission_denied;
  fs::recursive_directory_iterator at(fs::path(stick), kSkip, error);
  for (; at != fs::recursive_directory_iterator(); at.increment(error)) {
    std::string extension = at->path().extension();
    for (char& c : extension) c = static_cast<char>(std::toupper(c));
    if (extension != ".BIN") continue;
    const std::string library = SanitizerOf(ReadImageFile(at->path()).bytes);
    if (!library.empty()) return library;
  }
  return "";
}

void Prepend(const char* name, const std::string& text, char separator) {
  const char* const before = std::getenv(name);
  setenv(name, (before == nullptr ? text : text + separator + before).c_str(), 1);
}

}  // namespace

std::string MissingSanitizer(const std::string& stick) {
  return stick.empty() || IsAddressSanitized() ? "" : SanitizerOfStick(stick);
}

void StartWithSanitizerOf(const std::string& stick) {
  const std::string library = MissingSanitizer(stick);
  if (library.empty()) return;
  if (std::getenv(kStartedVariable) != nullptr) {
    throw std::runtime_error(fmt::format(
        "{}: its objects were built with --sanitize, and {} cannot be loaded; install the package "
        "libasan8, or build them without --sanitize",
        stick, library));
  }
  setenv(kStartedVariable, library.c_str(), 1);
  Prepend("LD_PRELOAD", library, ':');
  Prepend("ASAN_OPTIONS", kSettings, ':');
  std::vector<std::string> arguments = ProcessArguments();
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  execv(ProgramFile().c_str(), words.data());
  throw std::runtime_error(fmt::format("{} cannot be started again with {}: {}", ProgramFile(),
                                       library, std::strerror(errno)));
}

}  // namespace openr_host
