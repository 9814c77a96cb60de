// The command openr replay: runs a recorded run again and compares the new run with the recording.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/continue_run.h"
#include "openr/commands/run_flags.h"
#include "openr/commands/show_run.h"
#include "openr/data/replay_log.h"
#include "openr/ending/end_guards.h"
#include "openr/inspect/replayer.h"
#include "openr/inspect/stepper.h"
#include "openr/run/report.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

struct ReplayFlags {
  ReplayOptions replay;
  std::optional<int64_t> until_us;
  bool step = false;
  bool json = false;
  bool console = false;
  bool panel = false;
  ShowOptions show;
  std::optional<int64_t> continue_at_us;
  ContinueOptions go_on;
  // Options of --log-data; `data_log.file` is "" if the user wants no log of data.
  DataLogOptions data_log;
  std::string timeline_file;
  // Longest processor time of a handler, in microseconds.  A handler that takes longer ends the
  // replay.  The default is the same as for openr run.
  int64_t handler_limit_us = 10'000'000;
};

nlohmann::ordered_json TextOrNull(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

// Prints the messages that differ from the recording; all are from the object that --only names.
void PrintAnswers(const Replayer& replayer, const ReplayFlags& flags) {
  if (flags.replay.only.empty()) return;
  for (const AnswerDifference& difference : replayer.answer_differences())
    PrintPlain(stderr, "{}", DescribeAnswer(difference));
  PrintPlain(stderr, "openr: {} of {}, {}\n", Counted(replayer.answer_count(), "message"),
             replayer.only(),
             replayer.answer_differences().empty()
                 ? "all as recorded"
                 : fmt::format("{} other than recorded", replayer.answer_differences().size()));
}

nlohmann::ordered_json AnswersJson(const Replayer& replayer) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const AnswerDifference& each : replayer.answer_differences()) {
    list.push_back({{"message", each.record.number},
                    {"time_s", static_cast<double>(each.record.time_us) / 1e6},
                    {"receiver", each.receiver},
                    {"entry", each.entry},
                    {"selector", each.record.selector},
                    {"bytes", each.record.size},
                    {"bytes_different", each.count},
                    {"first_byte", each.first},
                    {"now", each.now},
                    {"recorded", each.then}});
  }
  return list;
}

int Finish(Replayer* replayer, const ReplayFlags& flags) {
  std::vector<std::string> problems = replayer->problems();
  if (!replayer->loss().empty()) problems.push_back(replayer->loss());
  for (const std::string& problem : problems) PrintPlain(stderr, "openr: {}\n", problem);
  const std::string& note = replayer->reader().note();
  if (!note.empty()) PrintPlain(stderr, "openr: note: {}\n", note);
  PrintAnswers(*replayer, flags);
  const bool equal = replayer->difference().empty() && replayer->answer_differences().empty();
  const double time_s = static_cast<double>(replayer->system().now_us()) / 1e6;
  if (!replayer->difference().empty())
    PrintPlain(stderr, "openr: difference: {}\n", replayer->difference());
  const char* const how_far = !replayer->loss().empty() ? ", up to there"
                              : !problems.empty()       ? ", as far as the recording can be read"
                              : equal && replayer->at_end() ? ", to the end of the recording"
                                                            : "";
  const char* const result = replayer->answer_differences().empty() ? "equal" : "replayed";
  PrintPlain(stderr, "openr: {} {}, {:.3f} s of virtual time{}\n",
             Counted(replayer->count(), "message"), result, time_s, how_far);
  const auto& [ended_by, why] = replayer->reader().why_ended();
  if (!ended_by.empty() && replayer->at_end())
    PrintPlain(stderr, "openr: the recorded run was ended by {}: {}\n", ended_by, why);
  if (flags.json) {
    nlohmann::ordered_json answer = {{"equal", equal && problems.empty()},
                                     {"messages", replayer->count()},
                                     {"virtual_time_s", time_s},
                                     {"at_end", replayer->at_end()},
                                     {"ended_by", TextOrNull(ended_by)},
                                     {"ended_why", TextOrNull(why)},
                                     {"difference", replayer->difference()},
                                     {"problems", problems}};
    if (!flags.replay.only.empty()) {
      answer["only"] = replayer->only();
      answer["answers"] = replayer->answer_count();
      answer["answer_differences"] = AnswersJson(*replayer);
    }
    PrintPlain("{}\n", JsonText(answer));
  }
  return equal && problems.empty() ? kExitGood : kExitWrong;
}

// Shows the recorded run on the panel.  Returns the exit code.
int Show(const ReplayFlags& flags) {
  ShowOptions show = flags.show;
  show.name = std::filesystem::path(flags.replay.file).filename();
  const auto make = [&flags](const std::function<void(std::string_view)>& console) {
    ReplayOptions options = flags.replay;
    options.console = [console, also = flags.replay.console](std::string_view text) {
      also(text);
      console(text);
    };
    return std::make_unique<Replayer>(options);
  };
  return ShowRun(make, show);
}

