#include "tests/fuzz/fuzz_targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

std::vector<size_t>* noted_steps = nullptr;
void (*note_state)(uint64_t state) = nullptr;

}  // namespace

const std::vector<FuzzTarget>& FuzzTargets() {
  static const std::vector<FuzzTarget> targets = {
#define OPENR_FUZZ_ENTRY(name) {#name, fuzz::name},
      OPENR_FUZZ_TARGETS(OPENR_FUZZ_ENTRY)
#undef OPENR_FUZZ_ENTRY
  };
  return targets;
}

const FuzzTarget* FindFuzzTarget(std::string_view name) {
  for (const FuzzTarget& target : FuzzTargets()) {
    if (target.name == name) return &target;
  }
  return nullptr;
}

void FuzzViolation(const std::string& what) {
  std::fprintf(stderr, "openr_fuzz: %s\n", what.c_str());
  std::abort();
}

FuzzFile::FuzzFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", 0)) {
  if (descriptor_ < 0 ||
      write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("no file in memory");
  }
  path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

FuzzFile::~FuzzFile() { close(descriptor_); }

std::string_view FuzzBytes::Text(size_t size) {
  const std::string_view text = rest_.substr(0, size);
  rest_.remove_prefix(text.size());
  return text;
}

uint8_t FuzzBytes::U8() {
  const std::string_view byte = Text(1);
  return byte.empty() ? 0 : static_cast<uint8_t>(byte[0]);
}

uint32_t FuzzBytes::U32() {
  uint32_t value = 0;
  const std::string_view bytes = Text(sizeof value);
  std::memcpy(&value, bytes.data(), bytes.size());
  return value;
}

uint64_t FuzzBytes::U64() {
  uint64_t value = 0;
  const std::string_view bytes = Text(sizeof value);
  std::memcpy(&value, bytes.data(), bytes.size());
  return value;
}

void BeginFuzzStep(size_t at) {
  if (noted_steps != nullptr) noted_steps->push_back(at);
}

void NoteFuzzSteps(std::vector<size_t>* steps) { noted_steps = steps; }

void ReachFuzzState(uint64_t state) {
  if (note_state != nullptr) note_state(state);
}

void NoteFuzzStates(void (*note)(uint64_t state)) { note_state = note; }

}  // namespace openr_host
