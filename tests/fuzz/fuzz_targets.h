// The fuzz targets: functions that read bytes of others in the way the product does.
//
// A target may throw only the exceptions with which its reader refuses bytes, and it catches them
// itself.  Everything else that leaves it (another exception, a failed assertion, a finding of a
// sanitizer) is a crash.  tests/fuzz/targets.json says what each target reads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Runs one input.  Returns whether the input has reached the planted bug of the target: a value
// that only a reader that has understood most of the input returns.  `./dev fuzz planted` stops at
// such an input, which shows that the fuzzer gets that far.  The seeds do not reach it.
using FuzzFunction = bool (*)(std::string_view bytes);

struct FuzzTarget {
  const char* name;
  FuzzFunction run;
};

// Returns all targets, in the order of their names.
const std::vector<FuzzTarget>& FuzzTargets();

// Returns the target `name`; null if there is none.
const FuzzTarget* FindFuzzTarget(std::string_view name);

// Stops the process with `what`, because something that must hold for every input does not.
[[noreturn]] void FuzzViolation(const std::string& what);

inline void FuzzCheck(bool holds, const char* what) {
  if (!holds) FuzzViolation(what);
}

// A file in memory, for readers that want the name of a file.
class FuzzFile {
 public:
  explicit FuzzFile(std::string_view bytes);
  ~FuzzFile();
  FuzzFile(const FuzzFile&) = delete;
  FuzzFile& operator=(const FuzzFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

// Takes numbers and texts from the front of an input.  After its end all numbers are 0.
class FuzzBytes {
 public:
  explicit FuzzBytes(std::string_view bytes) : rest_(bytes), size_(bytes.size()) {}

  bool empty() const { return rest_.empty(); }
  // Returns how many bytes have been taken.
  size_t taken() const { return size_ - rest_.size(); }
  uint8_t U8();
  uint32_t U32();
  uint64_t U64();
  std::string_view Text(size_t size);

 private:
  std::string_view rest_;
  size_t size_;
};

// Notes that a step of the program that is the input begins at the byte `at`.  Targets whose inputs
// are programs call this for each step, because the fuzzer changes such inputs step by step
// (mutate_steps.h).
void BeginFuzzStep(size_t at);

// Puts the steps of the next inputs behind `*steps`.  Null: steps are not noted, as at first.
void NoteFuzzSteps(std::vector<size_t>* steps);

// Notes a state that the product has reached, such as a command that was accepted or the files that
// are on a stick.  The fuzzer keeps an input that reaches a new state, as it keeps an input that
// reaches a new branch, because readers that work through a table have the same branches for all
// rows of the table.  `state` is a hash; a target must have no more than some hundred states.
void ReachFuzzState(uint64_t state);

// Calls `note` with each state of the next inputs.  Null: states are not noted, as at first.
void NoteFuzzStates(void (*note)(uint64_t state));

}  // namespace openr_host
