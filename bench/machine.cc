#include "bench/machine.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace openr_host {
namespace {

// Returns the value of `name` for the first processor in /proc/cpuinfo, or "unknown".
std::string ProcessorValue(const std::string& name) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(':');
    if (colon == std::string::npos || colon + 2 > line.size()) continue;
    if (line.substr(0, line.find_last_not_of(" \t", colon - 1) + 1) == name)
      return line.substr(colon + 2);
  }
  return "unknown";
}

std::string WidestVectors() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "avx512f";
  if (__builtin_cpu_supports("avx2")) return "avx2";
  if (__builtin_cpu_supports("avx")) return "avx";
  return "sse2";
#else
  return "unknown";
#endif
}

}  // namespace

Machine DescribeMachine() {
  const char* const commit = std::getenv("OPENR_COMMIT");
  Machine machine;
  machine.processor = ProcessorValue("model name");
  machine.family = ProcessorValue("cpu family");
  machine.model = ProcessorValue("model");
  machine.stepping = ProcessorValue("stepping");
  machine.vectors = WidestVectors();
  machine.processors = std::thread::hardware_concurrency();
  if (getloadavg(&machine.load, 1) != 1) machine.load = -1;
  machine.compiler = CompilerName();
  machine.c_library = CLibraryName();
  machine.commit = commit == nullptr ? "unknown" : commit;
  return machine;
}

std::string TextOf(const Machine& machine) {
  return fmt::format(
      "{} (family {}, model {}, stepping {}), {}, {} processors, load {:.2f}\n{}, {}, commit {}\n",
      machine.processor, machine.family, machine.model, machine.stepping, machine.vectors,
      machine.processors, machine.load, machine.compiler, machine.c_library, machine.commit);
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
