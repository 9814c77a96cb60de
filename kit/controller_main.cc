#include "kit/controller_main.h"

#include <fmt/format.h>

#include <cstdio>
#include <sstream>

#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/sdk_tools.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

// A way in which a source may declare main(), which the kit compiles under the name
// controller_main.  `symbol` is the name that the compiled main() then has in the object file.
// `declaration` and `call` are the C++ text that declares and calls controller_main().
struct Form {
  const char* symbol;
  const char* declaration;
  const char* call;
};

// All ways in which a source may declare main().  The symbol of a C function does not tell its
// parameters, so the call passes all arguments to a C function.  A C function without parameters
// ignores these arguments.
constexpr Form kForms[] = {
    {"controller_main", "extern \"C\" int controller_main(int argc, char** argv);",
     "controller_main(1, arguments)"},
    {"_Z15controller_mainv", "int controller_main();", "controller_main()"},
    {"_Z15controller_mainiPPc", "int controller_main(int argc, char** argv);",
     "controller_main(1, arguments)"},
    {"_Z15controller_mainiPPKc", "int controller_main(int argc, const char** argv);",
     "controller_main(1, const_cast<const char**>(arguments))"},
};
constexpr char kCxxPrefix[] = "_Z15controller_main";

const Form* FormOf(const std::string& symbol) {
  for (const Form& form : kForms)
    if (symbol == form.symbol) return &form;
  return nullptr;
}

std::string SourceFor(const Form* form) {
  std::string text = "// Generated when the controller was built.\n\n";
  if (form != nullptr) text += fmt::format("{}\n", form->declaration);
  text += "int CallControllerMain();\n\nint\nCallControllerMain()\n{\n";
  if (form == nullptr) return text + "    return 0;\n}\n";
  const std::string call = form->call;
  if (call.find("arguments") != std::string::npos) {
    text +=
        "    static char name[] = \"controller\";\n"
        "    static char* arguments[] = { name, 0 };\n";
  }
  return text + fmt::format("    return {};\n}}\n", call);
}

}  // namespace

ControllerMain FindControllerMain(const std::string& nm,
                                  const std::vector<std::filesystem::path>& objects) {
  if (objects.empty()) return {SourceFor(nullptr), ""};
  Arguments command = {nm, "-P", "--defined-only", "--extern-only"};
  command.insert(command.end(), objects.begin(), objects.end());
  const ProcessResult listed =
      RunProcess(command, {.captures_error = true, .captures_out = true, .has_no_input = true});
  if (!listed.start_error.empty()) return {"", fmt::format("{}: {}", nm, listed.start_error)};
  if (!listed.good()) return {"", fmt::format("{} fails: {}", nm, listed.output)};
  const Form* form = nullptr;
  int count = 0;
  std::istringstream lines(listed.output);
  for (std::string line; std::getline(lines, line);) {
    const std::string symbol = line.substr(0, line.find(' '));
    const Form* const found = FormOf(symbol);
    if (found == nullptr && symbol.starts_with(kCxxPrefix))
      return {"", "main() has arguments, and the robot gives none; write int main(void)"};
    if (found == nullptr) continue;
    form = found;
    ++count;
  }
  if (count == 0) return {"", "no source has a main()"};
  if (count > 1) return {"", "main() is in more than one source"};
  return {SourceFor(form), ""};
}

int RunControllerMain(const Arguments& arguments) {
  if (arguments.size() < 2) {
    std::fputs("usage: controller-main NM OUT [OBJECT...]\n", stderr);
    return 2;
  }
  const ControllerMain found =
      FindControllerMain(arguments[0], {arguments.begin() + 2, arguments.end()});
  const std::string problem =
      found.problem.empty() ? WriteText(arguments[1], found.source) : found.problem;
  if (!problem.empty()) PrintPlain(stderr, "controller-main: {}\n", problem);
  return problem.empty() ? 0 : 1;
}

}  // namespace openr_host
