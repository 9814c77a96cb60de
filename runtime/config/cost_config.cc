#include "runtime/config/cost_config.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// Largest virtual time that a cost file may give a handler.  The limit is our choice; a larger
// number is taken for a typing error.
constexpr int64_t kCostMaxUs = 10'000'000;
constexpr int64_t kFrameMinUs = 1'000, kFrameMaxUs = 1'000'000;

constexpr char kCostForm[] = "write: OBJECT ENTRY MICROSECONDS [+-JITTER%]";

// Parses a whole number.  Returns nullopt if `text` is no number or not within `min` to `max`.
std::optional<int64_t> NumberOf(std::string_view text, int64_t min, int64_t max) {
  int64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return {};
  if (value < min || value > max) return {};
  return value;
}

class Parser {
 public:
  explicit Parser(CostResult* result) : result_(*result) {}

  void ParseLine(const RecordLine& line) {
    if (line.words[0].text == "frame") {
      ParseFrame(line);
    } else {
      ParseRule(line);
    }
  }

 private:
  void Refuse(const RecordLine& line, const Word& word, std::string message) {
    result_.diagnostics.push_back(ErrorAt(line.At(word), std::move(message)));
  }

  void ParseFrame(const RecordLine& line) {
    const auto us = line.words.size() == 2 ? NumberOf(line.words[1].text, kFrameMinUs, kFrameMaxUs)
                                           : std::nullopt;
    if (us) {
      result_.config.frame_us = *us;
    } else {
      Refuse(line, line.words.back(),
             fmt::format("a frame lasts {} to {} us; write: frame 8000", kFrameMinUs, kFrameMaxUs));
    }
  }

  // Parses a line of a cost file, "OBJECT ENTRY MICROSECONDS [+-JITTER%]": the virtual time that a
  // handler takes.  Names of entries may contain blanks.  So the numbers are taken from the end of
  // the line, and all words between the object and the numbers are the entry.
  void ParseRule(const RecordLine& line) {
    CostRule rule;
    rule.place = line.At(line.words[0]);
    size_t count = line.words.size();
    if (count > 1 && line.words[count - 1].text.ends_with('%')) {
      const Word& word = line.words[--count];
      const std::string_view text = word.text;
      const auto percent =
          text.starts_with("+-") ? NumberOf(text.substr(2, text.size() - 3), 0, 100) : std::nullopt;
      if (!percent) {
        return Refuse(line, word,
                      fmt::format("'{}' is no jitter; write +-0% to +-100%, in one word", text));
      }
      rule.jitter_percent = static_cast<int>(*percent);
    }
    if (count < 3) {
      return Refuse(line, line.words.back(),
                    fmt::format("object, entry or time missing; {}", kCostForm));
    }
    const Word& last = line.words[count - 1];
    const auto cost_us = NumberOf(last.text, 0, kCostMaxUs);
    if (!cost_us) {
      return Refuse(
          line, last,
          fmt::format("'{}' is no time of 0 to {} us; {}", last.text, kCostMaxUs, kCostForm));
    }
    rule.cost_us = *cost_us;
    rule.object = line.words[0].text;
    for (size_t i = 1; i + 1 < count; ++i) {
      rule.entry += (i == 1 ? "" : " ") + line.words[i].text;
    }
    result_.config.rules.push_back(std::move(rule));
  }

  CostResult& result_;
};

}  // namespace

CostResult ParseCostConfig(const std::string& file, std::string_view text) {
  CostResult result;
  Parser parser(&result);
  for (const RecordLine& line : ReadRecords(file, text, kEveryDesign, &result.diagnostics)) {
    parser.ParseLine(line);
  }
  return result;
}

bool MatchesPattern(std::string_view pattern, std::string_view text) {
  size_t p = 0, t = 0;
  // Compares `text` with the pattern, character by character.  After a mismatch, lets the last '*'
  // of the pattern stand for one more character of `text`, and compares the rest of `text` again
  // with the part of the pattern behind this '*'.
  size_t star = std::string_view::npos;  // position of the last '*' in `pattern`
  size_t resume = 0;                     // end of the part of `text` that the last '*' stands for
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace openr_host
