#include "openr/kit/compile_command.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <string_view>

namespace openr_host {
namespace {

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

// Flags whose value is the next word.
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

// Flags for the robot, and flags the kit decides about.
bool IsRobotFlag(const std::string& flag) {
  // Everything about the processor begins with -m.
  static const char* const kStarts[] = {"-m",    "-std=", "-Werror", "-pedantic", "-fpic",
                                        "-fPIC", "-fpie", "-fPIE",   "-fno-pic",  "-fno-PIC"};
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

// "-Ia -I- -Ib" of old: folders before it are for #include "..." only.
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

}  // namespace

CompileCommand TranslateCompile(const std::vector<std::string>& arguments, bool is_cxx) {
  CompileCommand command;
  std::string language;
  bool asks = false;  // for the version, or only preprocesses
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const bool has_next = i + 1 < arguments.size();
    if (word == "-w") command.is_quiet = true;
    if (word == "-G" || word == "-V" || word == "-b") {
      i += has_next;
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
  command.links = !command.compiles && !asks;
  if (asks) command.compiles = false;
  return command;
}

std::vector<std::string> UnknownFlags(const std::string& output) {
  static const std::regex kComplaint(
      "(?:unrecognized command[- ]line option|unknown argument:|unknown warning option) "
      "[`'\"]?(-[^'\"\\s,;]+)");
  std::vector<std::string> flags;
  for (std::sregex_iterator it(output.begin(), output.end(), kComplaint), end; it != end; ++it) {
    flags.push_back((*it)[1]);
  }
  return flags;
}

bool TellsOfMissingReturn(const std::string& output) {
  return output.find("[-Wreturn-type]") != std::string::npos;
}

}  // namespace openr_host
