// Runs a simulation frame by frame, with pacing, pictures, the pause button and the end of the run.
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
  std::optional<int64_t> for_us;  // virtual time; none: until the robot powers off
  std::string for_text;           // for_us as the user wrote it
  bool until_idle = false;        // also end when objects have been quiet for kIdleUs
  double rate = 1;                // virtual seconds per second; 0: as fast as possible
  std::vector<PictureRequest> snapshots;
  std::string stdin_file;                            // see ConsoleFeed
  std::function<void(const std::string& line)> say;  // prints a message for the user
  Recorder* recorder = nullptr;                      // records input; null: none
  // For free-running runs: waits for results of other processes, at most `timeout_us`, in place of
  // sleeping, and applies them.  REQUIRES: rate > 0.
  std::function<void(int64_t timeout_us)> pump;
  std::function<void()> after_frame;  // null: no function is called
};

// Time without activity after which objects are quiet.  Activity is the delivery of a message from
// an object of the stick, except readiness for the next vector of a system object.
constexpr int64_t kIdleUs = 1'000'000;

// Time for an object that watches the pause button to shut the robot down.
constexpr int64_t kPauseUs = 1'000'000;

class Runner {
 public:
  Runner(Simulation* simulation, RunPlan plan, const InterruptCounter* interrupts);

  // Boots the robots and runs to the end.  Returns false when a picture could not be taken.  A
  // picture whose time does not come is an error finding.
  bool Run();

  // Returns the duration of the run so far, without the time for pictures.
  double wall_time_s() const;
  const std::vector<StandingMonitor>& standing() const { return standing_; }

 private:
  void WatchActivity();
  // Returns the reason why the run is over.  Returns none while the run goes on, and also when all
  // robots are off, because then the robots have noted the reason.
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
  std::vector<bool> taken_;      // by picture
  std::vector<bool> announced_;  // by robot: its port was printed
  int activity_sink_ = 0;
  int64_t last_activity_us_ = 0;
  int64_t paused_us_ = -1;  // time at which the button was pressed; -1: not pressed
  bool shutdown_posted_ = false;
  bool good_ = true;
  int64_t begin_ns_ = 0;      // start of the current part of the run
  int64_t wall_time_ns_ = 0;  // duration of finished parts, without pictures
};

}  // namespace openr_host