int Replay(ReplayFlags flags) {
  if (!flags.console) flags.replay.console = [](std::string_view) {};
  if (flags.console) {
    flags.replay.console = [](std::string_view text) {
      ClearProgressLine();
      std::fwrite(text.data(), 1, text.size(), stderr);
    };
  }
  const bool is_unlimited = flags.step || (flags.panel && !flags.continue_at_us);
  const EndGuards guards({.answer = flags.json ? STDOUT_FILENO : -1,
                          .handler_limit_us = is_unlimited ? 0 : flags.handler_limit_us});
  if (flags.step) return StepThrough(flags.replay) ? kExitGood : kExitWrong;
  if (flags.continue_at_us) {
    flags.go_on.replay = flags.replay;
    flags.go_on.at_us = *flags.continue_at_us;
    flags.go_on.rate = flags.show.rate;
    flags.go_on.panel = flags.panel;
    flags.go_on.panel_port = flags.show.panel_port;
    std::error_code error;
    if (std::filesystem::equivalent(flags.go_on.record_file, flags.replay.file, error)) {
      throw std::runtime_error(
          fmt::format("{}: is the recording to go on from; write the new one to another file",
                      flags.go_on.record_file));
    }
    return ContinueRun(flags.go_on);
  }
  if (flags.panel) return Show(flags);
  Replayer replayer(flags.replay);
  const EndingAction ending_action([&replayer](Ending* ending) {
    // Uses fputs(), because fmt::print() throws an exception if standard error cannot be written,
    // and nothing can catch an exception here: this function is called in a signal handler.
    std::fputs(fmt::format("openr: {} {} equal up to here\n", Counted(replayer.count(), "message"),
                           replayer.count() == 1 ? "was" : "were")
                   .c_str(),
               stderr);
    PrintHandledMessage(*ending);
  });
  const int64_t until_us = flags.until_us.value_or(INT64_MAX);
  const int terminal = flags.json ? -1 : STDERR_FILENO;
  if (flags.data_log.file.empty() && flags.timeline_file.empty()) {
    replayer.RunWithProgress(until_us, terminal);
    return Finish(&replayer, flags);
  }
  const std::string problem =
      LogReplay(&replayer, flags.data_log, flags.timeline_file, until_us, terminal);
  if (!problem.empty()) PrintPlain(stderr, "openr: {}\n", problem);
  const int exit_code = Finish(&replayer, flags);
  return problem.empty() ? exit_code : kExitWrong;
}

}  // namespace

void AddReplayCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "replay",
      "Runs a recorded run again, compares it message by message and stops at the first "
      "difference");
  auto flags = std::make_shared<ReplayFlags>();
  command->add_option("FILE", flags->replay.file, "What openr run --record wrote")->required();
  command->add_option("--stick", flags->replay.stick,
                      "The stick as it was then (default: the folder that was recorded)");
  AddDurationFlag(
      command, "--until", [flags](int64_t us) { flags->until_us = us; },
      "Stop at this virtual time");
  CLI::Option* const step = command->add_flag(
      "--step", flags->step, "A prompt that steps forward and back, breaks and shows queues");
  command->add_flag("--console", flags->console, "Print what objects print");
  CLI::Option* const panel =
      command
          ->add_flag("--panel", flags->panel,
                     "Show the recording on the web panel, where it can be rewound, until Ctrl-C")
          ->excludes(step);
  AddShowFlags(command, panel, &flags->show);
  AddDataLogFlags(command, &flags->data_log, &flags->timeline_file);
  for (const char* const log : {"--log-data", "--timeline"})
    command->get_option(log)->excludes(step)->excludes(panel);
  command->add_flag("--json", flags->json, "Print the result, and nothing else, as JSON")
      ->excludes(step);
  CLI::Option* const only =
      command
          ->add_option(
              "--only", flags->replay.only,
              "Compare only what this object (in upper or lower case) sends, such as a new "
              "build of it on the stick; the others get what was recorded")
          ->excludes(step)
          ->excludes(panel);
  CLI::Option* const go_on = AddDurationFlag(
      command, "--continue-at", [flags](int64_t us) { flags->continue_at_us = us; },
      "Replay up to this virtual time, and go on live from there");
  for (const char* const other : {"--until", "--log-data", "--timeline", "--json"})
    go_on->excludes(command->get_option(other));
  go_on->excludes(step)->excludes(only);
  command
      ->add_option("--record", flags->go_on.record_file,
                   "With --continue-at: write the whole run to this file, for openr replay")
      ->check(IsWritable())
      ->needs(go_on);
  AddDurationFlag(
      command, "--for", [flags](int64_t us) { flags->go_on.for_us = us; },
      "With --continue-at: how long to go on, in virtual time")
      ->needs(go_on);
  AddDurationFlag(command, "--handler-limit", &flags->handler_limit_us,
                  "End the replay when a handler uses more processor time; 0s: never")
      ->excludes(step);
  command->callback([command, flags, exit_code] {
    if (command->count("--rate") > 0 && !flags->panel && !flags->continue_at_us)
      throw CLI::ValidationError("--rate", "needs --panel or --continue-at");
    StartWithSanitizerOfRecording(flags->replay);
    *exit_code = Replay(*flags);
  });
}

}  // namespace openr_host
