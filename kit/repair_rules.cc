#include "kit/repair_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>

#include "kit/asm_repair.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

using Edits = std::vector<Edit>;

// An error message of the compiler, with the text of the file that the message is about.
struct ErrorPlace {
  const CompilerError& error;
  const std::string& text;
  const std::string code;  // text without comments and strings
  const size_t at;         // position that the message names, as an offset in `text`

  bool MessageHas(const char* words) const { return error.message.find(words) != kNone; }

  // Returns the text in the n-th pair of single quotes of the message, counted from 1.
  std::string Quoted(int n = 1) const {
    size_t end = kNone, begin = kNone;
    for (int i = 0; i < n; ++i) {
      begin = error.message.find('\'', end + 1);
      end = begin == kNone ? kNone : error.message.find('\'', begin + 1);
      if (end == kNone) return "";
    }
    return error.message.substr(begin + 1, end - begin - 1);
  }
};

// Returns the text from `begin` to `end` with blanks in place of all characters but line ends.
std::string BlankedOut(const std::string& text, size_t begin, size_t end) {
  std::string blanks = text.substr(begin, end - begin);
  for (char& c : blanks) {
    if (c != '\n') c = ' ';
  }
  return blanks;
}

// Adds "typename" before a type that depends on a template parameter: std::vector<T>::iterator it;
Edits Typename(const ErrorPlace& place) {
  if (!place.MessageHas("need 'typename' before")) return {};
  return {{place.at, place.at, "typename ", "'typename' put before " + place.Quoted(2)}};
}

// Removes the second of two equal parameter names in a declaration: void Turn(int left, int left);
Edits RepeatedParameter(const ErrorPlace& place) {
  if (!place.MessageHas("redefinition of '")) return {};
  const std::string_view word = WordAt(place.code, place.at);
  int depth = 0;
  size_t open = place.at;
  for (; open > 0 && depth >= 0; --open) {
    const char c = place.code[open - 1];
    depth += c == ')' ? 1 : c == '(' ? -1 : 0;
    if (c == ';' || c == '{' || c == '}') return {};
  }
  const size_t close = depth < 0 ? ClosingOf(place.code, open) : kNone;
  if (close == kNone || word.empty()) return {};
  size_t next = NextOf(place.code, close + 1);
  if (next != kNone && HasWordAt(place.code, next, "const")) next = NextOf(place.code, next + 5);
  // Leaves the names of the parameters if no ';' follows their list, because the text is then the
  // definition of a function, whose body needs the names.
  if (next == kNone || place.code[next] != ';') return {};
  return {{place.at, place.at + word.size(), std::string(word.size(), ' '),
           fmt::format("the second parameter called '{}' left without a name", word)}};
}

// Removes the user's definition of a type that the SDK defines too: typedef unsigned long uint32;
// The definitions conflict, because `long` has 64 bits on the host, and the SDK's type has 32 bits,
// as on the robot.
Edits OwnTypedef(const ErrorPlace& place) {
  if (!place.MessageHas("conflicting declaration 'typedef")) return {};
  const size_t begin = place.code.rfind("typedef", place.at);
  const size_t end = place.code.find(';', place.at);
  if (begin == kNone || end == kNone) return {};
  const std::string_view statement = std::string_view(place.code).substr(begin, end - begin);
  if (statement.find_first_of(",;{}") != std::string_view::npos) return {};
  return {{begin, end, BlankedOut(place.text, begin, end),
           fmt::format("'{}' left out: the SDK's is of the robot's width", place.Quoted())}};
}

// Adds an empty statement after a label at the end of a block, where today's g++ requires a
// statement: switch (x) { case 1: return; default: }
Edits LabelAtEnd(const ErrorPlace& place) {
  if (!place.MessageHas("expected primary-expression before '}'")) return {};
  const size_t before = PreviousOf(place.code, place.at);
  if (before == kNone || place.code[before] != ':') return {};
  return {{before + 1, before + 1, ";", "';' put behind a label at the end of a block"}};
}

