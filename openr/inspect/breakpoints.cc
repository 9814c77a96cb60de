#include "openr/inspect/breakpoints.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "runtime/base/spelling.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr char kForms[] =
    "break object NAME, break service TEXT, break state OBJECT TEXT, break finding or break when "
    "QUANTITY OP VALUE";

struct Words {
  explicit Words(const std::string& text) {
    std::istringstream stream(text);
    stream >> kind >> name;
    std::getline(stream >> std::ws, rest);
  }
  std::string kind, name, rest;
};

PropertyRule ReadRule(const std::string& condition) {
  std::vector<Diagnostic> diagnostics;
  const auto rules = ParseProperties("break when", "always " + condition, &diagnostics);
  if (rules.size() != 1)
    throw std::runtime_error("break when QUANTITY OP VALUE, like 'robots[0].pitch_deg > 10'");
  return rules.front();
}

}  // namespace

Breakpoints::Break Breakpoints::Read(const std::string& text) const {
  const Words words(text);
  Break one{text, {}, {}};
  if (words.kind == "when") {
    one.rule = ReadRule(words.name + " " + words.rest);
    one.quantity = FindQuantity(one.rule->quantity, view_->run());
    // Remembers whether the condition is true already, because this breakpoint stops the replay
    // only when the condition becomes true.
    one.held = Holds(one);
    return one;
  }
  const bool good = (words.kind == "object" && !words.name.empty() && words.rest.empty()) ||
                    (words.kind == "service" && !words.name.empty()) ||
                    (words.kind == "state" && !words.name.empty() && !words.rest.empty()) ||
                    (words.kind == "finding" && words.name.empty());
  if (!good) throw std::runtime_error(kForms);
  if (words.kind == "object" || words.kind == "state") CheckObject(words.name);
  if (words.kind == "service") CheckService(text.substr(text.find(words.name)));
  return one;
}

void Breakpoints::CheckObject(const std::string& name) const {
  std::vector<std::string> known;
  for (const auto& object : replayer_->system().objects()) {
    if (object == nullptr) continue;
    if (object->name == name) return;
    known.push_back(object->name);
  }
  throw std::runtime_error(fmt::format("there is no object '{}'{}", name, DidYouMean(name, known)));
}

// Throws std::runtime_error if no entry (handler for messages) of any object has `part` in its
// name.  Accepts every `part` while some object has no names of entries yet, because entries get
// their names during the boot.
void Breakpoints::CheckService(const std::string& part) const {
  for (const auto& object : replayer_->system().objects()) {
    if (object == nullptr) continue;
    if (object->entry_names().names().empty()) return;
    for (const auto& [selector, name] : object->entry_names().names()) {
      if (name.find(part) != std::string::npos) return;
    }
  }
  throw std::runtime_error(fmt::format("no entry of an object has '{}' in its name", part));
}

std::string Breakpoints::Add(const std::string& text) {
  try {
    all_.push_back(Read(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

bool Breakpoints::Remove(size_t number) {
  if (number < 1 || number > all_.size()) return false;
  all_.erase(all_.begin() + static_cast<ptrdiff_t>(number) - 1);
  return true;
}

bool Breakpoints::Holds(const Break& one) const {
  if (!one.rule) return HoldsText(one.text);
  return Compares(one.quantity(view_->run()), one.rule->op, one.rule->value);
}

bool Breakpoints::HoldsText(const std::string& text) const {
  const Words words(text);
  const TraceRecord& record = replayer_->last().record;
  const TraceReader& reader = replayer_->reader();
  if (words.kind == "object") {
    return reader.ObjectName(record.sender) == words.name ||
           reader.ObjectName(record.target) == words.name;
  }
  if (words.kind == "service") {
    const std::string wanted = text.substr(text.find(words.name));
    return reader.EntryName(record.target, record.selector).find(wanted) != std::string::npos;
  }
  if (words.kind == "state") {
    const Object* const target = replayer_->system().object(record.target);
    return target != nullptr && target->name == words.name &&
           target->statistics().state() == words.rest;
  }
  const auto& findings = replayer_->system().findings().all();
  return !findings.empty() && findings.back().message == record.number;
}

void Breakpoints::Arm() {
  for (Break& one : all_) one.held = one.rule && Holds(one);
}

size_t Breakpoints::FindHit() {
  size_t hit = 0;
  for (size_t i = 0; i < all_.size(); ++i) {
    const bool holds = Holds(all_[i]);
    if (holds && !all_[i].held && hit == 0) hit = i + 1;
    all_[i].held = all_[i].rule && holds;
  }
  return hit;
}

std::string Breakpoints::Save() const {
  std::string text;
  for (const Break& one : all_) text += one.text + "\n";
  return text;
}

void Breakpoints::Load(const std::string& text) {
  all_.clear();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) all_.push_back(Read(line));
}

}  // namespace openr_host
