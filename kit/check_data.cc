#include "kit/check_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "kit/source_place.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Returns the text that declares the members of a type.  `body` is the text between the braces of a
// struct or class.  Leaves out the bodies of functions and the text in round brackets.  Keeps the
// opening round bracket, because SendProblem() recognises a function, such as char* Name(), by it.
// Puts no blanks in place of what is left out: SendProblem() searches with std::regex_search(),
// which calls itself for each blank, so the blanks of a long body would overflow the stack.
std::string MembersOf(const std::string& body) {
  std::string members;
  for (size_t at = 0; at < body.size(); ++at) {
    members += body[at] == '{' ? ' ' : body[at];
    if (body[at] == '{' || body[at] == '(') at = std::min(ClosingOf(body, at), body.size() - 1);
  }
  return members;
}

// Returns `code` with one character in place of each run of blanks and line ends, because
// std::regex_search() calls itself for each blank, and the blanks that WithoutComments() puts in
// place of a long comment would overflow the stack.
std::string WithShortBlanks(const std::string& code) {
  std::string result;
  bool is_in_run = false;
  for (const char c : code) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!is_blank || !is_in_run) {
      result += is_blank && c != '\n' ? ' ' : c;
    } else if (c == '\n') {
      result.back() = '\n';  // keeps a line end, beyond which a pattern for one line cannot match
    }
    is_in_run = is_blank;
  }
  return result;
}

// Returns the reason why values of a type cannot be sent as bytes; "" if such values can be sent.
// `members` is the text of the type's members.
std::string SendProblem(const std::string& members) {
  static const std::regex kContainer(
      "\\b(string|vector|list|deque|map|multimap|set|multiset|queue|stack)\\b[ \t]*(<[^;]*>)?"
      "[ \t]+(?!operator\\b)\\w+[ \t]*[;,\\[]");
  static const std::regex kPointer("\\b\\w+[ \t]*\\*[ \t*]*(?!operator\\b)\\w+[ \t]*[;\\[]");
  static const std::regex kVirtual("\\bvirtual\\b");
  std::smatch match;
  if (std::regex_search(members, match, kVirtual)) return "has virtual functions";
  if (std::regex_search(members, match, kContainer))
    return fmt::format("has a member of type {}", match[1].str());
  if (std::regex_search(members, match, kPointer))
    return fmt::format("has a pointer: {}", match.str(0).substr(0, match.str(0).size() - 1));
  return "";
}

// A struct or class of the program.
struct DataType {
  std::vector<std::string> bases;
  std::vector<std::string> virtual_functions;  // names of functions that the type itself declares
};

// Returns all words in the list of base classes `text`, such as ": public Base".  These are names
// of classes and words such as "public", which do no harm because no type has such a name.
std::vector<std::string> WordsOf(const std::string& text) {
  static const std::regex kWord("\\w+");
  std::vector<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), kWord), end; it != end; ++it)
    words.push_back(it->str());
  return words;
}

// Returns the names of the virtual functions, except the destructor, that `body` declares.
std::vector<std::string> VirtualFunctionsIn(const std::string& body) {
  static const std::regex kVirtual("\\bvirtual\\b[^;{}()~]{1,200}?\\b(\\w+)[ \t\r\n]*\\(");
  std::vector<std::string> names;
  for (std::sregex_iterator it(body.begin(), body.end(), kVirtual), end; it != end; ++it)
    names.push_back((*it)[1]);
  return names;
}

class DataCheck {
 public:
  DataCheck(const Project& project, Remarks* remarks) : remarks_(remarks) {
    for (const fs::path& file : FilesBelow(project.root)) {
      if (!IsSourceName(file) && !IsHeaderName(file)) continue;
      const std::string text = ReadText(file).value_or("");
      if (!files_.emplace(file, File{text, WithoutComments(text)}).second) continue;
      FindTypes(WithShortBlanks(files_[file].code));
    }
  }

