// The command openr trace: shows the messages and inputs of a recorded run.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/exit_code.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/inspect/trace_text.h"
#include "runtime/base/duration.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

struct TraceFlags {
  std::string file;
  std::string format = "text";
  TraceFilter filter;
};

// Throws std::runtime_error if the recording does not have the object or the service that the flags
// name.
void CheckFilter(const TraceFlags& flags) {
  if (flags.filter.object.empty() && flags.filter.service.empty()) return;
  TraceReader reader(flags.file);
  // Reads the whole recording, because NoMatchText() must know all objects and services in it.
  while (reader.Peek() != nullptr) reader.Take();
  const std::string nothing = reader.NoMatchText(flags.filter.object, flags.filter.service);
  if (!nothing.empty()) throw std::runtime_error(fmt::format("{}: {}", flags.file, nothing));
}

int ShowTrace(const TraceFlags& flags) {
  if (flags.filter.from_us > flags.filter.until_us) {
    throw CLI::ValidationError(
        "--from",
        fmt::format("{} is after --until {}, so there is nothing to show",
                    FormatDuration(flags.filter.from_us), FormatDuration(flags.filter.until_us)));
  }
  CheckFilter(flags);
  TraceReader reader(flags.file);
  const TextSink out = [](std::string_view text) { PrintAnswer(text); };
  const TextSink plain_out = [](std::string_view text) {
    PrintAnswer(TerminalText(std::string(text)));
  };
  if (flags.format == "text") WriteTraceText(&reader, flags.filter, plain_out);
  if (flags.format == "csv") WriteTraceCsv(&reader, flags.filter, out);
  if (flags.format == "perfetto") WriteTracePerfetto(&reader, flags.filter, out);
  for (const std::string& problem : reader.problems()) PrintPlain(stderr, "openr: {}\n", problem);
  if (!reader.note().empty()) PrintPlain(stderr, "openr: note: {}\n", reader.note());
  return reader.problems().empty() ? kExitGood : kExitWrong;
}

}  // namespace

void AddTraceCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("trace", "Shows a run that openr run --record wrote down");
  auto flags = std::make_shared<TraceFlags>();
  command->add_option("FILE", flags->file, "The recording")->required();
  command
      ->add_option("--format", flags->format,
                   "text; csv: a table; perfetto: for the viewer at ui.perfetto.dev")
      ->check(CLI::IsMember({"text", "csv", "perfetto"}))
      ->capture_default_str();
  command->add_option("--object", flags->filter.object, "Only messages from or to this object");
  command->add_option("--service", flags->filter.service,
                      "Only messages to entries with this in their name");
  command->add_flag(
      "--values", flags->filter.values,
      "The content of messages of known types, with names and units; csv: in the column said");
  AddDurationFlag(command, "--from", &flags->filter.from_us, "Only from this virtual time on");
  AddDurationFlag(
      command, "--until", [flags](int64_t us) { flags->filter.until_us = us; },
      "Only up to this virtual time");
  command->callback([flags, exit_code] { *exit_code = ShowTrace(*flags); });
}

}  // namespace openr_host
