// Runs a simulation frame by frame: pacing, pictures, the pause button, the end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "openr/render/picture_request.h"
#include "openr/run/report.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class InterruptCounter;
class Pacer;
class Recorder;
class Simulation;

struct RunPlan {
  std::optional<int64_t> for_us;  // virtual; none: until the robot powers off
  std::string for_text;           // the same, as the person wrote it
  bool until_idle = false;        // or until objects have been quiet for kIdleUs
  double rate = 1;                // virtual seconds per second; 0: as fast as possible
  std::vector<PictureRequest> snapshots;
  std::string stdin_file;                            // see ConsoleFeed
  std::function<void(const std::string& line)> say;  // for people
  Recorder* recorder = nullptr;                      // hears of input; may be null
  // Of a run whose other processes do not wait for the clock: instead of sleeping, waits for news
  // of theirs, at most so long, and does them.  Needs a rate.
  std::function<void(int64_t timeout_us)> pump;
  std::function<void()> after_frame;  // null: nothing
};

// Quiet: nothing was delivered that an object of the stick had sent, but for its readiness for
// the next vector of a system object.
constexpr int64_t kIdleUs = 1'000'000;

// An object that watches the pause button has this long to shut the robot down.
constexpr int64_t kPauseUs = 1'000'000;

class Runner {
 public:
  Runner(Simulation* simulation, RunPlan plan, const InterruptCounter* interrupts);

  // Boots the robots and runs to the end.  False when a picture could not be taken; one whose time
  // did not come is an error finding.
  bool Run();

  // Of the run, or of what there has been of it.  Without the time pictures took.
  double wall_time_s() const;
  const std::vector<StandingMonitor>& standing() const { return standing_; }

 private:
  void WatchActivity();
  // The reason why the run is over.  None while it goes on, and none when all robots are off, since
  // the robots have noted the reason then.
  std::optional<RunEnd> WhyOver() const;
  int64_t NextStop() const;
  void AfterFrame();
  void PressPause();
  void RunFreely(int64_t stop_us, Pacer* pacer);
  void TakePictures(bool at_end);
  void Take(const PictureRequest& snapshot);
  void AnnouncePorts();

  Simulation* const simulation_;
  const RunPlan plan_;
  const InterruptCounter* const interrupts_;
  std::vector<StandingMonitor> standing_;
  std::vector<bool> taken_;      // by snapshot
  std::vector<bool> announced_;  // by robot: its port
  int activity_sink_ = 0;
  int64_t last_activity_us_ = 0;
  int64_t paused_us_ = -1;  // when the button was pressed
  bool shutdown_posted_ = false;
  bool good_ = true;
  int64_t begin_ns_ = 0;      // while it runs
  int64_t wall_time_ns_ = 0;  // of what is over, less that of pictures
};

}  // namespace openr_host
