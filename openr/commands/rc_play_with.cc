// `openr rc HOST mtn play FILE --log LOG --with OTHER`: plays a motion on two robots and writes one
// log, the synchronised play-back of Hohl 2004, section 3.3.6.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "MoverState.h"
#include "cli/counted.h"
#include "cli/output_file.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/motion/log_merge.h"
#include "openr/remote/connection.h"
#include "openr/remote/error.h"
#include "openr/remote/log_reader.h"

namespace openr_host {
namespace {

// Time between two requests for the logs of the two robots.  It is the same as kLogPollUs, which is
// for the log of one robot.
constexpr useconds_t kBothPollUs = 5'000;

remote::PlayAnswer Play(remote::Connection* robot, const RcFlags& flags) {
  return robot->PlayMotion(flags.file, flags.loops, flags.key_frames);
}

// Plays the motion on both robots.  If the other robot refuses the motion or cannot be reached,
// stops the first robot, so that no robot plays alone.  Returns the answer of the first robot.
remote::PlayAnswer PlayBoth(remote::Connection* robot, remote::Connection* other,
                            const RcFlags& flags) {
  const remote::PlayAnswer answer = Play(robot, flags);
  try {
    Play(other, flags);
  } catch (const remote::Error& error) {
    robot->StopMotion();
    if (error.code() != remote::ErrorCode::kRefused) throw;
    throw remote::Error(error.status(), error.frame(),
                        fmt::format("{}: {}", flags.with, error.text()));
  }
  return answer;
}

void ReadBothLogs(remote::LogReader* log, remote::LogReader* other) {
  for (bool plays = true; plays; usleep(kBothPollUs)) {
    // Reads the new records of both robots in each round, even if one robot has ended its motion.
    // Calls log->ReadNewRecords() here, because `||` in the next line would skip this call while
    // the other robot still plays its motion.
    const int state = log->ReadNewRecords();
    plays = other->ReadNewRecords() != moverACCEPTING_COMMANDS || state != moverACCEPTING_COMMANDS;
  }
  // Fetches key frames that were recorded between the last ReadNewRecords() and the motion's end.
  log->ReadNewRecords();
  other->ReadNewRecords();
}

void RequireWhole(const remote::LogReader& log, const std::string& address) {
  if (log.lost() == 0) return;
  throw std::runtime_error(
      fmt::format("{}: the robot had dropped {} of its log before, so the key frames of the two "
                  "robots cannot be matched; let the run go slower (openr run --rate)",
                  address, Counted(log.lost(), "record")));
}

}  // namespace

std::string SimulatedLog(const std::string& bytes) {
  return FormatLog(AsSimulated(ParseLog(bytes)));
}

void RcPlayWithAction(remote::Connection* robot, const RcFlags& flags) {
  remote::Connection other(remote::ParseAddress(flags.with), OptionsOf(flags));
  remote::LogReader log(robot), other_log(&other);
  log.SkipOld();
  other_log.SkipOld();
  const remote::PlayAnswer play = PlayBoth(robot, &other, flags);
  ReadBothLogs(&log, &other_log);
  RequireWhole(log, flags.address);
  RequireWhole(other_log, flags.with);
  const LogFile merged = MergeLogs(ParseLog(log.File()), ParseLog(other_log.File()));
  const std::string unwritten = WriteFile(flags.log, FormatLog(merged));
  if (!unwritten.empty()) throw std::runtime_error(unwritten);
  PrintRcAnswer(
      flags.json, log.frame(),
      {{"file", flags.file},
       {"key_frames", play.keyFrames},
       {"loops", play.loops},
       {"duration_s", play.durationMs / 1000.0},
       {"log", flags.log},
       {"records", log.count()},
       {"records_of_other", other_log.count()}},
      fmt::format("played {} on {} and {}: {} in {}", flags.file, flags.address, flags.with,
                  Counted(static_cast<uint64_t>(log.count()), "record"), flags.log));
}

}  // namespace openr_host
