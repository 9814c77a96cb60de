#include "openr/commands/completion_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace openr_host {
namespace {

using Value = OptionInfo::Value;

// The beginning of the script by which bash completes the words of a command line of openr.  This
// part of the script finds out which command stands before the word to complete.  BashCompletion()
// puts the names of all commands between kBegin and kAfterCommands.  The words after `help` are
// completed as if `help` were not there: `help run` like `run`.
constexpr char kBegin[] = R"(# Completion of openr for bash; made by: openr completion bash
_openr() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} path=openr i given=()
  COMPREPLY=()
  # bash takes '=' for a word of its own: --robot=ers7.
  [ "$cur" = = ] && cur=
  [ "$prev" = = ] && prev=${COMP_WORDS[COMP_CWORD-2]}
  for ((i = 1; i < COMP_CWORD; i++)); do
    [ "$path ${COMP_WORDS[i]}" = "openr help" ] && continue
    case "$path ${COMP_WORDS[i]}" in
      )";

constexpr char kAfterCommands[] = R"()
        path+=" ${COMP_WORDS[i]}"; given=() ;;
      *)
        # Collects the words after the command, without flags and their values.
        # --flag=value is three words for bash.
        [[ ${COMP_WORDS[i]} == [-=]* || ${COMP_WORDS[i-1]} == [-=]* ]] || given+=("${COMP_WORDS[i]}") ;;
    esac
  done
  case "$path $prev" in
)";

constexpr char kBetween[] = R"(  esac
  local words= kind=
  case "$path" in
)";

constexpr char kEnd[] = R"(  esac
  if [[ $cur == -* ]]; then
    COMPREPLY=($(compgen -W "${words#*|}" -- "$cur"))
    return
  fi
  COMPREPLY=($(compgen -W "${words%%|*}" -- "$cur"))
  [ -n "$kind" ] && _openr_files "$kind"
}

# Adds files (-f) or folders (-d); their names may have blanks.
_openr_files() {
  local line
  while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$1" -- "$cur")
  compopt -o filenames 2>/dev/null
}

complete -F _openr openr
)";

void AddPaths(const CommandInfo& command, std::vector<std::string>* patterns) {
  for (const CommandInfo& below : command.commands) {
    patterns->push_back(fmt::format("'{}'", below.path));
    AddPaths(below, patterns);
  }
}

// Returns the argument of _openr_files, the function of the bash script that completes names of
// files, for an option whose value has the kind `value`: "-d" for a folder, "-f" for a file or a
// world.  Returns "" for all other kinds, because their values are not names of files.
const char* FileKindOf(Value value) {
  if (value == Value::kFolder) return "-d";
  return value == Value::kFile || value == Value::kWorld ? "-f" : "";
}

// Returns the words that an option may have as its value.
std::vector<std::string> WordsFor(const OptionInfo& option, const DataNames& names) {
  if (option.value == Value::kJoint) return names.joints;
  if (option.value == Value::kModel) return names.models;
  if (option.value == Value::kWorld) return names.worlds;
  return option.choices;
}

// Adds to the bash script, for each flag with a value, a pattern of the shell's `case` statement.
// The code after the pattern completes the words that can follow the flag.
void AddValues(const CommandInfo& command, const DataNames& names, std::string* script) {
  for (const OptionInfo& option : command.options) {
    if (option.value == Value::kNone) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names)
      patterns.push_back(fmt::format("'{} {}'", command.path, name));
    std::string action;
    if (const std::vector<std::string> words = WordsFor(option, names); !words.empty()) {
      action = fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\")); ", fmt::join(words, " "));
    }
    if (*FileKindOf(option.value) != '\0')
      action += fmt::format("_openr_files {}; ", FileKindOf(option.value));
    *script += fmt::format("    {}) {}return ;;\n", fmt::join(patterns, "|"), action);
  }
  for (const CommandInfo& below : command.commands) AddValues(below, names, script);
}

// Adds to the bash script the code that completes an input, such as "press chin".  The input begins
// after `place` words of the command line.
void AddInputs(const std::vector<InputInfo>& inputs, size_t place, std::string* script) {
  std::string kinds, cases;
  for (const InputInfo& input : inputs) {
    kinds += (kinds.empty() ? "" : " ") + input.kind;
    cases += fmt::format("        {}) words='{}|' ;;\n", input.kind, fmt::join(input.words, " "));
  }
  *script += fmt::format(
      "\n      [ ${{#given[@]}} -eq {} ] && words='{}|'\n"
      "      [ ${{#given[@]}} -gt {} ] && case ${{given[{}]}} in\n{}        *) words='|' ;;\n"
      "      esac ",
      place, kinds, place, place, cases);
}

// Adds to the bash script, for each command, a pattern of the shell's `case` statement.  The code
// after the pattern sets `words` to the words that may come next, then '|', then the flags of the
// command.  The code also sets `kind`, which says whether file or folder names may come next.
void AddWords(const CommandInfo& command, const DataNames& names, std::string* script) {
  std::vector<std::string> words, flags;
  for (const CommandInfo& below : command.commands) words.push_back(below.name);
  std::string kind;
  for (const OptionInfo& positional : command.positionals) {
    for (std::string& word : WordsFor(positional, names)) words.push_back(std::move(word));
    if (kind.empty()) kind = FileKindOf(positional.value);
  }
  for (const OptionInfo& option : command.options)
    flags.insert(flags.end(), option.names.begin(), option.names.end());
  *script += fmt::format("    '{}') words='{}|{}' kind={} ", command.path, fmt::join(words, " "),
                         fmt::join(flags, " "), kind);
  if (command.takes_input) AddInputs(names.inputs, command.positionals.size(), script);
  *script += ";;\n";
  for (const CommandInfo& below : command.commands) AddWords(below, names, script);
}

}  // namespace

std::string BashCompletion(const CommandInfo& program, const DataNames& names) {
  std::vector<std::string> patterns;
  AddPaths(program, &patterns);
  std::string script = kBegin + fmt::format("{}", fmt::join(patterns, "|")) + kAfterCommands;
  AddValues(program, names, &script);
  script += kBetween;
  AddWords(program, names, &script);
  return script + kEnd;
}

}  // namespace openr_host
