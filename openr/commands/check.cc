// openr check: reads a program and its stick without running it.
#include "openr/kit/check.h"

#include <fmt/format.h>

#include <memory>

#include "openr/commands/commands.h"
#include "openr/exit_code.h"

namespace openr_host {
namespace {

struct CheckFlags {
  std::string folder;
  bool json = false;
};

int Check(const CheckFlags& flags) {
  const Remarks remarks = CheckFolder(flags.folder);
  if (flags.json) {
    fmt::print("{}", RemarksToJson(remarks, flags.folder));
  } else {
    fmt::print("{}{} errors, {} warnings, {} notes\n", RenderRemarks(remarks),
               remarks.CountOf(Remark::Kind::kError), remarks.CountOf(Remark::Kind::kWarning),
               remarks.CountOf(Remark::Kind::kNote));
  }
  return remarks.CountOf(Remark::Kind::kError) > 0 ? kExitWrong : kExitGood;
}

}  // namespace

void AddCheckCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("check", "Looks for mistakes in objects and on a stick");
  auto flags = std::make_shared<CheckFlags>();
  command->add_option("DIR", flags->folder, "A stick, or a folder with objects and sticks")
      ->required();
  command->add_flag("--json", flags->json, "One JSON object instead of text");
  command->callback([flags, exit_code] { *exit_code = Check(*flags); });
}

}  // namespace openr_host
