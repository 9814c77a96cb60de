#include "kit/asm_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "kit/source_text.h"

namespace openr_host {
namespace {

constexpr char kStopsNote[] =
    "assembly for the robot's processor left out; the object stops with a trap where it is reached";

// A use of the word asm in a source, with the brackets after it.
struct AsmUse {
  size_t begin = 0;             // position of the word asm
  size_t end = 0;               // position after the closing bracket
  bool is_in_function = false;  // false: the statement is outside of functions
  // True: asm gives a variable a register, as in register int x asm("$4").
  bool names_register = false;
};

// Returns whether `brace` opens a block of declarations, such as extern "C" { or namespace x {, and
// not the body of a function.
bool IsOuterBlock(const std::string& code, size_t brace) {
  static const std::regex kHead("(^|[^\\w])(extern|namespace(\\s+\\w+)?)\\s*$");
  const size_t begin = brace < 80 ? 0 : brace - 80;
  return std::regex_search(code.substr(begin, brace - begin), kHead);
}

// Returns the position of the opening bracket after the word asm and its qualifiers, or kNone.
size_t OpeningOf(const std::string& code, size_t word_end) {
  static const std::set<std::string_view> kQualifiers = {"volatile", "__volatile__", "__volatile",
                                                         "goto", "inline"};
  size_t at = NextOf(code, word_end);
  while (at != kNone && code[at] != '(') {
    const std::string_view word = WordAt(code, at);
    if (!kQualifiers.contains(word)) return kNone;
    at = NextOf(code, at + word.size());
  }
  return at;
}

// Returns whether an asm gives a variable its register, as in `register int x asm("$4");`.  In such
// a declaration, a name stands before the word asm, and ';', '=' or ',' follows the brackets.
// `previous` is the position before the word asm, `next` the position after the brackets.
bool NamesRegister(const std::string& code, size_t previous, size_t next) {
  if (previous == kNone || !IsWordCharacter(code[previous])) return false;
  if (next == kNone || std::string_view(";=,").find(code[next]) == kNone) return false;
  const size_t line = code.rfind('\n', previous);
  if (code[NextOf(code, line == kNone ? 0 : line)] == '#')
    return false;  // in a directive such as #define, the name before asm is no variable
  size_t begin = previous;
  while (begin > 0 && IsWordCharacter(code[begin - 1])) --begin;
  const std::string_view before = WordAt(code, begin);
  // After "else" or "do", an asm is a statement and gives no variable a register.  So these two
  // words are not taken for the name of a variable.
  return before != "else" && before != "do";
}

std::vector<AsmUse> FindAsmUses(const std::string& code) {
  std::vector<AsmUse> uses;
  std::vector<bool> is_outer;  // value of IsOuterBlock() for each block that is open at `at`
  for (size_t at = 0; at < code.size(); ++at) {
    if (code[at] == '{') is_outer.push_back(IsOuterBlock(code, at));
    if (code[at] == '}' && !is_outer.empty()) is_outer.pop_back();
    const bool starts_word =
        IsWordCharacter(code[at]) && (at == 0 || !IsWordCharacter(code[at - 1]));
    if (!starts_word) continue;
    const std::string_view word = WordAt(code, at);
    if (word != "asm" && word != "__asm__" && word != "__asm") continue;
    const size_t open = OpeningOf(code, at + word.size());
    const size_t close = open == kNone ? kNone : ClosingOf(code, open);
    if (close == kNone) continue;
    AsmUse use{at, close + 1, false, false};
    use.is_in_function = std::find(is_outer.begin(), is_outer.end(), false) != is_outer.end();
    use.names_register = NamesRegister(code, PreviousOf(code, at), NextOf(code, use.end));
    uses.push_back(use);
    at = close;
  }
  return uses;
}

// Returns the instructions of an asm statement, which are its quoted text before the first colon.
std::string TemplateOf(std::string_view statement) {
  std::string text;
  bool is_quoted = false;
  for (size_t i = 0; i < statement.size(); ++i) {
    if (is_quoted && statement[i] == '\\' && i + 1 < statement.size()) {
      ++i;
      text += statement[i] == 'n' ? '\n' : ' ';
    } else if (statement[i] == '"') {
      is_quoted = !is_quoted;
    } else if (is_quoted) {
      text += statement[i];
    } else if (statement[i] == ':') {
      break;
    }
  }
  return text;
}

// Returns whether the program behaves the same without the instructions in `assembly`, because they
// only wait or order memory accesses.
bool HasNoEffect(const std::string& assembly) {
  static const std::regex kInstruction("(?:^|[\n;])[ \t]*([.\\w]+)[^\n;]*");
  static const std::set<std::string> kHarmless = {"nop", "ssnop", "ehb", "sync", ".set"};
  for (std::sregex_iterator it(assembly.begin(), assembly.end(), kInstruction), end; it != end;
       ++it)
    if (!kHarmless.contains((*it)[1])) return false;
  return true;
}

// Returns `replacement` with as many line ends as the text `replaced` has, so that the lines after
// the replaced text keep their numbers.
std::string WithLineEnds(std::string replacement, std::string_view replaced) {
  for (size_t i = 0; i < replaced.size(); ++i) {
    if (replaced[i] != '\n') continue;
    const size_t back = i > 0 && replaced[i - 1] == '\r' ? 2 : 1;
    // Ends the line of `replacement` in a backslash if the replaced line ended in a backslash,
    // because each line of a macro but the last must end in a backslash.
    const bool goes_on = i >= back && replaced[i - back] == '\\';
    replacement += goes_on ? " \\\n" : "\n";
  }
  return replacement;
}

Edit EditOf(const AsmUse& use, const std::string& text) {
  const std::string_view whole = std::string_view(text).substr(use.begin, use.end - use.begin);
  if (use.names_register)
    return {use.begin, use.end, WithLineEnds("", whole),
            "the register of the robot's processor left out of a declaration"};
  if (!use.is_in_function)
    return {use.begin, use.end, WithLineEnds("", whole),
            "assembly outside of functions left out: it is for the robot's processor"};
  if (HasNoEffect(TemplateOf(whole)))
    return {use.begin, use.end, WithLineEnds("__sync_synchronize()", whole),
            "nop or sync of the robot's processor became a barrier"};
  return {use.begin, use.end, WithLineEnds("__builtin_trap()", whole), kStopsNote};
}

int LineOf(const std::string& text, size_t at) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')) + 1;
}

// Returns the last line that a message of the assembler about the asm statement `use` may name.
// This line may be after the end of the statement, because the assembler counts each "\n" in the
// statement's text as a new line too.
int LastLineOf(const AsmUse& use, const std::string& text) {
  const std::string assembly =
      TemplateOf(std::string_view(text).substr(use.begin, use.end - use.begin));
  return LineOf(text, use.end) +
         static_cast<int>(std::count(assembly.begin(), assembly.end(), '\n'));
}

std::string LineText(const std::string& text, int line) {
  const size_t begin = OffsetOf(text, line, 1);
  return begin == kNone ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

bool IsAboutAssembly(const CompilerError& error) {
  const std::string& message = error.message;
  return message.starts_with(kAssemblerSays) || message.find("'asm'") != std::string::npos ||
         message.find("invalid register name for") != std::string::npos ||
         message.find("not specified for") != std::string::npos;
}

std::vector<Edit> AssemblyRepairOf(const CompilerError& error, const std::string& text) {
  if (!IsAboutAssembly(error)) return {};
  const std::vector<AsmUse> uses = FindAsmUses(WithoutComments(text));
  std::vector<Edit> edits;
  if (error.line == 0) {
    for (const AsmUse& use : uses)
      if (!use.is_in_function && !use.names_register) edits.push_back(EditOf(use, text));
    return edits;
  }
  const bool wants_register = error.message.find("invalid register name") != std::string::npos;
  // Starts the search at the last asm statement, because the line of the error may belong to two
  // statements (LastLineOf()).  The later of the two is then the likely cause of the error.
  for (auto use = uses.rbegin(); use != uses.rend(); ++use) {
    if (use->names_register != wants_register) continue;
    if (LineOf(text, use->begin) > error.line || LastLineOf(*use, text) < error.line) continue;
    return {EditOf(*use, text)};
  }
  return AssemblyMacroRepairOf(LineText(text, error.line), text);
}

std::vector<Edit> AssemblyMacroRepairOf(const std::string& line, const std::string& header) {
  const std::string code = WithoutComments(header);
  std::vector<Edit> edits;
  for (AsmUse use : FindAsmUses(code)) {
    // Moves `begin` back to the first line of the macro.  All lines of a macro except the last end
    // in a backslash, so the loop goes on while the previous line ends in a backslash.
    size_t begin = code.rfind('\n', use.begin);
    while (begin != kNone && begin > 0 && code[begin - 1] == '\\')
      begin = code.rfind('\n', begin - 1);
    static const std::regex kDefine("^\\s*#\\s*define\\s+(\\w+)");
    std::smatch match;
    const std::string head = code.substr(begin == kNone ? 0 : begin, use.begin - begin);
    if (!std::regex_search(head, match, kDefine)) continue;
    const std::string name = match[1];
    for (size_t at = line.find(name); at != kNone; at = line.find(name, at + 1)) {
      if (!HasWordAt(line, at, name)) continue;
      // Treats this assembly as code inside a function, so that it becomes a trap or a barrier.  A
      // macro is defined outside of functions, but functions use its assembly.
      use.is_in_function = true;
      use.names_register = false;
      edits.push_back(EditOf(use, header));
      break;
    }
  }
  return edits;
}

}  // namespace openr_host