// Replaces __FUNCTION__ beside a string by __FILE__, as in `Print("in " __FUNCTION__)`.  In g++ 3.3
// __FUNCTION__ was a string literal, which the compiler joins with the string.  Today only __FILE__
// is a literal.  The printed text then names the file and not the function, which is good enough,
// because only people read the text.
Edits FunctionName(const ErrorPlace& place) {
  size_t begin = NextOf(place.code, place.at);  // the message names the place before __FUNCTION__
  if (place.MessageHas("before string constant")) {
    begin = PreviousOf(place.code, place.at);
    while (begin != kNone && begin > 0 && IsWordCharacter(place.code[begin - 1])) --begin;
  } else if (!place.MessageHas("before '__FUNCTION__'") &&
             !place.MessageHas("before '__PRETTY_FUNCTION__'")) {
    return {};
  }
  if (begin == kNone) return {};
  const std::string_view word = WordAt(place.code, begin);
  if (word != "__FUNCTION__" && word != "__PRETTY_FUNCTION__") return {};
  return {{begin, begin + word.size(), "__FILE__",
           fmt::format("{} beside a string became __FILE__", word)}};
}

// Replaces the old operators for minimum and maximum, such as a <? b and a >?= b, by operators that
// compat/openr_prelude.h defines.
Edits MinimumOperator(const ErrorPlace& place) {
  if (!place.MessageHas("expected primary-expression before '?'") || place.at == 0) return {};
  const char sign = place.code[place.at - 1];
  if (place.code[place.at] != '?' || (sign != '<' && sign != '>')) return {};
  const bool assigns = place.code.substr(place.at + 1, 1) == "=";
  const std::string name =
      fmt::format("openr_old::{}{}", assigns ? "set_" : "", sign == '<' ? "minimum" : "maximum");
  return {{place.at - 1, place.at + (assigns ? 2 : 1), fmt::format(" <{}> ", name),
           fmt::format("{}?{} said in another way", sign, assigns ? "=" : "")}};
}

// Replaces 0 by (void*)0 in a comparison of a pointer with 0: if (file < 0)
Edits PointerAndZero(const ErrorPlace& place) {
  if (!place.MessageHas("ordered comparison of pointer with integer zero")) return {};
  const size_t after =
      NextOf(place.code, place.at + (place.code.substr(place.at + 1, 1) == "=" ? 2 : 1));
  const size_t before = PreviousOf(place.code, place.at);
  for (const size_t zero : {after, before}) {
    if (zero == kNone || place.code[zero] != '0') continue;
    const bool is_alone =
        WordAt(place.code, zero) == "0" && (zero == 0 || !IsWordCharacter(place.code[zero - 1]));
    if (is_alone) return {{zero, zero + 1, "(void*)0", "0 compared with a pointer became one"}};
  }
  return {};
}

// Adds "template<>" before the definition of a specialised template: int Table<3>::size = 3;
Edits Specialisation(const ErrorPlace& place) {
  if (!place.MessageHas("requires 'template<>' syntax")) return {};
  size_t begin = place.at;
  while (begin > 0 && std::string_view(";{}").find(place.code[begin - 1]) == std::string_view::npos)
    --begin;
  begin = NextOf(place.code, begin);
  while (begin < place.at && place.code[begin] == '#') {  // skips lines such as #define
    begin = place.code.find('\n', begin);
    begin = begin == kNone ? place.at : NextOf(place.code, begin);
  }
  return {{begin, begin, "template<> ", "'template<>' put before " + place.Quoted()}};
}

// Removes "static" or "extern" before a specialised template, where today's g++ allows neither.
Edits StaticSpecialisation(const ErrorPlace& place) {
  if (!place.MessageHas("explicit template specialization cannot have a storage class")) return {};
  const std::string_view word = WordAt(place.code, place.at);
  if (word != "static" && word != "extern") return {};
  return {{place.at, place.at + word.size(), std::string(word.size(), ' '),
           fmt::format("'{}' of a specialisation left out", word)}};
}

// Removes the leading `::` of a name that was declared before: int ::f() {}  Today's g++ does not
// accept `::` in the declaration of such a name.
Edits KnownGlobalName(const ErrorPlace& place) {
  if (!place.MessageHas("explicit qualification in declaration")) return {};
  if (place.code.compare(place.at, 2, "::") != 0) return {};
  return {{place.at, place.at + 2, "  ", "'::' left out before a name at global scope"}};
}

