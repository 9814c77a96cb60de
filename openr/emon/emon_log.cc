#include "openr/emon/emon_log.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

namespace openr_host {
namespace {

constexpr size_t kHexDigits = 8;  // of a word that is written without 0x
constexpr uint32_t kWordBytes = 4;
// Most words of a stack dump that are kept.  A damaged address must not take all memory.
constexpr size_t kStackWordsMax = 1 << 18;

constexpr const char* kRegisterNames[kRobotRegisters] = {
    "zero", "at", "v0", "v1", "a0", "a1", "a2", "a3", "t0", "t1", "t2",
    "t3",   "t4", "t5", "t6", "t7", "s0", "s1", "s2", "s3", "s4", "s5",
    "s6",   "s7", "t8", "t9", "k0", "k1", "gp", "sp", "fp", "ra"};

// A number of a line, and the letters and digits between the number before it and this one.
struct NamedNumber {
  std::string name;  // in lower case; "" if there are none
  uint32_t value = 0;
  bool is_hex = false;  // false: a decimal number
};

// A line of the log: its numbers, and what follows the last number.
struct Line {
  std::vector<NamedNumber> numbers;
  std::string rest;
};

bool IsWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Returns the number that `word` is; nullopt if it is a name.
std::optional<NamedNumber> NumberIn(std::string_view word) {
  NamedNumber number;
  std::string_view digits = word;
  if (word.starts_with("0x") || word.starts_with("0X")) {
    digits.remove_prefix(2);
    number.is_hex = true;
  } else {
    number.is_hex = word.size() == kHexDigits;
  }
  const char* const end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number.value, number.is_hex ? 16 : 10);
  if (digits.empty() || result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

Line Split(std::string_view text) {
  Line line;
  std::string name;
  for (size_t at = 0; at < text.size();) {
    if (!IsWordLetter(text[at])) {
      ++at;
      continue;
    }
    size_t end = at;
    while (end < text.size() && IsWordLetter(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    at = end;
    if (std::optional<NamedNumber> number = NumberIn(word)) {
      number->name = std::exchange(name, "");
      line.numbers.push_back(*std::move(number));
    } else {
      name += word;
    }
  }
  line.rest = name;
  return line;
}

std::string Letters(const std::string& name) {
  std::string letters;
  for (const char c : name) {
    if (c != '_') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return letters;
}

// Returns the number of the register `name`, such as "gp", "r28" or "r28gp"; nullopt if it is the
// name of no register.
std::optional<int> RegisterOf(std::string name) {
  int number = 0;
  if (name.size() > 1 && name[0] == 'r' && std::isdigit(static_cast<unsigned char>(name[1]))) {
    const char* const end = name.data() + name.size();
    const auto digits = std::from_chars(name.data() + 1, end, number);
    name.erase(0, static_cast<size_t>(digits.ptr - name.data()));
    if (name.empty()) return number < kRobotRegisters ? std::optional(number) : std::nullopt;
  }
  if (name == "s8") name = "fp";
  const auto* const found = std::find(std::begin(kRegisterNames), std::end(kRegisterNames), name);
  if (found == std::end(kRegisterNames)) return std::nullopt;
  return static_cast<int>(found - std::begin(kRegisterNames));
}

// Reads an EMON.LOG line by line.
class Reader {
 public:
  void Read(const std::string& text) {
    const Line line = Split(text);
    if (IsRepeat(text)) {
      repeats_ = true;
    } else if (IsDump(line)) {
      AddDump(line);
    } else if (IsObject(line)) {
      AddObject(text, line);
    } else {
      AddFields(line);
    }
  }

  std::optional<EmonLog> End() {
    if (!log_.code && log_.cause) log_.code = *log_.cause >> 2 & 31;
    if (!log_.epc && !log_.code) return std::nullopt;
    return std::move(log_);
  }

 private:
  static bool IsRepeat(const std::string& text) {
    const size_t at = text.find_first_not_of(" \t\r");
    return at != std::string::npos && text[at] == '*' &&
           text.find_first_not_of(" \t\r", at + 1) == std::string::npos;
  }

  // A line of the stack dump has an address and the words there, all without names.
  static bool IsDump(const Line& line) {
    return line.numbers.size() >= 2 &&
           std::all_of(line.numbers.begin(), line.numbers.end(),
                       [](const NamedNumber& n) { return n.is_hex && n.name.empty(); });
  }

  // A line of the list of objects has a name and at least three numbers: context, thread and OID.
  static bool IsObject(const Line& line) {
    if (line.numbers.size() < 3 || line.numbers[0].name.empty()) return false;
    if (RegisterOf(Letters(line.numbers[0].name))) return false;
    return std::all_of(line.numbers.begin(), line.numbers.begin() + 3,
                       [](const NamedNumber& n) { return n.is_hex; }) &&
           line.numbers[1].name.empty() && line.numbers[2].name.empty();
  }

  void AddObject(const std::string& text, const Line& line) {
    EmonLog::Object object;
    // The name as it stands in the line, because a name may have a '.' or a '-'.
    std::istringstream words(text);
    words >> object.name;
    object.context = line.numbers[0].value;
    object.thread = line.numbers[1].value;
    object.oid = line.numbers[2].value;
    object.meta_space = line.rest;
    log_.objects.push_back(std::move(object));
  }

  void AddDump(const Line& line) {
    const uint32_t address = line.numbers[0].value;
    if (std::exchange(repeats_, false)) RepeatUpTo(address);
    row_.clear();
    for (size_t i = 1; i < line.numbers.size(); ++i) row_.push_back(line.numbers[i].value);
    row_at_ = address;
    for (size_t i = 0; i < row_.size(); ++i)
      AddWord(address + kWordBytes * static_cast<uint32_t>(i), row_[i]);
  }

  // Fills the stack with the words of the line before, as '*' says, up to `address`.
  void RepeatUpTo(uint32_t address) {
    if (row_.empty() || address <= row_at_) return;
    for (size_t i = row_.size(); i < kStackWordsMax; ++i) {
      const uint64_t at = row_at_ + uint64_t{kWordBytes} * i;
      if (at >= address) return;
      AddWord(static_cast<uint32_t>(at), row_[i % row_.size()]);
    }
  }

  void AddWord(uint32_t address, uint32_t value) {
    if (log_.stack.size() < kStackWordsMax) log_.stack.emplace(address, value);
  }

  void AddFields(const Line& line) {
    std::optional<int> last;  // register of the number before; numbers without names follow it
    for (const NamedNumber& number : line.numbers) {
      const std::string name = Letters(number.name);
      std::optional<int> reg = RegisterOf(name);
      if (name.empty() && last) reg = *last + 1;
      last = reg;
      if (reg && *reg < kRobotRegisters && number.is_hex) {
        Keep(&log_.registers[static_cast<size_t>(*reg)], number.value);
        continue;
      }
      AddField(name, number);
    }
  }

  void AddField(const std::string& name, const NamedNumber& number) {
    if (name == "cause") Keep(&log_.cause, number.value);
    if (name == "epc") Keep(&log_.epc, number.value);
    if (name == "badvaddr" || name == "badaddr") Keep(&log_.bad_address, number.value);
    if (name.ends_with("context")) Keep(&log_.context, number.value);
    if (name.ends_with("exceptioncode") || name == "exccode") Keep(&log_.code, number.value);
  }

  static void Keep(std::optional<uint32_t>* field, uint32_t value) {
    if (!*field) *field = value;
  }

  EmonLog log_;
  std::vector<uint32_t> row_;  // words of the last line of the dump
  uint32_t row_at_ = 0;        // their address
  bool repeats_ = false;       // the last line was '*'
};

}  // namespace

const EmonLog::Object* EmonLog::Crashed() const {
  if (!context) return nullptr;
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [this](const Object& o) { return o.context == *context; });
  return found == objects.end() ? nullptr : &*found;
}

std::optional<EmonLog> ParseEmonLog(const std::string& text) {
  Reader reader;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) reader.Read(line);
  return reader.End();
}

std::string MeaningOfException(uint32_t code) {
  switch (code) {
    case 1:
      return "a store to memory that may only be read, such as the region of a message";
    case 2:
      return "a load, or a jump, with a null or wild pointer";
    case 3:
      return "a store with a null or wild pointer";
    case 4:
      return "a load from an address that is not a multiple of its size, or beyond the program's "
             "addresses";
    case 5:
      return "a store to an address that is not a multiple of its size, or beyond the program's "
             "addresses";
    case 6:
    case 7:
      return "an access to an address where no memory is";
    case 9:
      return "a division of integers by zero, or a breakpoint";
    case 10:
      return "no instruction: data were executed";
    case 11:
      return "an instruction of a coprocessor that is not there";
    case 12:
      return "an overflow of integers";
    case 15:
      return "a NaN, an infinite or a denormal number was used; it was made earlier, perhaps "
             "elsewhere";
    default:
      return "no cause that programs are known to have";
  }
}

}  // namespace openr_host
