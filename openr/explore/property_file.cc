#include "openr/explore/property_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "openr/explore/quantity.h"
#include "runtime/base/duration.h"
#include "runtime/base/read_file.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using When = PropertyRule::When;

// The words that a property file may have for WHEN, in the order of the enumerators of
// PropertyRule::When, because ReadWhen() converts the index of a word to an enumerator.
const std::vector<std::string> kWhens = {"always", "eventually", "finally"};
const std::vector<std::string> kOps = {"==", "!=", "<=", ">=", "<", ">"};

// Reads the parts of one line of a property file, word by word from left to right.
class LineReader {
 public:
  LineReader(const RecordLine& line, std::vector<Diagnostic>* diagnostics)
      : line_(line), diagnostics_(diagnostics) {}

  std::optional<PropertyRule> Read() {
    PropertyRule rule;
    if (!ReadName(&rule) || !ReadWhen(&rule) || !ReadTimes(&rule) || !ReadComparison(&rule)) {
      return {};
    }
    return rule;
  }

 private:
  bool Refuse(std::string message) {
    const bool at_end = next_ >= line_.words.size();
    const Word& word = at_end ? line_.words.back() : line_.words[next_];
    diagnostics_->push_back(ErrorAt(line_.At(word), std::move(message)));
    return false;
  }
  const std::string& Peek() const {
    static const std::string kNothing;
    return next_ < line_.words.size() ? line_.words[next_].text : kNothing;
  }

  bool ReadName(PropertyRule* rule) {
    rule->name = fmt::format("line {}", line_.place.line);
    if (!Peek().ends_with(':')) return true;
    rule->name = Peek().substr(0, Peek().size() - 1);
    if (rule->name.empty()) return Refuse("a name is missing before ':'");
    ++next_;
    return true;
  }

  bool ReadWhen(PropertyRule* rule) {
    const auto found = std::find(kWhens.begin(), kWhens.end(), Peek());
    if (found == kWhens.end()) {
      return Refuse(fmt::format("'{}' is neither always nor eventually nor finally{}", Peek(),
                                DidYouMean(Peek(), kWhens)));
    }
    rule->when = static_cast<When>(found - kWhens.begin());
    ++next_;
    return true;
  }

  bool ReadTimes(PropertyRule* rule) {
    while (Peek() == "from" || Peek() == "within") {
      const bool is_within = Peek() == "within";
      if (is_within && rule->when != When::kEventually) {
        return Refuse("only 'eventually' has a 'within'");
      }
      ++next_;
      const std::string problem =
          ParseDuration(Peek(), is_within ? &rule->within_us : &rule->from_us);
      if (!problem.empty()) return Refuse(problem);
      ++next_;
    }
    return true;
  }

  bool ReadComparison(PropertyRule* rule) {
    if (next_ + 3 > line_.words.size()) {
      return Refuse("write: QUANTITY OP VALUE, such as objects.JointMover.state == failed");
    }
    rule->quantity = Peek();
    rule->place = line_.At(line_.words[next_++]);
    if (std::find(kOps.begin(), kOps.end(), Peek()) == kOps.end()) {
      return Refuse(fmt::format("'{}' compares nothing; there are == != < <= > >=", Peek()));
    }
    rule->op = Peek();
    ++next_;
    const std::string& text = line_.place.text;
    rule->value = text.substr(static_cast<size_t>(line_.words[next_].column) - 1);
    rule->value.erase(rule->value.find_last_not_of(" \t") + 1);
    return true;
  }

  const RecordLine& line_;
  std::vector<Diagnostic>* const diagnostics_;
  size_t next_ = 0;
};

