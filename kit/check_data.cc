#include "kit/check_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "kit/source_place.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Returns `body`, the inside of a struct or class, with bodies of functions and text in round
// brackets blanked out.  The text that is left declares the members of the type.
std::string MembersOf(std::string body) {
  for (size_t at = 0; at < body.size(); ++at) {
    if (body[at] != '{' && body[at] != '(') continue;
    const size_t close = std::min(ClosingOf(body, at), body.size() - 1);
    std::fill(body.begin() + static_cast<std::ptrdiff_t>(at),
              body.begin() + static_cast<std::ptrdiff_t>(close) + 1, ' ');
  }
  return body;
}

// Returns the reason why values of a type cannot be sent as bytes; "" if such values can be sent.
// `members` is the text of the type's members.
std::string TroubleIn(const std::string& members) {
  static const std::regex kContainer(
      "\\b(string|vector|list|deque|map|multimap|set|multiset|queue|stack)\\b[ \t]*(<[^;]*>)?"
      "[ \t]+\\w+[ \t]*[;,\\[]");
  static const std::regex kPointer("\\b\\w+[ \t]*\\*[ \t*]*\\w+[ \t]*[;\\[]");
  static const std::regex kVirtual("\\bvirtual\\b");
  std::smatch match;
  if (std::regex_search(members, match, kVirtual)) return "has virtual functions";
  if (std::regex_search(members, match, kContainer))
    return fmt::format("has a member of type {}", match[1].str());
  if (std::regex_search(members, match, kPointer))
    return fmt::format("has a pointer: {}", match.str(0).substr(0, match.str(0).size() - 1));
  return "";
}

class DataCheck {
 public:
  DataCheck(const Project& project, Remarks* remarks) : remarks_(remarks) {
    for (const fs::path& file : FilesBelow(project.root)) {
      if (!IsSourceName(file) && !IsHeaderName(file)) continue;
      const std::string text = ReadText(file).value_or("");
      if (!files_.emplace(file, File{text, WithoutComments(text)}).second) continue;
      FindTypes(files_[file].code);
    }
  }

  void Run() {
    if (troubles_.empty()) return;
    for (const auto& [name, file] : files_) CheckCalls(name, file);
  }

 private:
  struct File {
    std::string text, code;
  };

  void FindTypes(const std::string& code) {
    static const std::regex kType("\\b(?:struct|class)[ \t\r\n]+(\\w+)[ \t\r\n]*(:[^;{()]*)?\\{");
    for (std::sregex_iterator it(code.begin(), code.end(), kType), end; it != end; ++it) {
      const size_t open = static_cast<size_t>(it->position(0) + it->length(0)) - 1;
      const size_t close = ClosingOf(code, open);
      if (close == std::string::npos) continue;
      const std::string name = (*it)[1];
      const std::string trouble = TroubleIn(MembersOf(code.substr(open + 1, close - open - 1)));
      // Removes the name from troubles_ if the program has two types of this name, because the
      // check does not know which of the two a call means.
      if (!seen_.insert(name).second) {
        troubles_.erase(name);
      } else if (!trouble.empty()) {
        troubles_[name] = trouble;
      }
    }
  }

  // Returns the type of the data in a call SetData(&variable, sizeof measured), if such data cannot
  // be sent (`troubles_`); "" for other types.  `measured` is the argument of sizeof: the name of a
  // type, or `variable` again.
  std::string TypeOf(const std::string& code, const std::string& variable,
                     const std::string& measured) const {
    if (troubles_.contains(measured)) return measured;
    for (const auto& [type, trouble] : troubles_) {
      const std::regex declared("\\b" + type + "[ \t]+" + variable + "[ \t]*[;=(]");
      if (std::regex_search(code, declared)) return type;
    }
    return "";
  }

  void CheckCalls(const std::string& name, const File& file) {
    static const std::regex kCall(
        "\\bSetData[ \t\r\n]*\\([ \t\r\n]*&[ \t]*(\\w+)[ \t\r\n]*,[ \t\r\n]*sizeof[ \t]*\\(?[ \t]*"
        "(\\w+)[ \t]*\\)?[ \t\r\n]*\\)");
    const std::string& code = file.code;
    for (std::sregex_iterator it(code.begin(), code.end(), kCall), end; it != end; ++it) {
      const std::string type = TypeOf(code, (*it)[1], (*it)[2]);
      if (type.empty()) continue;
      remarks_->Add(Remark::Kind::kWarning,
                    PlaceAt(name, file.text, static_cast<size_t>(it->position(0))),
                    fmt::format("{} {}; SetData() sends the bytes of it, and what they point to "
                                "is not there at the receiver: send plain values and arrays",
                                type, troubles_.at(type)));
    }
  }

  Remarks* const remarks_;
  std::map<std::string, File> files_;
  std::set<std::string> seen_;                   // names of all types found so far
  std::map<std::string, std::string> troubles_;  // reasons why a type cannot be sent, by its name
};

}  // namespace

void CheckSentData(const Project& project, Remarks* remarks) { DataCheck(project, remarks).Run(); }

}  // namespace openr_host
