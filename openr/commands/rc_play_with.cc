// `openr rc HOST mtn play FILE --log LOG --with OTHER`: plays a motion on two robots and writes one
// log, the synchronised play-back of Hohl 2004, section 3.3.6.
#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "MoverState.h"
#include "cli/counted.h"
#include "cli/output_file.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/motion/log_merge.h"
#include "openr/remote/remote_client.h"
#include "openr/remote/remote_log.h"

namespace openr_host {
namespace {

// Time between two requests for the logs, as short as that of a single robot.
constexpr useconds_t kBothPollUs = 5'000;

RcPlayAnswer Play(RemoteClient* client, const RcPlayRequest& request) {
  return client->Read<RcPlayAnswer>(client->RequestWith(rcMTN_PLAY, request));
}

// Plays on both robots.  If the other one refuses or cannot be reached, the first one is stopped,
// so that no robot plays alone.
RcPlayAnswer PlayBoth(RemoteClient* client, RemoteClient* other, const RcPlayRequest& request,
                      const std::string& other_address) {
  const RcPlayAnswer answer = Play(client, request);
  try {
    Play(other, request);
  } catch (const RemoteRefusal& refusal) {
    client->Request(rcMTN_STOP);
    throw RemoteRefusal(refusal.status, refusal.frame,
                        fmt::format("{}: {}", other_address, refusal.what()));
  } catch (const RemoteFailure&) {
    client->Request(rcMTN_STOP);
    throw;
  }
  return answer;
}

void TakeBoth(RemoteLog* log, RemoteLog* other) {
  for (bool plays = true; plays; usleep(kBothPollUs)) {
    const int state = log->Take();
    plays = other->Take() != moverACCEPTING_COMMANDS || state != moverACCEPTING_COMMANDS;
  }
  log->Take();  // the last key frames, which may have come before the state
  other->Take();
}

void RequireWhole(const RemoteLog& log, const std::string& address) {
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

void RcPlayWithAction(RemoteClient* client, const RcFlags& flags) {
  RemoteAddress address;
  const std::string problem = ParseRemoteAddress(flags.with, &address);
  if (!problem.empty()) throw std::runtime_error(fmt::format("--with: {}", problem));
  RemoteClient other(address, static_cast<int>(flags.timeout_us / 1000));
  RemoteLog log(client), other_log(&other);
  log.SkipOld();
  other_log.SkipOld();
  RcPlayRequest request;
  request.file = flags.file;
  request.loops = static_cast<Uint16>(flags.loops);
  request.keyFramesPerVector = static_cast<Uint8>(flags.key_frames);
  const RcPlayAnswer play = PlayBoth(client, &other, request, flags.with);
  TakeBoth(&log, &other_log);
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