std::string TextOf(const Value& value) {
  if (const auto* const text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  return fmt::format("{:g}", std::get<double>(value));
}

class RuleProperty : public Property {
 public:
  explicit RuleProperty(PropertyRule rule) : Property(rule.name), rule_(std::move(rule)) {}

  std::string Check(const RunView& view) override {
    const int64_t now_us = view.prepared->system->now_us();
    if (rule_.when == When::kFinally || has_been_ || now_us < rule_.from_us) return "";
    was_looked_at_ = true;
    const bool holds = Holds(view);
    if (rule_.when == When::kAlways) return holds ? "" : Say("");
    has_been_ = holds;
    const bool too_late = rule_.within_us >= 0 && now_us > rule_.within_us;
    return too_late && !holds ? Say(fmt::format(" within {}", FormatDuration(rule_.within_us)))
                              : "";
  }

  std::string CheckEnd(const RunView& view) override {
    if (rule_.when != When::kFinally && !was_looked_at_) {
      throw std::runtime_error(
          Render(ErrorAt(rule_.place, fmt::format("the run ends before {}: this is never looked at",
                                                  FormatDuration(rule_.from_us)))));
    }
    if (rule_.when == When::kAlways || has_been_) return "";
    return Holds(view) ? "" : Say(rule_.when == When::kFinally ? " at the end" : " ever");
  }

 private:
  bool Holds(const RunView& view) {
    try {
      if (!quantity_) quantity_ = FindQuantity(rule_.quantity, view);
      last_ = quantity_(view);
      return Compares(last_, rule_.op, rule_.value);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(Render(ErrorAt(rule_.place, error.what())));
    }
  }
  std::string Say(const std::string& when) const {
    return fmt::format("not {} {} {}{}: it is {}", rule_.quantity, rule_.op, rule_.value, when,
                       TextOf(last_));
  }

  const PropertyRule rule_;
  Quantity quantity_;
  Value last_;
  // For a property with the word `eventually`: true if its comparison was true at least once.
  bool has_been_ = false;
  bool was_looked_at_ = false;
};

template <typename T>
bool CompareAs(const T& a, const std::string& op, const T& b) {
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  return op == ">" ? a > b : a >= b;
}

}  // namespace

bool Compares(const Value& actual, const std::string& op, const std::string& expected) {
  if (const auto* const text = std::get_if<std::string>(&actual)) {
    if (op != "==" && op != "!=") throw std::runtime_error("texts have no order; use == or !=");
    return CompareAs(*text, op, expected);
  }
  char* end = nullptr;
  const double number = std::strtod(expected.c_str(), &end);
  if (expected.empty() || *end != 0 || std::isnan(number)) {
    throw std::runtime_error(fmt::format("'{}' is no number, the quantity is one", expected));
  }
  return CompareAs(std::get<double>(actual), op, number);
}

std::vector<PropertyRule> ParseProperties(const std::string& file, std::string_view text,
                                          std::vector<Diagnostic>* diagnostics) {
  std::vector<PropertyRule> rules;
  for (const FilePosition& place : SplitLines(file, text, diagnostics)) {
    RecordLine line{place, SplitWords(place.text), ""};
    if (line.words.empty() || line.words[0].text[0] == '#') continue;
    if (auto rule = LineReader(line, diagnostics).Read()) rules.push_back(std::move(*rule));
  }
  return rules;
}

namespace {

// Adds an error to `diagnostics` for each property that has the name of a built-in or of an earlier
// property.  Each name must be unique, because a failure is reported by the name of the property.
void CheckNames(const std::vector<PropertyRule>& rules, std::vector<Diagnostic>* diagnostics) {
  std::set<std::string> names = {kNoCrash, kHandlersReturn};
  for (const PropertyEntry& entry : PropertyTable()) names.insert(entry.name);
  for (const PropertyRule& rule : rules) {
    if (names.insert(rule.name).second) continue;
    diagnostics->push_back(
        ErrorAt(rule.place, fmt::format("there is a property '{}' already", rule.name)));
  }
}

}  // namespace

std::vector<std::unique_ptr<Property>> MakeProperties(const std::string& file,
                                                      std::string_view text) {
  std::vector<Diagnostic> diagnostics;
  std::vector<PropertyRule> rules = ParseProperties(file, text, &diagnostics);
  CheckNames(rules, &diagnostics);
  if (!diagnostics.empty()) {
    std::string problems = Render(diagnostics);
    problems.pop_back();  // removes the newline at the end of the last problem
    throw std::runtime_error(problems);
  }
  if (rules.empty()) throw std::runtime_error(fmt::format("{}: has no property", file));
  std::vector<std::unique_ptr<Property>> properties;
  for (PropertyRule& rule : rules) {
    properties.push_back(std::make_unique<RuleProperty>(std::move(rule)));
  }
  return properties;
}

std::vector<std::unique_ptr<Property>> LoadPropertyFile(const std::string& path) {
  const std::optional<std::string> text = ReadFile(path);
  if (!text)
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  return MakeProperties(path, *text);
}

}  // namespace openr_host
