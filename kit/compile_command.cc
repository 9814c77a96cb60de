#include "kit/compile_command.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <string_view>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool StartsWith(std::string_view text, std::string_view start) { return text.starts_with(start); }

std::string Extension(const std::string& file) {
  const size_t slash = file.rfind('/');
  const size_t dot = file.rfind('.');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  return file.substr(dot);
}

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsSource(const std::string& file) {
  return IsOneOf(Extension(file), {".cc", ".cpp", ".cxx", ".C", ".c", ".c++", ".cp", ".CPP", ".CC",
                                   ".ii", ".i", ".s", ".S"});
}

// Returns whether `flag` takes the next word of the command line as its value.
bool TakesNextWord(const std::string& flag) {
  return IsOneOf(flag, {"-o",
                        "-I",
                        "-L",
                        "-l",
                        "-D",
                        "-U",
                        "-x",
                        "-MF",
                        "-MT",
                        "-MQ",
                        "-include",
                        "-imacros",
                        "-isystem",
                        "-idirafter",
                        "-iprefix",
                        "-iwithprefix",
                        "-iwithprefixbefore",
                        "-Xlinker",
                        "-Xpreprocessor",
                        "-Xassembler",
                        "-u",
                        "--param",
                        "-aux-info"});
}

// Returns whether `flag`, a flag of a compile command for the robot, must not be passed to the
// host's compiler.  Such a flag is for the robot's processor (-mips3, -EL, -G0), or about something
// that the kit decides itself: warnings, the folders of headers, the language level, or how code is
// linked (-fPIC).
bool IsRobotFlag(const std::string& flag) {
  // Beginnings of flags that the host's compiler must not get.  For example, all flags for the
  // processor begin with -m.
  static const char* const kStarts[] = {"-m",    "-Werror", "-pedantic", "-fpic",   "-fPIC",
                                        "-fpie", "-fPIE",   "-fno-pic",  "-fno-PIC"};
  if (IsOneOf(flag, {"-EL", "-EB", "-ansi", "-Wno-return-type", "-nostdinc", "-nostdinc++", "-w",
                     "-static", "-non_shared", "-KPIC"})) {
    return true;
  }
  if (flag.size() > 2 && StartsWith(flag, "-G") &&
      std::all_of(flag.begin() + 2, flag.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return true;
  }
  return std::any_of(std::begin(kStarts), std::end(kStarts),
                     [&flag](const char* start) { return StartsWith(flag, start); });
}

// Replaces the old flags "-Ia -I- -Ib" by "-iquotea -Ib".  Folders before -I- were searched only
// for #include "...".  Today's flag with this meaning is -iquote.
void ModerniseIncludes(std::vector<std::string>* arguments) {
  const auto dash = std::find(arguments->begin(), arguments->end(), "-I-");
  if (dash == arguments->end()) return;
  for (auto it = arguments->begin(); it != dash; ++it) {
    if (StartsWith(*it, "-I")) *it = "-iquote" + it->substr(2);
  }
  arguments->erase(dash);
}

Language LanguageOf(const CompileCommand& command, const std::string& given, bool is_cxx) {
  if (!given.empty()) return given == "c++" ? Language::kCxx : Language::kC;
  if (is_cxx) return Language::kCxx;
  const auto is_c = [](const std::string& file) {
    return IsOneOf(Extension(file), {".c", ".i", ".s", ".S"});
  };
  return std::all_of(command.sources.begin(), command.sources.end(), is_c) ? Language::kC
                                                                           : Language::kCxx;
}

// Returns the flags for `name`, the value of a -std flag such as "c99"; no flags if `name` is a
// standard of another language than `language`.  A strict standard such as c99 is replaced by the
// standard with GNU extensions, gnu99, because the host's headers hide some functions in a strict
// standard.  The headers of the SDK's compiler declared the same functions in both standards.  C99
// gets -fgnu89-inline, because gcc took `inline` in the meaning of GNU C until version 4.3.
std::vector<std::string> StandardFlags(const std::string& name, Language language) {
  const bool is_cxx = name.find("++") != std::string::npos;
  if (name.empty() || is_cxx != (language == Language::kCxx)) return {};
  if (is_cxx) return {"-std=" + (IsOneOf(name, {"c++98", "c++03"}) ? "gnu++98" : name)};
  if (IsOneOf(name, {"c89", "c90", "iso9899:1990", "iso9899:199409"})) return {"-std=gnu89"};
  if (IsOneOf(name, {"c99", "c9x", "gnu99", "gnu9x", "iso9899:1999", "iso9899:199x"}))
    return {"-std=gnu99", "-fgnu89-inline"};
  return {"-std=" + name};
}

}  // namespace

