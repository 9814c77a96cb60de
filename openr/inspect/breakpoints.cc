#include "openr/inspect/breakpoints.h"

#include <sstream>

namespace openr_host {

std::string Breakpoints::Add(const std::string& text) {
  std::istringstream words(text);
  std::string kind, name, rest;
  words >> kind >> name;
  std::getline(words >> std::ws, rest);
  const bool good =
      (kind == "object" && !name.empty() && rest.empty()) || (kind == "service" && !name.empty()) ||
      (kind == "state" && !name.empty() && !rest.empty()) || (kind == "finding" && name.empty());
  if (!good)
    return "break object NAME, break service TEXT, break state OBJECT TEXT or break finding";
  all_.push_back(text);
  return "";
}

bool Breakpoints::Remove(size_t number) {
  if (number < 1 || number > all_.size()) return false;
  all_.erase(all_.begin() + static_cast<ptrdiff_t>(number) - 1);
  return true;
}

bool Breakpoints::Holds(const std::string& text, Replayer* replayer) {
  std::istringstream words(text);
  std::string kind, name, rest;
  words >> kind >> name;
  std::getline(words >> std::ws, rest);
  const TraceRecord& record = replayer->last().record;
  const TraceReader& reader = replayer->reader();
  if (kind == "object")
    return reader.ObjectName(record.sender) == name || reader.ObjectName(record.target) == name;
  if (kind == "service") {
    const std::string wanted = text.substr(text.find(name));
    return reader.EntryName(record.target, record.selector).find(wanted) != std::string::npos;
  }
  if (kind == "state") {
    const Object* const object = replayer->system().FindObject(0, name);
    return object != nullptr && object->state == rest && object->id == record.target;
  }
  const auto& findings = replayer->system().findings().all();
  return !findings.empty() && findings.back().message == record.number;
}

size_t Breakpoints::Hit(Replayer* replayer) const {
  for (size_t i = 0; i < all_.size(); ++i) {
    if (Holds(all_[i], replayer)) return i + 1;
  }
  return 0;
}

std::string Breakpoints::Save() const {
  std::string text;
  for (const std::string& one : all_) text += one + "\n";
  return text;
}

void Breakpoints::Load(const std::string& text) {
  all_.clear();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) all_.push_back(line);
}

}  // namespace openr_host
