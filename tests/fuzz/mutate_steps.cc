#include "tests/fuzz/mutate_steps.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/mutate_json.h"

namespace openr_host {
namespace {

// Returns any number below `limit`.
size_t Any(size_t limit, FuzzRandom* random) { return (*random)() % limit; }

// Returns the steps of `program`.  Bytes in front of the first step belong to it.
std::vector<std::string> StepsOf(const std::string& program, const FuzzStarts& starts) {
  std::vector<std::string> steps;
  size_t begin = 0;
  for (size_t i = 1; i <= starts.size(); ++i) {
    const size_t end = i < starts.size() ? std::min(starts[i], program.size()) : program.size();
    if (end > begin) steps.push_back(program.substr(begin, end - begin));
    begin = std::max(begin, end);
  }
  return steps;
}

std::string ProgramOf(const std::vector<std::string>& steps) {
  std::string program;
  for (const std::string& step : steps) program += step;
  return program;
}

// A row of steps: index of the first one, and the index behind the last one.
struct Row {
  size_t begin, end;
};

// Chooses a row of steps: one step, some steps, or any number of them.
Row ChooseRow(size_t steps, FuzzRandom* random) {
  const size_t begin = Any(steps, random);
  const size_t kind = Any(4, random);
  if (kind == 3) return {0, steps};
  const size_t most = kind == 0 ? 1 : kind == 1 ? 8 : steps;
  return {begin, begin + 1 + Any(std::min(most, steps - begin), random)};
}

// Puts a row of steps behind all others, or anywhere between them.
void Insert(const std::vector<std::string>& row, std::vector<std::string>* steps,
            FuzzRandom* random) {
  const size_t to = Any(2, random) == 0 ? steps->size() : Any(steps->size() + 1, random);
  steps->insert(steps->begin() + static_cast<std::ptrdiff_t>(to), row.begin(), row.end());
}

std::vector<std::string> Copy(const std::vector<std::string>& steps, Row row) {
  return {steps.begin() + static_cast<std::ptrdiff_t>(row.begin),
          steps.begin() + static_cast<std::ptrdiff_t>(row.end)};
}

void ChangeByte(std::string* step, FuzzRandom* random) {
  char& byte = (*step)[Any(step->size(), random)];
  auto value = static_cast<uint8_t>(byte);
  switch (Any(4, random)) {
    case 0:
    case 1:
      value = static_cast<uint8_t>(value + Any(9, random) - 4);
      break;
    case 2:
      value = static_cast<uint8_t>(value ^ 1U << Any(8, random));
      break;
    default:
      value = static_cast<uint8_t>(Any(256, random));
  }
  byte = static_cast<char>(value);
}

// A part of a message of the target panel_websocket.
struct Part {
  uint8_t flags = 0;
  std::string text;
};

constexpr uint8_t kIsLast = 0x01;    // the message ends with the part
constexpr uint8_t kIsLonger = 0x10;  // the part has blanks behind its text
constexpr size_t kPartHead = 3;      // bytes in front of the text
constexpr size_t kPartTextMax = 0xffff;

std::vector<Part> PartsOf(std::string_view input) {
  std::vector<Part> parts;
  while (input.size() >= kPartHead) {
    const size_t size = static_cast<uint8_t>(input[1]) | static_cast<uint8_t>(input[2]) << 8;
    parts.push_back({static_cast<uint8_t>(input[0]), std::string(input.substr(kPartHead, size))});
    input.remove_prefix(std::min(kPartHead + size, input.size()));
  }
  return parts;
}

std::string InputOf(const std::vector<Part>& parts) {
  std::string input;
  for (const Part& part : parts) {
    const std::string text = part.text.substr(0, kPartTextMax);
    input += static_cast<char>(part.flags);
    input += static_cast<char>(text.size() & 0xff);
    input += static_cast<char>(text.size() >> 8);
    input += text;
  }
  return input;
}

}  // namespace

std::string MutateSteps(const std::string& program, const FuzzStarts& starts, FuzzRandom* random) {
  std::vector<std::string> steps = StepsOf(program, starts);
  if (steps.empty()) return program;
  const size_t kind = Any(10, random);
  if (kind < 5) {
    ChangeByte(&steps[Any(steps.size(), random)], random);
    return ProgramOf(steps);
  }
  const Row row = ChooseRow(steps.size(), random);
  const std::vector<std::string> chosen = Copy(steps, row);
  if (kind >= 7) {  // removes the row, or moves it
    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(row.begin),
                steps.begin() + static_cast<std::ptrdiff_t>(row.end));
  }
  if (kind != 7) Insert(chosen, &steps, random);
  return ProgramOf(steps);
}

std::string JoinSteps(const std::string& first, const FuzzStarts& first_starts,
                      const std::string& second, const FuzzStarts& second_starts,
                      FuzzRandom* random) {
  std::vector<std::string> steps = StepsOf(first, first_starts);
  const std::vector<std::string> others = StepsOf(second, second_starts);
  if (others.empty()) return first;
  // Takes the whole second program every second time, because a long deed, such as an upload, is
  // rarely in a part of a program.
  const Row row = Any(2, random) == 0 ? Row{0, others.size()} : ChooseRow(others.size(), random);
  Insert(Copy(others, row), &steps, random);
  return ProgramOf(steps);
}

std::string MutateParts(const std::string& input, const FuzzWords& words, FuzzRandom* random) {
  std::vector<Part> parts = PartsOf(input);
  if (parts.empty()) return input;
  const size_t chosen = Any(parts.size(), random);
  const auto next = parts.begin() + static_cast<std::ptrdiff_t>(chosen) + 1;
  Part& part = parts[chosen];
  const size_t kind = Any(6, random);
  if (kind == 4 && !part.text.empty()) {
    const size_t size = Any(part.text.size(), random);
    const Part rest{part.flags, part.text.substr(size)};
    part.text.resize(size);
    part.flags = static_cast<uint8_t>(part.flags & ~(kIsLast | kIsLonger));
    parts.insert(next, rest);
  } else if (kind == 5 && next != parts.end()) {
    part.text += next->text;
    part.flags = next->flags;
    parts.erase(next);
  } else {
    const std::string changed =
        kind % 2 == 0 ? MutateJson(part.text, words, random) : std::string();
    part.text = changed.empty() ? MutateText(part.text, words, random) : changed;
  }
  return InputOf(parts);
}

}  // namespace openr_host
