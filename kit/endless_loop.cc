#include "kit/endless_loop.h"

#include <algorithm>
#include <regex>

#include "kit/source_text.h"

namespace openr_host {
namespace {

class LoopFinder {
 public:
  LoopFinder(const std::string& code, const std::function<bool(std::string_view)>& is_true)
      : code_(code), is_true_(is_true) {}

  std::vector<EndlessLoop> Find() {
    for (size_t at = 0; at < code_.size();) {
      const std::string_view word = WordAt(code_, at);
      if (word == "do") CheckDoLoop(at);
      if (word == "for" || (word == "while" && !IsEndOfDo(at))) CheckLoop(at, word);
      at += std::max<size_t>(word.size(), 1);
    }
    return loops_;
  }

 private:
  // Returns the position after the statement that begins at `at`.
  size_t EndOfStatement(size_t at) const {
    for (size_t i = NextOf(code_, at); i != kNone && i < code_.size(); ++i) {
      if (code_[i] == ';' || code_[i] == '}') return i + 1;
      if (code_[i] != '(' && code_[i] != '{' && code_[i] != '[') continue;
      const bool is_block = code_[i] == '{';
      i = ClosingOf(code_, i);
      if (i == kNone) return code_.size();
      const size_t next = NextOf(code_, i + 1);
      // A block does not end the statement if "else", or the "while" of a do loop, follows.
      const bool goes_on = next != kNone && (HasWordAt(code_, next, "else") || IsEndOfDo(next));
      if (is_block && !goes_on) return i + 1;
    }
    return code_.size();
  }

  // Returns whether the word "while" at `at` is the end of a do loop and not the beginning of a
  // while loop.
  bool IsEndOfDo(size_t at) const { return std::count(do_ends_.begin(), do_ends_.end(), at) > 0; }

  void CheckDoLoop(size_t at) {
    const size_t body = NextOf(code_, at + 2);
    if (body == kNone) return;
    const size_t end = EndOfStatement(body);
    const size_t condition = NextOf(code_, end);
    if (condition == kNone || !HasWordAt(code_, condition, "while")) return;
    do_ends_.push_back(condition);
    const size_t open = NextOf(code_, condition + 5);
    const size_t close = open == kNone ? kNone : ClosingOf(code_, open);
    if (close != kNone) AddIfEndless(at, TextBetween(open, close), body, close);
  }

  void CheckLoop(size_t at, std::string_view word) {
    const size_t open = NextOf(code_, at + word.size());
    if (open == kNone || code_[open] != '(') return;
    const size_t close = ClosingOf(code_, open);
    if (close == kNone) return;
    std::string condition = TextBetween(open, close);
    if (word == "for") {
      const size_t first = condition.find(';');
      const size_t second = first == kNone ? kNone : condition.find(';', first + 1);
      if (second == kNone) return;
      condition = condition.substr(first + 1, second - first - 1);
      // Takes an empty condition, as in for (;;), as true.
      if (NextOf(condition, 0) == kNone) condition.assign(1, '1');
    }
    AddIfEndless(at, condition, close + 1, EndOfStatement(close + 1));
  }

  void AddIfEndless(size_t at, const std::string& condition, size_t body, size_t end) {
    const bool waits = AsksADevice(condition);
    if ((waits || IsTrue(condition)) && !Leaves(body, end)) loops_.push_back({at, end, waits});
  }

  std::string TextBetween(size_t open, size_t close) const {
    return code_.substr(open + 1, close - open - 1);
  }

  bool IsTrue(const std::string& condition) const {
    std::string word;
    for (const char c : condition) {
      if (c != '(' && c != ')' && c != ' ' && c != '\t' && c != '\r' && c != '\n') word += c;
    }
    return word == "true" || is_true_(word);
  }

  // Returns whether the condition of a loop waits for a value of a device to change.  Such a loop
  // never ends, because no time passes while a function of the controller runs, so the value does
  // not change.  Returns false if the condition also contains ++, --, an assignment or &&, because
  // these may end the loop.
  static bool AsksADevice(const std::string& condition) {
    static const std::regex kAsks(
        "\\b(\\w+_sensor_get_value|servo_get_position|accelerometer_get_values|"
        "thermometer_get_value|camera_get_image|mtn_is_over|mtn_get_time)[ \t\r\n]*\\(");
    static const std::regex kChanges("\\+\\+|--|&&|[^=!<>]=[^=]");
    return std::regex_search(condition, kAsks) && !std::regex_search(condition, kChanges);
  }

  // Returns whether a statement in the body of a loop, from `begin` to `end`, leaves this loop.
  bool Leaves(size_t begin, size_t end) const {
    // End of an inner loop or switch.  A break before this position leaves only the inner loop or
    // switch.
    size_t inner = begin;
    for (size_t at = begin; at < end;) {
      const std::string_view word = WordAt(code_, at);
      if (word == "return" || word == "goto" || word == "throw" || word == "exit" ||
          word == "abort" || word == "longjmp")
        return true;
      if (word == "break" && at >= inner) return true;
      if (word == "for" || word == "while" || word == "switch") {
        const size_t open = NextOf(code_, at + word.size());
        const size_t close = open == kNone ? kNone : ClosingOf(code_, open);
        if (close != kNone) inner = std::max(inner, EndOfStatement(close + 1));
      }
      if (word == "do") inner = std::max(inner, EndOfStatement(at + 2));
      at += std::max<size_t>(word.size(), 1);
    }
    return false;
  }

  const std::string& code_;
  const std::function<bool(std::string_view)>& is_true_;
  std::vector<size_t> do_ends_;
  std::vector<EndlessLoop> loops_;
};

}  // namespace

std::vector<EndlessLoop> FindEndlessLoops(const std::string& code,
                                          const std::function<bool(std::string_view)>& is_true) {
  return LoopFinder(code, is_true).Find();
}

}  // namespace openr_host
