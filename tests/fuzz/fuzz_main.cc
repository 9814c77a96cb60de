// The program of all fuzz targets, for clang's libFuzzer: openr_fuzz TARGET [--planted] [ARGS].
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutate.h"

// Functions of libFuzzer, which has no header for them.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t size_max);

namespace {

const openr_host::FuzzTarget* target = nullptr;
bool stops_at_planted_bug = false;

// Removes the first argument behind the name of the program, because libFuzzer does not know it.
void TakeArgument(int* argc, char** argv) {
  std::memmove(argv + 1, argv + 2, sizeof *argv * static_cast<size_t>(*argc - 1));
  *argc -= 1;
}

bool IsTarget(const char* name) { return std::strcmp(target->name, name) == 0; }

// Copies `bytes` to `data`, without those that do not fit.  Returns how many were copied.
size_t Put(const std::string& bytes, uint8_t* data, size_t size_max) {
  const size_t size = std::min(bytes.size(), size_max);
  std::memcpy(data, bytes.data(), size);
  return size;
}

std::string MutateBytes(std::string bytes, size_t size_max, openr_host::FuzzRandom* random) {
  const bool is_text = openr_host::IsText(bytes);
  if (!is_text && (*random)() % 3 == 0) return openr_host::MutateNumber(bytes, random);
  if ((*random)() % (is_text ? 2 : 16) == 0) return openr_host::MutateText(bytes, random);
  const size_t size = bytes.size();
  bytes.resize(std::max(size, size_max));
  bytes.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(bytes.data()), size, bytes.size()));
  return bytes;
}

}  // namespace

// Changes an input.  The content of a compressed image is changed as well as its compressed bytes;
// a recording gets the right checksums, because its reader says little about blocks with others.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t size_max,
                                          unsigned int seed) {
  openr_host::FuzzRandom random(seed + 1);
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (IsTarget("image") && random() % 4 != 0) {
    const std::string content = openr_host::Decompress(bytes);
    if (!content.empty()) {
      const std::string changed = MutateBytes(content, content.size() + 64, &random);
      const std::string packed = openr_host::Compress(changed);
      if (packed.size() <= size_max) return Put(packed, data, size_max);
    }
  }
  std::string changed = MutateBytes(bytes, size_max, &random);
  if (IsTarget("recording")) openr_host::FixRecording(&changed);
  return Put(changed, data, size_max);
}

// Makes an input of two others.  Does so once in a while, because inputs would only grow; the
// result 0 makes libFuzzer choose another change.
extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t* first, size_t first_size,
                                            const uint8_t* second, size_t second_size, uint8_t* out,
                                            size_t size_max, unsigned int seed) {
  openr_host::FuzzRandom random(seed + 1);
  if (random() % 8 != 0) return 0;
  return Put(openr_host::JoinTexts({reinterpret_cast<const char*>(first), first_size},
                                   {reinterpret_cast<const char*>(second), second_size}, &random),
             out, size_max);
}

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc > 1) target = openr_host::FindFuzzTarget((*argv)[1]);
  if (target == nullptr) {
    std::fprintf(stderr, "usage: openr_fuzz TARGET [--planted] [ARGS of libFuzzer]\n");
    for (const openr_host::FuzzTarget& known : openr_host::FuzzTargets()) {
      std::fprintf(stderr, "  %s\n", known.name);
    }
    std::exit(2);
  }
  TakeArgument(argc, *argv);
  if (*argc > 1 && std::strcmp((*argv)[1], "--planted") == 0) {
    stops_at_planted_bug = true;
    TakeArgument(argc, *argv);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const bool has_reached = target->run({reinterpret_cast<const char*>(data), size});
  if (has_reached && stops_at_planted_bug) openr_host::FuzzViolation("the planted bug");
  return 0;
}
