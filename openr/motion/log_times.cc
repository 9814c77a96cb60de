#include "openr/motion/log_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "MtnPlayer.h"

namespace openr_host {
namespace {

constexpr double kPlayedFrameMs = 8;

// Plays `motion` as the robot does, with at most `per_vector` key frames in each command vector,
// and makes a record at the end of each command vector.  Returns the times of these records, up to
// the first record whose key frame is not the same as in the log.
std::vector<double> PlayTimes(const LogFile& log, const MtnFile& motion, int per_vector) {
  MtnPlayer player;
  // Lets the motion repeat more often than the log has records, so that the log ends before the
  // play-back does.
  player.Start(&motion, static_cast<int>(log.records.size()) + 1, per_vector);
  std::vector<double> times_ms;
  int frames = 0;
  for (const LogRecord& record : log.records) {
    // Plays no frames for the first record, because it has the key frame with which the motion
    // begins.  A motion with only one key frame has no frames to play, so its log has no further
    // record.
    const int wanted = times_ms.empty() ? 0 : player.FramesOfNextVector();
    if (wanted == 0 && !times_ms.empty()) break;
    for (int f = 0; f < wanted; ++f) player.NextFrame();
    frames += wanted;
    if (player.KeyFrame() != record.key_frame) break;
    times_ms.push_back(frames * kPlayedFrameMs);
  }
  return times_ms;
}

}  // namespace

std::vector<double> TimesOf(const LogFile& log) {
  std::vector<double> times_ms;
  int loop_begin = 0;  // number of key frames in all earlier repetitions of the motion
  for (size_t i = 0; i < log.records.size(); ++i) {
    const int now = log.records[i].key_frame;
    const int before = i > 0 ? log.records[i - 1].key_frame : -1;
    if (now == before) {
      throw std::runtime_error(fmt::format(
          "record {}: key frame {} again, so the motion has interpolated frames, or is short and "
          "repeats; name its file (--motion FILE.MTN), from which the times follow",
          i, now));
    }
    // Refuses a second key frame 0 in the log.  Key frame 0 is logged only when a motion begins,
    // and not when it is repeated: a repetition begins with the movement from key frame 0 to key
    // frame 1, after which key frame 1 is reached.
    if (i > 0 && now == 0) {
      throw std::runtime_error(
          fmt::format("record {}: another motion begins; a log to be read has one motion", i));
    }
    if (now < before) loop_begin += before;
    times_ms.push_back((loop_begin + now) * MTN_FRAME_MS);
  }
  return times_ms;
}

std::vector<double> TimesOf(const LogFile& log, const MtnFile& motion) {
  size_t most = 0;  // largest number of records that agree with a play-back of `motion`
  for (int per_vector = 2; per_vector <= MAX_VECTOR_FRAMES / 2; per_vector += 2) {
    std::vector<double> times_ms = PlayTimes(log, motion, per_vector);
    if (times_ms.size() == log.records.size()) return times_ms;
    most = std::max(most, times_ms.size());
  }
  throw std::runtime_error(
      fmt::format("record {}: key frame {} does not follow in the motion; the log is of another "
                  "one, or lacks records",
                  most, log.records[most].key_frame));
}

}  // namespace openr_host
