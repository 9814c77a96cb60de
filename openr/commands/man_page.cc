#include "openr/commands/man_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace openr_host {
namespace {

// Returns `text` with escapes, so that man(7) shows the text unchanged.  Without escapes, a line
// that begins with a dot would be a command of man(7), and '-' could become a hyphen, which does
// not work in a flag that the user copies.
std::string Plain(const std::string& text) {
  std::string plain;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) plain += "\\&";
    if (c == '\\') {
      plain += "\\e";
    } else if (c == '-') {
      plain += "\\-";
    } else {
      plain += c;
    }
    begins_line = c == '\n';
  }
  return plain;
}

std::string Bold(const std::string& text) { return "\\fB" + Plain(text) + "\\fR"; }

std::string Italic(const std::string& text) { return "\\fI" + Plain(text) + "\\fR"; }

bool IsHelp(const OptionInfo& option) {
  return std::find(option.names.begin(), option.names.end(), "--help") != option.names.end() ||
         std::find(option.names.begin(), option.names.end(), "--help-all") != option.names.end();
}

std::string Heading(const OptionInfo& option, bool is_positional) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(is_positional ? Italic(name) : Bold(name));
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (option.value == OptionInfo::Value::kNone) return text;
  if (!option.choices.empty()) {
    text += " " + Plain(fmt::format("{}", fmt::join(option.choices, "|")));
  } else if (!is_positional) {
    text += " " + Italic(option.value_name);
  }
  return text;
}

std::string Entry(const OptionInfo& option, bool is_positional) {
  std::string text = ".TP\n" + Heading(option, is_positional) + "\n" + Plain(option.description);
  if (!option.default_value.empty()) text += Plain(" (default: " + option.default_value + ")");
  if (option.is_repeatable && !is_positional) text += " (may be repeated)";
  return text + "\n";
}

// Returns the names of the positionals of `command`, each after a blank.
std::string Positionals(const CommandInfo& command) {
  std::string text;
  for (const OptionInfo& positional : command.positionals) {
    const std::string name = Italic(positional.names[0]) + (positional.is_repeatable ? "..." : "");
    text += positional.is_required ? " " + name : " [" + name + "]";
  }
  return text;
}

// Returns the line that shows how to call `command`.  `call` are the words up to the name of the
// command, with the positionals of its parent commands: "openr rc HOST move".
std::string Synopsis(const CommandInfo& command, const std::string& call) {
  std::string text = call;
  if (!command.options.empty()) text += " [" + Italic("OPTIONS") + "]";
  text += Positionals(command);
  if (!command.commands.empty()) text += " " + Italic("COMMAND");
  return text + "\n";
}

std::string Entries(const CommandInfo& command) {
  std::string text;
  for (const OptionInfo& positional : command.positionals) text += Entry(positional, true);
  for (const OptionInfo& option : command.options)
    if (!IsHelp(option)) text += Entry(option, false);
  return text;
}

// Returns `footer`, the last part of a command's help, in the language of man(7).  Lines without an
// indent become headings; all other lines are shown unchanged.
std::string Footer(const std::string& footer) {
  std::string text;
  bool is_in_block = false;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const bool is_heading = !line.empty() && line.front() != ' ';
    if (is_heading) {
      text += (is_in_block ? ".fi\n" : "") + (".PP\n" + Plain(line)) + "\n.nf\n";
      is_in_block = true;
    } else if (!line.empty()) {
      text += Plain(line) + "\n";
    }
  }
  return is_in_block ? text + ".fi\n" : text;
}

std::string UpperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// Adds a section to the manual page for each command below `command`: its subcommands, the
// subcommands of these, and so on.  `call` are the words up to the name of `command`.
void AddBelow(const CommandInfo& command, const std::string& call, std::string* page) {
  for (const CommandInfo& below : command.commands) {
    const std::string below_call = call + Positionals(command) + " " + Bold(below.name);
    *page += ".SS " + Plain(below.path) + "\n" + Synopsis(below, below_call) + ".PP\n" +
             Plain(below.description) + "\n" + Entries(below) + Footer(below.footer);
    AddBelow(below, below_call, page);
  }
}

constexpr char kFacts[] = R"(.SH EXIT STATUS
0: good; 1: the input or the run is wrong, or output cannot be written; 2: the command line is wrong;
141: the reader of standard output has closed its pipe.
.SH ENVIRONMENT
.TP
\fBNO_COLOR\fR
If it is set and not empty, no text has colours.
.TP
\fBOPENR_HOST_CXX\fR, \fBOPENR_HOST_CC\fR
The compilers of openr build (g++, gcc).
.TP
\fBOPENRSDK_ROOT\fR
The SDK for the robot, for openr stick robot.
)";

}  // namespace

std::string ManPageFile(const CommandInfo& command) {
  std::string name = command.path + ".1";
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string ManPage(const CommandInfo& program, const CommandInfo& command,
                    const std::string& version) {
  const bool is_program = &program == &command;
  std::string file = ManPageFile(command);
  const std::string title = file.substr(0, file.size() - 2);
  std::string page =
      fmt::format(".TH {} 1 \"\" \"openr\\-host {}\" \"openr\\-host\"\n.SH NAME\n{} \\- {}\n",
                  UpperCase(Plain(title)), version, Plain(title), Plain(command.description));
  page += ".SH SYNOPSIS\n" + Synopsis(command, Bold(command.path));
  const std::string entries = Entries(command);
  if (!entries.empty()) page += ".SH OPTIONS\n" + entries;
  if (is_program) {
    page += ".SH COMMANDS\n";
    for (const CommandInfo& below : command.commands)
      page += ".TP\n" + Bold(below.name) + "\n" + Plain(below.description) + "\n";
  } else if (!command.commands.empty()) {
    page += ".SH COMMANDS\n";
    AddBelow(command, Bold(command.path), &page);
  }
  if (!command.footer.empty()) page += ".SH EXAMPLES\n" + Footer(command.footer);
  page += kFacts;
  std::string also = is_program ? "openr-run" : "openr";
  return page + ".SH SEE ALSO\n.BR " + Plain(also) +
         " (1),\ndocuments in /usr/share/doc/openr\\-host or in docs/ of the sources\n";
}

}  // namespace openr_host
