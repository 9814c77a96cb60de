// The program of all fuzz targets, for clang's libFuzzer: openr_fuzz TARGET [--words FILE]
// [--seeds FILE] [--planted] [ARGS].  The files have a word, or the path of a seed, in each line.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "runtime/base/hasher.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/mutate_json.h"
#include "tests/fuzz/mutate_steps.h"

// Functions of libFuzzer, which has no header for them.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t size_max);

// Counters that libFuzzer reads like those of branches, because they are in this section.
__attribute__((section("__libfuzzer_extra_counters"))) static uint8_t reached_states[4096];

namespace {

const openr_host::FuzzTarget* target = nullptr;
bool stops_at_planted_bug = false;
openr_host::FuzzWords words;     // the dictionary of the target
std::vector<std::string> seeds;  // inputs with which the target begins; most of them are valid
bool has_steps = false;          // the inputs of the target are programs (BeginFuzzStep())
std::unordered_map<uint64_t, openr_host::FuzzStarts> known_steps;  // by the hash of the program

// Removes the first argument behind the name of the program, because libFuzzer does not know it.
void TakeArgument(int* argc, char** argv) {
  std::memmove(argv + 1, argv + 2, sizeof *argv * static_cast<size_t>(*argc - 1));
  *argc -= 1;
}

// Removes the first two arguments, `flag` and the name of a file, and returns the lines of the
// file. Returns nothing if the first argument is not `flag`.
std::vector<std::string> TakeLines(const char* flag, int* argc, char** argv) {
  std::vector<std::string> lines;
  if (*argc <= 2 || std::strcmp(argv[1], flag) != 0) return lines;
  std::ifstream file(argv[2]);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  TakeArgument(argc, argv);
  TakeArgument(argc, argv);
  return lines;
}

bool IsJsonBegin(std::string_view text) { return text.starts_with('{') || text.starts_with('['); }

bool IsTarget(const char* name) { return std::strcmp(target->name, name) == 0; }

// Copies `bytes` to `data`, without those that do not fit.  Returns how many were copied.
size_t Put(const std::string& bytes, uint8_t* data, size_t size_max) {
  const size_t size = std::min(bytes.size(), size_max);
  std::memcpy(data, bytes.data(), size);
  return size;
}

openr_host::FuzzStarts Run(const std::string& bytes) {
  openr_host::FuzzStarts starts;
  openr_host::NoteFuzzSteps(&starts);
  const bool has_reached = target->run(bytes);
  openr_host::NoteFuzzSteps(nullptr);
  if (has_reached && stops_at_planted_bug) openr_host::FuzzViolation("the planted bug");
  if (starts.empty()) return starts;
  constexpr size_t kKnownMax = 20'000;
  if (known_steps.size() >= kKnownMax) known_steps.clear();
  has_steps = true;
  known_steps[openr_host::HashBytes(bytes.data(), bytes.size())] = starts;
  return starts;
}

// Returns where the steps of `bytes` begin.  Runs the target if that is not known.
openr_host::FuzzStarts StartsOf(const std::string& bytes) {
  if (!has_steps) return {};
  const auto known = known_steps.find(openr_host::HashBytes(bytes.data(), bytes.size()));
  return known != known_steps.end() ? known->second : Run(bytes);
}

// Makes one of libFuzzer's own changes.  The input grows by a few bytes at most, because an input
// with a large piece of nonsense is hardly ever valid.
std::string MutateAnyhow(std::string bytes, size_t size_max) {
  constexpr size_t kGrowth = 32;
  const size_t size = bytes.size();
  bytes.resize(std::max(size, std::min(size_max, size + kGrowth)));
  bytes.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(bytes.data()), size, bytes.size()));
  return bytes;
}

// Makes a change that knows nothing of JSON or steps.
std::string MutateTextOrBytes(const std::string& bytes, size_t size_max,
                              openr_host::FuzzRandom* random) {
  const bool is_text = openr_host::IsText(bytes);
  if (!is_text && (*random)() % 3 == 0) return openr_host::MutateNumber(bytes, random);
  if (!is_text && (*random)() % 4 == 0) return openr_host::MutateTextIn(bytes, words, random);
  if (is_text ? (*random)() % 3 != 0 : (*random)() % 16 == 0) {
    return openr_host::MutateText(bytes, words, random);
  }
  return MutateAnyhow(bytes, size_max);
}

std::string MutateBytes(const std::string& bytes, size_t size_max, openr_host::FuzzRandom* random) {
  if (IsTarget("panel_websocket") && (*random)() % 2 == 0) {
    return openr_host::MutateParts(bytes, words, random);
  }
  if (has_steps && (*random)() % 4 != 0) {
    return openr_host::MutateSteps(bytes, StartsOf(bytes), random);
  }
  if (!IsJsonBegin(bytes)) return MutateTextOrBytes(bytes, size_max, random);
  if ((*random)() % 4 == 0) {
    const std::string changed = MutateTextOrBytes(bytes, size_max, random);
    if (openr_host::IsJson(changed) || (*random)() % 8 == 0) return changed;
  }
  const std::string changed = openr_host::MutateJson(bytes, words, random);
  return changed.empty() ? MutateTextOrBytes(bytes, size_max, random) : changed;
}

}  // namespace

// Changes an input.  The content of a compressed image is changed as well as its compressed bytes;
// a recording gets the right checksums, because its reader says little about blocks with others.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t size_max,
                                          unsigned int seed) {
  openr_host::FuzzRandom random(seed + 1);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  // Changes a seed in place of an input with JSON once in a while.  libFuzzer keeps each input that
  // is refused in a new way, and soon hardly chooses valid JSON.
  if (IsJsonBegin(bytes) && !seeds.empty() && random() % 8 == 0)
    bytes = seeds[random() % seeds.size()];
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
// result 0 makes libFuzzer choose another change.  If inputs are programs, the second is a seed in
// a third of the cases, because few other programs finish what they begin, such as a transfer.
extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t* first, size_t first_size,
                                            const uint8_t* second, size_t second_size, uint8_t* out,
                                            size_t size_max, unsigned int seed) {
  openr_host::FuzzRandom random(seed + 1);
  if (random() % (has_steps ? 4 : 8) != 0) return 0;
  const std::string one(reinterpret_cast<const char*>(first), first_size);
  std::string other(reinterpret_cast<const char*>(second), second_size);
  if (has_steps && !seeds.empty() && random() % 3 == 0) other = seeds[random() % seeds.size()];
  return Put(has_steps ? openr_host::JoinSteps(one, StartsOf(one), other, StartsOf(other), &random)
                       : openr_host::JoinTexts(one, other, &random),
             out, size_max);
}

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc > 1) target = openr_host::FindFuzzTarget((*argv)[1]);
  if (target == nullptr) {
    std::fprintf(stderr,
                 "usage: openr_fuzz TARGET [--words FILE] [--seeds FILE] [--planted] [ARGS of "
                 "libFuzzer]\n");
    for (const openr_host::FuzzTarget& known : openr_host::FuzzTargets()) {
      std::fprintf(stderr, "  %s\n", known.name);
    }
    std::exit(2);
  }
  TakeArgument(argc, *argv);
  openr_host::NoteFuzzStates(
      [](uint64_t state) { reached_states[state % std::size(reached_states)] = 1; });
  words = TakeLines("--words", argc, *argv);
  for (const std::string& path : TakeLines("--seeds", argc, *argv)) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    seeds.push_back(bytes.str());
  }
  if (*argc > 1 && std::strcmp((*argv)[1], "--planted") == 0) {
    stops_at_planted_bug = true;
    TakeArgument(argc, *argv);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
