// Finds the functions in the sources of a controller, and the functions that each of them calls.
// Reads only the text and does not run the compiler.
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
  size_t begin = 0;  // position of the bracket that opens the body, in the file's code
  size_t end = 0;    // position of the bracket that closes the body
};

// A call of a function in a file's code, or another word with a bracket after it, such as the name
// of a function in its definition.
struct CodeCall {
  std::string name;
  size_t at = 0;    // position of the name
  size_t open = 0;  // position of the bracket after the name
};

class ControllerCode {
 public:
  // Reads `sources`, and the headers in the same folders that these sources include with quotes.
  explicit ControllerCode(const std::vector<std::filesystem::path>& sources);
  ControllerCode(const ControllerCode&) = delete;
  ControllerCode& operator=(const ControllerCode&) = delete;

  const std::deque<CodeFile>& files() const { return files_; }
  const std::vector<CodeFunction>& functions() const { return functions_; }
  const MacroTable& macros() const { return macros_; }
  bool Defines(const std::string& function) const;
  bool Calls(const std::string& function) const;

  // Returns the function whose body contains the position `at`; null if there is no such function.
  const CodeFunction* FunctionAt(const CodeFile& file, size_t at) const;

  // Returns the calls between the positions `begin` and `end` of a file's code.
  static std::vector<CodeCall> CallsIn(const std::string& code, size_t begin, size_t end);

  // Returns the names of the functions that the controller passes to the function `registrar`, such
  // as robot_run.
  std::set<std::string> FunctionsPassedTo(const std::string& registrar) const;

  // Returns `names` and the names of all functions that these call, directly or not.
  std::set<std::string> ReachedFrom(std::set<std::string> names) const;

  // Returns `name` and the names of all functions that call this function, directly or not.
  std::set<std::string> CallersOf(const std::string& name) const;

  static FilePosition PlaceOf(const CodeFile& file, size_t at);

  // Returns the text of the source from the first argument of the call to the end of the file.  If
  // the argument is an identifier, returns instead the text of the macro with this name, or "" if
  // there is no such macro.
  std::string FirstArgument(const CodeFile& file, const CodeCall& call) const;

 private:
  void Read(const std::filesystem::path& file);
  void FindFunctions(const CodeFile& file);

  std::deque<CodeFile> files_;
  MacroTable macros_;
  std::vector<CodeFunction> functions_;
  // The names of called functions, by the name of the caller; "" stands for code outside of
  // functions.
  std::map<std::string, std::set<std::string>> callees_;
};

}  // namespace openr_host
