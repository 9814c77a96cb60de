#include "kit/link_command.h"

#include <algorithm>
#include <regex>

namespace openr_host {
namespace {

// Returns X, the value of the flag `arguments[*i]`, which is written "-oX" or "-o X".  In the
// second case, sets `*i` to the index of X, so that the caller does not take X for a further
// argument.
std::string ValueOf(const std::vector<std::string>& arguments, size_t* i) {
  const std::string& word = arguments[*i];
  if (word.size() > 2) return word.substr(2);
  return *i + 1 < arguments.size() ? arguments[++*i] : "";
}

}  // namespace

LinkCommand TranslateMkbin(const std::vector<std::string>& arguments,
                           const std::function<bool(const std::string&)>& exists) {
  LinkCommand command;
  std::vector<std::string> folders;
  std::vector<std::string> wanted;  // names of libraries, given by -l
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "-v") {
      command.is_verbose = true;
    } else if (word.starts_with("-o")) {
      command.output = ValueOf(arguments, &i);
    } else if (word.starts_with("-m")) {
      command.map = ValueOf(arguments, &i);
    } else if (word.starts_with("-L")) {
      folders.push_back(ValueOf(arguments, &i));
    } else if (word.starts_with("-l")) {
      wanted.push_back(ValueOf(arguments, &i));
    } else if (word == "-p") {
      // Skips the value of -p, the folder of the SDK, because the host's linker does not need it.
      ValueOf(arguments, &i);
    } else if (word.ends_with(".ocf")) {
      command.ocf = word;
    } else if (word.ends_with(".a")) {
      command.libraries.push_back(word);
    } else if (!word.empty() && word[0] != '-') {
      command.objects.push_back(word);
    }
  }
  // Looks for the libraries after all arguments are read, because a folder (-L) may come after a
  // library (-l).
  for (const std::string& name : wanted) {
    for (const std::string& folder : folders) {
      const std::string file = folder + "/lib" + name + ".a";
      if (!exists(file)) continue;
      command.libraries.push_back(file);
      break;
    }
  }
  return command;
}

std::vector<std::string> UndefinedNames(const std::string& output) {
  static const std::regex kUndefinedName("undefined reference to [`']([^'\n]+)'");
  std::vector<std::string> names;
  for (std::sregex_iterator it(output.begin(), output.end(), kUndefinedName), end; it != end;
       ++it) {
    const std::string name = (*it)[1];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace openr_host
