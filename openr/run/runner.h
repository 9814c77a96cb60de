// Runner, which runs a simulation frame by frame.  It keeps pace with the clock, takes pictures,
// presses the pause button and decides when the run is over.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "openr/live/run_clock.h"
#include "openr/render/picture_request.h"
#include "openr/run/report.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class EventScript;
class InterruptCounter;
class LiveServer;
class Pacer;
class Recorder;
class Rewind;
class Simulation;

struct RunPlan {
  // Value of --for, the virtual time that the run takes; nullopt: the run goes on until the robots
  // are off.
  std::optional<int64_t> for_us;
  std::string for_text;    // value of --for as the user wrote it
  bool has_begun = false;  // true: the robots have booted already; the run continues a replay
  // Value of --until-idle: the run also ends when objects are quiet for kIdleUs.
  bool until_idle = false;
  double rate = 1;  // virtual seconds per real second; 0: as fast as possible
  std::vector<PictureRequest> snapshots;
  // The file with console input, see ConsoleFeed; "-" is standard input.
  std::string stdin_file;
  EventScript* events = nullptr;  // script of timed inputs; null: none
  LiveServer* live = nullptr;     // server for clients such as openr poke; null: none
  // Rate and pause that clients choose; null: the run always has `rate`.
  RunClock* clock = nullptr;
  Rewind* rewind = nullptr;  // goes back to earlier moments; null: the run cannot be rewound
  // A function that prints a message for the user.
  std::function<void(const std::string& line)> say;
  // False: the robots have no ports of this computer, so the runner names none to the user.
  bool has_ports = true;
  Recorder* recorder = nullptr;  // records the loss of worker processes; null: no recording
  // A function for a free run, in which virtual time goes on while handlers run in worker
  // processes; null in other runs.  It waits at most `timeout_us` for results of these handlers and
  // applies them.  The runner calls it where it would sleep in other runs.  REQUIRES: rate > 0.
  std::function<void(int64_t timeout_us)> pump;
  std::function<void()> after_frame;  // a function that is called after each frame; may be null
};

// Virtual time without activity after which a run with --until-idle ends.  Activity is a message
// that an object of the stick sends, except the ready messages by which objects ask for sensor
// values (IsActivity()).
constexpr int64_t kIdleUs = 1'000'000;

// Virtual time that objects have to shut the robot down after the pause button was pressed.  After
// this time the runner shuts all robots down.
constexpr int64_t kPauseUs = 1'000'000;

class Runner {
 public:
  Runner(Simulation* simulation, RunPlan plan, const InterruptCounter* interrupts);

  // Boots the robots and runs until the run is over.  Returns false when a picture could not be
  // taken.  If a picture was wanted for a time after the end of the run, adds an error to the
  // findings.
  bool Run();

  // Finds out whether each robot stands.  Called after each frame, and also in a copy of the run
  // that repeats frames.
  void SampleStanding();

  // Returns how long the run has taken by the clock of this computer.  Leaves out the time in which
  // pictures were drawn, because it says nothing about the speed of the simulation.
  double wall_time_s() const;
  const std::vector<StandingMonitor>& standing() const { return standing_; }

 private:
  // The state of a robot when the runner last printed a line about the robot.  The runner prints
  // again only when this state has changed.
  struct PrintedFacts {
    uint16_t port = 0;    // port of the robot's remote control; 0: none
    int boots = 1;        // number of boots of the robot
    bool is_off = false;  // true: the robot was off and waited for its boot timer
  };

  void WatchActivity();
  void Finish();
  // Returns the reason why the run is over; nullopt if the run goes on.  Also returns nullopt when
  // all robots are off, because the System has then noted the reason already.
  std::optional<RunEnd> EndOfRun() const;
  // Returns the virtual time up to which the run goes in one step from now: the next frame boundary
  // or, if that is earlier, the end of --for.
  int64_t NextStop() const;
  // Returns the virtual time at which a step ends that begins at `now_us`; see NextStop().
  int64_t NextStopAfter(int64_t now_us) const;
  bool WaitWhilePaused(Pacer* pacer);
  void GoOn(Pacer* pacer);
  void AfterFrame();
  void HandleInterrupt();
  void AddInputToAll(std::string_view line);
  void PressPause();
  void RunFreely(int64_t stop_us, Pacer* pacer);
  void WritePictures(bool at_end);
  void WritePictureOf(const PictureRequest& snapshot);
  void AnnouncePorts();
  void AnnounceBoots();

  Simulation* const simulation_;
  const RunPlan plan_;
  const InterruptCounter* const interrupts_;
  std::vector<StandingMonitor> standing_;
  std::vector<bool> taken_;  // for each picture: true if it was taken
  // The facts that were printed last about each robot; the index is the number of the robot.
  std::vector<PrintedFacts> announced_;
  int activity_sink_ = 0;
  int64_t last_activity_us_ = 0;
  // Virtual time when the pause button was pressed; -1: not pressed.
  int64_t pause_pressed_us_ = -1;
  bool shutdown_posted_ = false;
  bool is_new_branch_ = false;  // true: this process has just become a run of its own (Rewind)
  bool good_ = true;
  // Time at the start of the run by the clock of this computer; 0: not running.
  int64_t begin_ns_ = 0;
  // During the run, the negative of the wall time that drawing pictures has taken.  At other times,
  // the duration of the run in wall time, without the time for pictures.
  int64_t wall_time_ns_ = 0;
};

}  // namespace openr_host
