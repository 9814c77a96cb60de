// The sources of a controller, read as text: which functions there are and who calls whom.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "kit/macro_text.h"
#include "runtime/config/diagnostic.h"

namespace openr_host {

struct CodeFile {
  std::string name;
  std::string source;
  ExpandedText code;
};

struct CodeFunction {
  std::string name;
  const CodeFile* file = nullptr;
  size_t begin = 0;  // of its body in the file's code: the opening bracket
  size_t end = 0;    // the closing one
};

// A call, or what looks like one, in a file's code.
struct CodeCall {
  std::string name;
  size_t at = 0;    // of the name
  size_t open = 0;  // of the bracket that follows
};

class ControllerCode {
 public:
  // With them go headers named in quotes that lie beside them.
  explicit ControllerCode(const std::vector<std::filesystem::path>& sources);
  ControllerCode(const ControllerCode&) = delete;
  ControllerCode& operator=(const ControllerCode&) = delete;

  const std::deque<CodeFile>& files() const { return files_; }
  const std::vector<CodeFunction>& functions() const { return functions_; }
  const MacroTable& macros() const { return macros_; }
  bool Defines(const std::string& function) const;
  bool Calls(const std::string& function) const;

  // The function that has this place in its body; nullptr: none.
  const CodeFunction* FunctionAt(const CodeFile& file, size_t at) const;

  // The calls between two places of a file's code.
  static std::vector<CodeCall> CallsIn(const std::string& code, size_t begin, size_t end);

  // The functions given to `registrar`, such as robot_run.
  std::set<std::string> GivenTo(const std::string& registrar) const;

  // `names` and what they call, directly or not.
  std::set<std::string> ReachedFrom(std::set<std::string> names) const;

  // `name` and the functions that call it, directly or not.
  std::set<std::string> LeadingTo(const std::string& name) const;

  static FilePosition PlaceOf(const CodeFile& file, size_t at);

  // The first argument of a call as it is written, a macro as what it stands for.
  std::string FirstArgument(const CodeFile& file, const CodeCall& call) const;

 private:
  void Read(const std::filesystem::path& file);
  void FindFunctions(const CodeFile& file);

  std::deque<CodeFile> files_;
  MacroTable macros_;
  std::vector<CodeFunction> functions_;
  std::map<std::string, std::set<std::string>> callees_;  // by function, and "" outside of any
};

}  // namespace openr_host