// Removes the leading `::` of a name that was not declared before: int ::f();  Today's g++ accepts
// `::` only before a name that it knows.
Edits GlobalName(const ErrorPlace& place) {
  if (!place.MessageHas("should have been declared inside '::'")) return {};
  size_t at = place.at;  // position of the name, or of the ')' that ends its parameters
  if (place.code[at] == ')') {
    int depth = 0;
    for (; at > 0; --at) {
      depth += place.code[at] == ')' ? 1 : place.code[at] == '(' ? -1 : 0;
      if (depth == 0) break;
    }
    at = PreviousOf(place.code, at);
    while (at != kNone && at > 0 && IsWordCharacter(place.code[at - 1])) --at;
  }
  const size_t colon = at == kNone ? kNone : PreviousOf(place.code, at);
  if (colon == kNone || colon == 0 || place.code.compare(colon - 1, 2, "::") != 0) return {};
  return {{colon - 1, colon + 1, "  ", "'::' left out before a name at global scope"}};
}

// A for loop that declares a variable which is also used after the loop.
struct Loop {
  size_t begin = kNone;    // position of the word "for"
  size_t declaration = 0;  // position after the opening bracket
  size_t semicolon = 0;    // end of the declaration
};

// Returns the for loop that begins at `at`, if it declares a variable `name`.
std::optional<Loop> LoopThatDeclares(const std::string& code, size_t at, const std::string& name) {
  const size_t open = NextOf(code, at + 3);
  if (open == kNone || code[open] != '(') return std::nullopt;
  const size_t semicolon = code.find(';', open);
  if (semicolon == kNone) return std::nullopt;
  const std::string declaration = code.substr(open + 1, semicolon - open - 1);
  const std::regex pattern("^\\s*[A-Za-z_][\\w:<>\\s,*&]*?[\\s*&]" + name + "\\s*(=|,|\\(|$)");
  if (!std::regex_search(declaration, pattern)) return std::nullopt;
  return Loop{at, open + 1, semicolon};
}

// Returns the last for loop before the position `use` that declares the variable `name`.  A loop in
// a block that ends before `use` does not count, because its variable does not exist at `use`.
std::optional<Loop> FindLoop(const std::string& code, size_t use, const std::string& name) {
  int depth = 0;
  for (size_t at = use; at-- > 0;) {
    if (code[at] == '}') ++depth;
    if (code[at] == '{' && depth > 0) --depth;
    if (depth > 0 || code[at] != 'f' || !HasWordAt(code, at, "for")) continue;
    if (const auto loop = LoopThatDeclares(code, at, name)) return loop;
  }
  return std::nullopt;
}

// Returns the part of `declaration` before the word `name`: "int " of "int i = 0".
std::string TypeIn(const std::string& declaration, const std::string& name) {
  size_t at = declaration.find(name);
  while (at != kNone && !HasWordAt(declaration, at, name)) at = declaration.find(name, at + 1);
  return declaration.substr(0, at);
}

// Moves the declaration of a variable out of its loop: for (int i = 0; ...) {} use(i);  With the
// old compiler, the variable lived until the end of the block, and a later loop with the same
// declaration used the same variable.  So the type is removed from later loops.
Edits LoopVariable(const ErrorPlace& place) {
  if (!place.MessageHas("was not declared in this scope")) return {};
  const std::string name = place.Quoted();
  const std::optional<Loop> loop =
      name.empty() ? std::nullopt : FindLoop(place.code, place.at, name);
  if (!loop) return {};
  const size_t before = PreviousOf(place.code, loop->begin);
  if (before != kNone && std::string_view(";{}").find(place.code[before]) == std::string_view::npos)
    return {};
  const std::string declaration =
      place.text.substr(loop->declaration, loop->semicolon - loop->declaration);
  Edits edits{{loop->begin, loop->begin, declaration + "; ",
               fmt::format("'{}' of a loop declared before it", name)},
              {loop->declaration, loop->semicolon,
               BlankedOut(place.text, loop->declaration, loop->semicolon), ""}};
  const std::string type = TypeIn(declaration, name);
  int depth = 0;
  for (size_t at = loop->semicolon; at < place.code.size() && depth >= 0; ++at) {
    depth += place.code[at] == '{' ? 1 : place.code[at] == '}' ? -1 : 0;
    if (depth != 0 || !HasWordAt(place.code, at, "for")) continue;
    const auto other = LoopThatDeclares(place.code, at, name);
    if (!other || place.code.compare(other->declaration, type.size(), type) != 0) continue;
    edits.push_back(
        {other->declaration, other->declaration + type.size(), std::string(type.size(), ' '), ""});
  }
  return edits;
}

