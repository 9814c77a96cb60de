#include "kit/controller_code.h"

#include <algorithm>
#include <optional>
#include <regex>

#include "kit/source_place.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool IsKeyword(const std::string& word) {
  static const std::set<std::string> kWords = {"if",     "for",   "while",  "switch",
                                               "return", "catch", "sizeof", "do"};
  return kWords.contains(word);
}

// Returns the position of a function's body after `close`, the bracket at the end of its
// parameters; kNone if there is no body.  Between bracket and body there may be "const", and in old
// C the types of the parameters, but nothing else.
size_t BodyAfter(const std::string& code, size_t close) {
  for (size_t at = NextOf(code, close + 1); at != kNone; at = NextOf(code, at + 1)) {
    if (code[at] == '{') return at;
    const bool says_types = IsWordCharacter(code[at]) || code[at] == '*' || code[at] == ',';
    const bool ends_type = code[at] == ';' && IsWordCharacter(code[PreviousOf(code, at)]);
    if (!says_types && !ends_type) return kNone;
  }
  return kNone;
}

}  // namespace

ControllerCode::ControllerCode(const std::vector<fs::path>& sources) {
  for (const fs::path& file : sources) Read(file);
  // Expands macros only when all files are read, because a source comes before its headers in
  // files_ and uses their macros.
  for (CodeFile& file : files_) file.code = macros_.Expand(file.source);
  for (const CodeFile& file : files_) FindFunctions(file);
  for (const CodeFile& file : files_) {
    for (const CodeCall& call : CallsIn(file.code.text, 0, file.code.text.size())) {
      const CodeFunction* const caller = FunctionAt(file, call.at);
      callees_[caller == nullptr ? "" : caller->name].insert(call.name);
    }
  }
}

void ControllerCode::Read(const fs::path& file) {
  static const std::regex kInclude("(?:^|\n)[ \t]*#[ \t]*include[ \t]*\"([^\"\n]+)\"");
  const std::string name = file.lexically_normal();
  const bool is_known = std::any_of(files_.begin(), files_.end(),
                                    [&](const CodeFile& each) { return each.name == name; });
  // Reads no file twice, because headers may include each other.
  const std::optional<std::string> text = is_known ? std::nullopt : ReadText(file);
  if (!text) return;
  files_.push_back({name, *text, {}});
  macros_.Read(*text);
  const std::string& source = files_.back().source;
  for (std::sregex_iterator it(source.begin(), source.end(), kInclude), end; it != end; ++it)
    Read(file.parent_path() / (*it)[1].str());
}

void ControllerCode::FindFunctions(const CodeFile& file) {
  const std::string& code = file.code.text;
  size_t after = 0;  // end of the last function; calls before this position are in its body
  for (const CodeCall& call : CallsIn(code, 0, code.size())) {
    if (call.at < after) continue;
    const size_t close = ClosingOf(code, call.open);
    const size_t body = close == kNone ? kNone : BodyAfter(code, close);
    if (body == kNone) continue;
    functions_.push_back({call.name, &file, body, std::min(ClosingOf(code, body), code.size())});
    after = functions_.back().end;
  }
}

bool ControllerCode::Defines(const std::string& function) const {
  return std::any_of(functions_.begin(), functions_.end(),
                     [&](const CodeFunction& each) { return each.name == function; });
}

bool ControllerCode::Calls(const std::string& function) const {
  return std::any_of(callees_.begin(), callees_.end(),
                     [&](const auto& caller) { return caller.second.contains(function); });
}

const CodeFunction* ControllerCode::FunctionAt(const CodeFile& file, size_t at) const {
  const auto found = std::find_if(functions_.begin(), functions_.end(), [&](const auto& each) {
    return each.file == &file && each.begin <= at && at < each.end;
  });
  return found == functions_.end() ? nullptr : &*found;
}

std::vector<CodeCall> ControllerCode::CallsIn(const std::string& code, size_t begin, size_t end) {
  std::vector<CodeCall> calls;
  for (size_t at = begin; at < end;) {
    const std::string word(WordAt(code, at));
    const size_t next = word.empty() ? kNone : NextOf(code, at + word.size());
    if (next != kNone && code[next] == '(' && !IsKeyword(word)) calls.push_back({word, at, next});
    at += std::max<size_t>(word.size(), 1);
  }
  return calls;
}

std::set<std::string> ControllerCode::FunctionsPassedTo(const std::string& registrar) const {
  std::set<std::string> names;
  for (const CodeFile& file : files_) {
    const std::string& code = file.code.text;
    for (const CodeCall& call : CallsIn(code, 0, code.size())) {
      if (call.name != registrar) continue;
      const size_t at = code.find_first_not_of(" \t\r\n&(", call.open + 1);
      if (at != kNone && !WordAt(code, at).empty()) names.emplace(WordAt(code, at));
    }
  }
  return names;
}

std::set<std::string> ControllerCode::ReachedFrom(std::set<std::string> names) const {
  std::vector<std::string> open(names.begin(), names.end());
  while (!open.empty()) {
    const auto found = callees_.find(open.back());
    open.pop_back();
    if (found == callees_.end()) continue;
    for (const std::string& callee : found->second) {
      if (names.insert(callee).second) open.push_back(callee);
    }
  }
  return names;
}

std::set<std::string> ControllerCode::CallersOf(const std::string& name) const {
  std::set<std::string> names = {name};
  for (const auto& [caller, callees] : callees_) {
    if (!caller.empty() && ReachedFrom({caller}).contains(name)) names.insert(caller);
  }
  return names;
}

FilePosition ControllerCode::PlaceOf(const CodeFile& file, size_t at) {
  const size_t origin = at < file.code.origins.size() ? file.code.origins[at] : file.source.size();
  return PlaceAt(file.name, file.source, origin);
}

std::string ControllerCode::FirstArgument(const CodeFile& file, const CodeCall& call) const {
  const size_t open = file.code.origins[call.open];
  // Returns "" if the brackets of the call come from a macro, because the source then does not show
  // the argument.
  if (file.source[open] != '(') return "";
  const size_t at = NextOf(file.source, open + 1);
  if (at == kNone) return "";
  const std::string word(WordAt(file.source, at));
  return word.empty() ? file.source.substr(at) : macros_.WrittenAs(word);
}

}  // namespace openr_host
