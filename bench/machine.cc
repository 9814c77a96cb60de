#include "bench/machine.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <fstream>

namespace openr_host {

std::string ProcessorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string CompilerName() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string CLibraryName() { return fmt::format("glibc {}", gnu_get_libc_version()); }

std::string InstructionSet() {
  utsname names{};
  std::string name = uname(&names) == 0 ? names.machine : "unknown";
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) name += " with AVX2";
#endif
  return name;
}

}  // namespace openr_host