// Returns whether the block after the text `head` may use names that a template inherits.  Such a
// block is a class whose base depends on a template parameter, or a member function that is defined
// outside of its class template.  Today's g++ requires "this->" before inherited names in such a
// block.
bool MayInheritNames(const std::string& head) {
  static const std::regex kDerived("template\\s*<[^]*(?:class|struct)\\s+\\w+\\s*:[^]*<");
  static const std::regex kMember("template\\s*<[^]*\\w\\s*<[^()]*>\\s*::\\s*~?\\w+\\s*\\(");
  return std::regex_search(head, kDerived) || std::regex_search(head, kMember);
}

// Returns whether the position `at` lies in a block that may use names which a template inherits
// (MayInheritNames()).
bool IsInInheritingTemplate(const std::string& code, size_t at) {
  int depth = 0;
  while (at-- > 0) {
    if (code[at] == '}') ++depth;
    if (code[at] != '{' || depth-- > 0) continue;
    depth = 0;
    size_t begin = at;
    while (begin > 0 && std::string_view(";{}").find(code[begin - 1]) == std::string_view::npos)
      --begin;
    if (MayInheritNames(code.substr(begin, at - begin))) return true;
  }
  return false;
}

// Adds "this->" before a name that a template inherits from a base class that depends on the
// template's parameter.  Today's g++ does not look for names in such a base.
Edits InheritedName(const ErrorPlace& place) {
  if (!place.MessageHas("was not declared in this scope")) return {};
  if (WordAt(place.code, place.at) != place.Quoted()) return {};
  const size_t before = PreviousOf(place.code, place.at);
  if (before == kNone || std::string_view(".>:").find(place.code[before]) != std::string_view::npos)
    return {};
  if (!IsInInheritingTemplate(place.code, place.at)) return {};
  return {{place.at, place.at, "this->",
           fmt::format("'this->' put before '{}', which a template inherits", place.Quoted())}};
}

// Corrects the name of a header whose slashes or upper and lower case letters are wrong here,
// because the name was written for another file system: #include "Sub\HEADER.H"
Edits HeaderName(const ErrorPlace& place, const std::vector<std::string>& headers) {
  const size_t end = place.error.message.find(": No such file or directory");
  if (end == kNone) return {};
  const std::string name = place.error.message.substr(0, end);
  std::string wanted = LowerCase(name);
  std::replace(wanted.begin(), wanted.end(), '\\', '/');
  const size_t begin = place.text.find(name, place.at);
  if (begin == kNone || begin > place.text.find('\n', place.at)) return {};
  for (const std::string& header : headers) {
    if (header.size() <= wanted.size() || header[header.size() - wanted.size() - 1] != '/')
      continue;
    const std::string found = header.substr(header.size() - wanted.size());
    if (LowerCase(found) != wanted || found == name) continue;
    return {{begin, begin + name.size(), found, fmt::format("{} is called {}", name, found)}};
  }
  return {};
}

}  // namespace

std::vector<Edit> RepairOf(const CompilerError& error, const std::string& text,
                           const std::vector<std::string>& headers) {
  if (IsAboutAssembly(error)) return AssemblyRepairOf(error, text);
  const ErrorPlace place{error, text, WithoutComments(text),
                         OffsetOf(text, error.line, error.column)};
  if (place.at == kNone) return {};
  static Edits (*const kRules[])(const ErrorPlace&) = {
      &Typename,        &RepeatedParameter, &OwnTypedef,     &LabelAtEnd,           &FunctionName,
      &MinimumOperator, &PointerAndZero,    &Specialisation, &StaticSpecialisation, &GlobalName,
      &KnownGlobalName, &LoopVariable,      &InheritedName};
  for (const auto rule : kRules) {
    Edits edits = rule(place);
    if (!edits.empty()) return edits;
  }
  return HeaderName(place, headers);
}

}  // namespace openr_host