  void Run() {
    if (problems_.empty()) return;
    for (const auto& [name, file] : files_) {
      CheckCalls(name, file);
      CheckRegions(name, file);
    }
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
      const std::string body = code.substr(open + 1, close - open - 1);
      const std::string problem = SendProblem(MembersOf(body));
      // Removes a name from types_ and problems_ if the program has two types of this name, because
      // the check cannot tell which of the two types a call of SetData() sends.
      if (!seen_.insert(name).second) {
        types_.erase(name);
        problems_.erase(name);
        continue;
      }
      types_[name] = {WordsOf((*it)[2]), VirtualFunctionsIn(body)};
      if (!problem.empty()) problems_[name] = problem;
    }
  }

  // Adds to `*line` the class `name` and its direct and indirect base classes.  Leaves out classes
  // that the program does not define.
  void AddWithBases(const std::string& name, std::vector<std::string>* line) const {
    const auto type = types_.find(name);
    if (type == types_.end() || std::find(line->begin(), line->end(), name) != line->end()) return;
    line->push_back(name);
    for (const std::string& base : type->second.bases) AddWithBases(base, line);
  }

  // Returns the name of the type that the call SetData(&variable, sizeof measured) sends, if the
  // table problems_ says that data of this type cannot be sent; else "".  `measured` is the
  // argument of sizeof: the name of a type, or `variable` again.
  std::string TypeOf(const std::string& code, const std::string& variable,
                     const std::string& measured) const {
    if (problems_.contains(measured)) return measured;
    for (const auto& [type, problem] : problems_) {
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
                                type, problems_.at(type)));
    }
  }

  // Warns of code such as new (region->Base()) Type, which makes an instance of a class with
  // virtual functions in a region.  Warns only if the region is sent, and if an OPEN-R object of
  // another folder calls a virtual function of the instance.  On the robot this call crashes,
  // because the table of virtual functions is in the image of the sender.
  void CheckRegions(const std::string& name, const File& file) {
    static const std::regex kPlaced(
        "\\bnew[ \t]*\\([ \t]*(?:\\([ \t]*void[ \t]*\\*[ \t]*\\)[ \t]*)?(\\w+)[^;]{0,80}?"
        "(?:->|\\.)[ \t]*Base[ \t]*\\([ \t]*\\)[ \t]*\\)[ \t\r\n]*(\\w+)");
    const std::string& code = file.code;
    for (std::sregex_iterator it(code.begin(), code.end(), kPlaced), end; it != end; ++it) {
      const std::regex sent("\\bSetData[ \t]*\\(" + kPartOfStatement + "\\b" + (*it)[1].str() +
                            "\\b");
      const std::string type = (*it)[2];
      if (!types_.contains(type) || !std::regex_search(code, sent)) continue;
      const std::string call = VirtualCallOf(type, name);
      if (call.empty()) continue;
      remarks_->Add(Remark::Kind::kWarning,
                    PlaceAt(name, file.text, static_cast<size_t>(it->position(0))),
                    fmt::format("{} has virtual functions, and {}; the table of them is in the "
                                "sender's image, so that call crashes on the robot: send plain "
                                "values and arrays",
                                type, call));
    }
  }

  // Looks for a file in which received data are used as a `type`, or as a base class of `type`, and
  // which calls a virtual function of these data.  Returns a text for users that names the file and
  // the function; "" if there is no such file.  Ignores files in the folder of `sender`, since an
  // object that is loaded twice from one image can call the functions (field-notes.md, 2.7).
  std::string VirtualCallOf(const std::string& type, const fs::path& sender) const {
    std::vector<std::string> types, functions;
    AddWithBases(type, &types);
    for (const std::string& name : types) {
      const std::vector<std::string>& own = types_.at(name).virtual_functions;
      functions.insert(functions.end(), own.begin(), own.end());
    }
    for (const auto& [name, file] : files_) {
      if (fs::path(name).parent_path() == sender.parent_path()) continue;
      for (const std::string& function : functions) {
        if (CallsOfData(file.code, types, function))
          return fmt::format("{} calls {}() of received data", fs::path(name).filename().string(),
                             function);
      }
    }
    return "";
  }

  // Returns whether `code` converts received data to a pointer to one of `types`, and calls
  // `function` through this pointer: ((Shape*)event.Data(0))->Area(), or shape->Area() after shape
  // = (Shape*)event.Data(0).
  static bool CallsOfData(const std::string& code, const std::vector<std::string>& types,
                          const std::string& function) {
    return std::any_of(types.begin(), types.end(), [&](const std::string& type) {
      if (!HasWord(code, type)) return false;
      const std::string data = "\\b" + type + "\\b[ \t]*(?:const[ \t]*)?\\*" + kPartOfStatement +
                               "\\b(?:Data|RCData)[ \t]*\\(";
      const std::string call = "[ \t]*->[ \t]*" + function + "[ \t]*\\(";
      if (std::regex_search(code, std::regex(data + kPartOfStatement + call))) return true;
      const std::regex assigned("\\b(\\w+)[ \t]*=" + kPartOfStatement + data);
      for (std::sregex_iterator it(code.begin(), code.end(), assigned), end; it != end; ++it) {
        if (std::regex_search(code, std::regex("\\b" + (*it)[1].str() + call))) return true;
      }
      return false;
    });
  }

  Remarks* const remarks_;
  std::map<std::string, File> files_;
  std::map<std::string, DataType> types_;
  std::set<std::string> seen_;                   // names of all types found so far
  std::map<std::string, std::string> problems_;  // for each type that cannot be sent: the reason
};

}  // namespace

void CheckSentData(const Project& project, Remarks* remarks) { DataCheck(project, remarks).Run(); }

}  // namespace openr_host