CompileCommand TranslateCompile(const std::vector<std::string>& arguments, bool is_cxx) {
  CompileCommand command;
  std::string language, standard;
  bool asks = false;  // true: the command only preprocesses, or prints its version or the like
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const bool has_next = i + 1 < arguments.size();
    if (word == "-w") command.is_quiet = true;
    // Skips a flag that is about the robot's compiler or processor, and its value, which would
    // otherwise count as a file.
    if (word == "-G" || word == "-V" || word == "-b") {
      i += has_next;
    } else if (StartsWith(word, "-std=")) {
      standard = word.substr(5);
    } else if (IsRobotFlag(word)) {
      continue;
    } else if (TakesNextWord(word) && has_next) {
      const std::string& value = arguments[++i];
      if (word == "-o") command.output = value;
      if (word == "-x") language = value;
      command.arguments.insert(command.arguments.end(), {word, value});
    } else {
      if (word.size() > 2 && StartsWith(word, "-o")) command.output = word.substr(2);
      if (word == "-c" || word == "-S") command.compiles = true;
      asks = asks || IsOneOf(word, {"-E", "-M", "-MM", "--version", "-v", "--help"}) ||
             StartsWith(word, "-print") || StartsWith(word, "-dump");
      if (word[0] != '-' && IsSource(word)) command.sources.push_back(word);
      command.arguments.push_back(word);
    }
  }
  ModerniseIncludes(&command.arguments);
  command.language = LanguageOf(command, language, is_cxx);
  // Adds the language standard (-std) only now, because the names of the sources may decide whether
  // they are C or C++.
  const std::vector<std::string> level = StandardFlags(standard, command.language);
  command.arguments.insert(command.arguments.end(), level.begin(), level.end());
  command.links = !command.compiles && !asks;
  if (asks) command.compiles = false;
  return command;
}

std::vector<std::string> CarriedFlags(const std::vector<std::string>& arguments,
                                      const std::string& folder) {
  const auto absolute = [&folder](const std::string& path) {
    const fs::path whole = (fs::path(folder) / path).lexically_normal();
    // Removes the slash at the end of a folder's name, so that "a" and "a/" are one folder.
    return (whole.has_filename() ? whole : whole.parent_path()).string();
  };
  std::vector<std::string> flags;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const bool has_next = i + 1 < arguments.size();
    if (IsOneOf(word, {"-include", "-imacros", "-isystem", "-idirafter", "-iquote"}) && has_next) {
      // The compiler looks for a file of -include in the folders of -I, too.  So a name stays
      // relative if `folder` has no such file.
      const std::string there = absolute(arguments[++i]);
      flags.insert(flags.end(), {word, fs::exists(there) ? there : arguments[i]});
    } else if (IsOneOf(word, {"-D", "-U", "-I"}) && has_next) {
      flags.push_back(word + (word == "-I" ? absolute(arguments[i + 1]) : arguments[i + 1]));
      ++i;
    } else if (StartsWith(word, "-I") && word != "-I-" && word.size() > 2) {
      flags.push_back("-I" + absolute(word.substr(2)));
    } else if ((StartsWith(word, "-D") || StartsWith(word, "-U")) && word.size() > 2) {
      flags.push_back(word);
    } else if (StartsWith(word, "-std=") ||
               IsOneOf(word, {"-funsigned-char", "-fpack-struct", "-fshort-enums"})) {
      flags.push_back(word);
    } else if (TakesNextWord(word)) {
      ++i;
    }
  }
  return flags;
}

std::vector<std::string> UnknownFlags(const std::string& output) {
  static const std::regex kUnknownFlag(
      "(?:unrecognized command[- ]line option|unknown argument:|unknown warning option) "
      "[`'\"]?(-[^'\"\\s,;]+)");
  std::vector<std::string> flags;
  for (std::sregex_iterator it(output.begin(), output.end(), kUnknownFlag), end; it != end; ++it) {
    flags.push_back((*it)[1]);
  }
  return flags;
}

bool TellsOfMissingReturn(const std::string& output) {
  return output.find("[-Wreturn-type]") != std::string::npos;
}

}  // namespace openr_host
