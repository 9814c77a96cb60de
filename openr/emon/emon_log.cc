#include "openr/emon/emon_log.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace openr_host {
namespace {

// Number of hexadecimal digits of a 32-bit word.  A text of this length is taken for a hexadecimal
// number, even without "0x".
constexpr size_t kHexDigits = 8;
constexpr uint32_t kWordBytes = 4;
// Largest number of words of a stack dump that are kept, so that a damaged address in the dump
// cannot make the reader use all memory.
constexpr size_t kStackWordsMax = 1 << 18;

constexpr const char* kRegisterNames[kRobotRegisters] = {
    "zero", "at", "v0", "v1", "a0", "a1", "a2", "a3", "t0", "t1", "t2",
    "t3",   "t4", "t5", "t6", "t7", "s0", "s1", "s2", "s3", "s4", "s5",
    "s6",   "s7", "t8", "t9", "k0", "k1", "gp", "sp", "fp", "ra"};

// Names of numbers in a crash record.  A number after one of these names is always hexadecimal.
constexpr const char* kHexNames[] = {"cause", "epc", "badvaddr", "context", "gp", "ra", "sp"};

// A number in a line of a crash record, with its name.  The name is the words between the previous
// number and this number, in lower case.
struct NamedNumber {
  std::vector<std::string> words;
  uint32_t value = 0;
  bool is_hex = false;  // false: a decimal number
};

bool IsWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool IsHexName(const std::string& word) {
  return std::find(std::begin(kHexNames), std::end(kHexNames), word) != std::end(kHexNames);
}

std::string LowerCase(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Returns the number that the text `word` stands for; nullopt if it is no number.  `before` has the
// words in front of the number; after "epc" and other names of registers the number is hexadecimal.
std::optional<NamedNumber> NumberIn(std::string_view word, const std::vector<std::string>& before) {
  NamedNumber number;
  std::string_view digits = word;
  number.is_hex = word.size() == kHexDigits || (!before.empty() && IsHexName(before.back()));
  if (word.starts_with("0x") || word.starts_with("0X")) {
    digits.remove_prefix(2);
    number.is_hex = true;
  }
  // Keeps the last 8 digits of a longer number.  Only the time stamp of a crash record is longer
  // (16 digits), and its value is not used.
  if (number.is_hex && digits.size() > kHexDigits) digits.remove_prefix(digits.size() - kHexDigits);
  const char* const end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number.value, number.is_hex ? 16 : 10);
  if (digits.empty() || result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

// Returns the numbers in a line of a crash record.  Leaves out a number with a '$' in front, such
// as "$14" in "epc:$14: 0x00400010", because it is no value: $14 is the register of the coprocessor
// that has the name "epc".
std::vector<NamedNumber> Split(std::string_view text) {
  std::vector<NamedNumber> numbers;
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    if (!IsWordLetter(text[at])) {
      ++at;
      continue;
    }
    size_t end = at;
    while (end < text.size() && IsWordLetter(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    const bool is_of_name = at > 0 && text[at - 1] == '$';
    at = end;
    if (is_of_name) continue;
    if (std::optional<NamedNumber> number = NumberIn(word, words)) {
      number->words = std::exchange(words, {});
      numbers.push_back(*std::move(number));
    } else {
      words.push_back(LowerCase(word));
    }
  }
  return numbers;
}

// Returns the number of the register `word`, such as "gp" or "r28"; nullopt if no register has this
// name.
std::optional<int> RegisterOf(const std::string& word) {
  if (word == "s8") return RegisterOf("fp");
  const auto* const found = std::find(std::begin(kRegisterNames), std::end(kRegisterNames), word);
  if (found != std::end(kRegisterNames))
    return static_cast<int>(found - std::begin(kRegisterNames));
  int number = 0;
  const char* const end = word.data() + word.size();
  if (word.size() < 2 || word[0] != 'r') return std::nullopt;
  const auto digits = std::from_chars(word.data() + 1, end, number);
  if (digits.ec != std::errc() || digits.ptr != end || number < 0 || number >= kRobotRegisters)
    return std::nullopt;
  return number;
}

// Reads an EMON.LOG line by line.
class Reader {
 public:
  void Read(const std::string& line) {
    const size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) return;
    const std::string text = line.substr(begin);
    if (text[0] == '[') {
      section_ = LowerCase(text);
    } else if (text[0] == '*') {
      repeats_ = true;
    } else if (!ReadDump(text) && !ReadObject(text)) {
      ReadFields(text);
    }
  }

  std::optional<EmonLog> End() {
    if (!log_.code && log_.cause) log_.code = *log_.cause >> 2 & 31;
    if (!log_.epc && !log_.code) return std::nullopt;
    return std::move(log_);
  }

 private:
  // Returns the address and the words in a line of a crash record's stack dump; an empty list for
  // any other line.  Reads the line only up to two blanks, because the text behind them shows the
  // bytes of the same words as characters.
  static std::vector<uint32_t> WordsOfDump(const std::string& text) {
    std::vector<uint32_t> words;
    const std::string numbers = text.substr(0, text.find("  ", kHexDigits + 2));
    for (const NamedNumber& number : Split(numbers)) {
      if (!number.is_hex || !number.words.empty()) return {};
      words.push_back(number.value);
    }
    return words;
  }

  // Reads a line of a crash record's stack dump: an address, ':' and the words at this address.
  // Returns false for any other line.
  bool ReadDump(const std::string& text) {
    const std::string address_text = text.substr(0, text.find(':'));
    const std::vector<NamedNumber> address = Split(address_text);
    if (address_text.size() == text.size() || address.size() != 1 || !address[0].is_hex ||
        !address[0].words.empty())
      return false;
    std::vector<uint32_t> words = WordsOfDump(text);
    if (words.size() < 2) return false;
    words.erase(words.begin());
    if (std::exchange(repeats_, false)) RepeatUpTo(address[0].value);
    row_at_ = address[0].value;
    row_ = std::move(words);
    for (size_t i = 0; i < row_.size(); ++i)
      AddWord(row_at_ + kWordBytes * static_cast<uint32_t>(i), row_[i]);
    return true;
  }

  // Handles a line '*' of the stack dump, which stands for copies of the previous line.  Adds the
  // words of these copies to the stack, up to `address`, the address of the next line.
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

  // Reads a line of the list of objects in a crash record.  Such a line has the name of the object,
  // its context, thread and object id (OID) and, in some records, its meta space (the environment
  // of the object, such as mCOOP).  Returns false for any other line.
  bool ReadObject(const std::string& text) {
    if (!section_.empty() && section_.find("object list") == std::string::npos) return false;
    const size_t end = text.find_first_of(" \t");
    if (end == std::string::npos ||
        RegisterOf(LowerCase(text.substr(0, text.find_first_of("(: \t")))))
      return false;
    const std::vector<NamedNumber> numbers = Split(std::string_view(text).substr(end));
    if (numbers.size() < 3) return false;
    for (size_t i = 0; i < 3; ++i) {
      if (!numbers[i].is_hex || !numbers[i].words.empty()) return false;
    }
    EmonLog::Object object;
    object.name = text.substr(0, end);
    object.context = numbers[0].value;
    object.thread = numbers[1].value;
    object.oid = numbers[2].value;
    std::istringstream last(text.substr(text.find_last_of(" \t", text.find_last_not_of(" \t\r"))));
    last >> object.meta_space;
    if (!Split(object.meta_space).empty()) object.meta_space.clear();
    log_.objects.push_back(std::move(object));
    return true;
  }

  void ReadFields(const std::string& text) {
    // Register to which the previous number of this line of a crash record belongs.  If the next
    // number has no name, it belongs to the register after `last`.
    std::optional<int> last;
    for (const NamedNumber& number : Split(text)) {
      std::optional<int> reg;
      if (!number.words.empty()) reg = RegisterOf(number.words.back());
      if (number.words.empty() && last && *last + 1 < kRobotRegisters) reg = *last + 1;
      last = reg;
      if (reg && number.is_hex) {
        Keep(&log_.registers[static_cast<size_t>(*reg)], number.value);
      } else {
        ReadField(number);
      }
    }
  }

  void ReadField(const NamedNumber& number) {
    std::string name;
    for (const std::string& word : number.words) name += word;
    if (name == "exceptioncode" || name == "exccode") Keep(&log_.code, number.value);
    if (!number.is_hex) return;
    if (name == "cause") Keep(&log_.cause, number.value);
    if (name == "epc") Keep(&log_.epc, number.value);
    if (name == "badvaddr") Keep(&log_.bad_address, number.value);
    if (name == "context") Keep(&log_.context, number.value);
  }

  static void Keep(std::optional<uint32_t>* field, uint32_t value) {
    if (!*field) *field = value;
  }

  EmonLog log_;
  std::string section_;  // heading in brackets that was read last, in lower case; "": none yet
  std::vector<uint32_t> row_;  // words of the last line of the stack dump
  uint32_t row_at_ = 0;        // address of the first word in row_
  bool repeats_ = false;       // true: the last line was '*', which stands for lines equal to row_
};

}  // namespace

std::optional<uint32_t> EmonLog::FailedAddress() const {
  if (!epc) return std::nullopt;
  // If the highest bit of the cause is set, the instruction was in the delay slot of a branch.  epc
  // is then the address of the branch, and the instruction is one word later.
  return *epc + (cause.value_or(0) >> 31 != 0 ? kWordBytes : 0);
}

const EmonLog::Object* EmonLog::CrashedObject() const {
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
             "addresses, or a jump there";
    case 5:
      return "a store to an address that is not a multiple of its size, or beyond the program's "
             "addresses";
    case 6:
    case 7:
      return "an access to an address where no memory is";
    case 9:
      return "a division of integers by zero, or a breakpoint";
    case 10:
      return "an unknown instruction: the program probably jumped into data";
    case 11:
      return "an instruction of a coprocessor that is not there";
    case 12:
      return "an overflow of integers";
    case 15:
      return "a NaN, an infinite or a denormal number was used; it was made earlier, perhaps "
             "elsewhere";
    default:
      return "an unusual cause";
  }
}

}  // namespace openr_host
