// RemotePort, which gives a controller on this computer access to its robot.
#pragma once

#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ControllerCore.h"
#include "openr/controller/camera_fetcher.h"
#include "openr/controller/joint_commands.h"
#include "openr/remote/connection.h"

namespace openr_host {

// Implements ControllerPort, the functions of a robot that ControllerCore calls.  ControllerCore is
// the loop of the OPEN-R object Controller.  Commands are sent as requests of the remote control,
// and sensor values come from its stream.
//
// The functions of ControllerPort are called in code of the controller, which may be C, so they
// throw nothing.  If the connection fails, the functions keep the error, and Check() throws it.
class RemotePort : public ControllerPort {
 public:
  // Connects to the robot and subscribes to its sensor values.  `folder` is the controller's
  // folder.  `on_step` runs an iteration of the controller's loop while the controller waits in
  // robot_step().  If openr has to end, `on_step` does not return.  Throws remote::Error; throws
  // std::runtime_error if the design of the robot is unknown.
  RemotePort(const openr::remote::Address& address, openr::remote::Options options,
             std::string folder, std::function<void()> on_step);
  ~RemotePort() override;

  ControllerCore* core() { return &core_; }

  // Receives sensor values and answers of the robot until the wall clock (wall_clock.h) shows
  // `deadline_ns`, or until `is_ended` returns true.  Throws remote::Error if the connection fails,
  // or if the robot has sent nothing within the time limit.
  void ReceiveUntil(int64_t deadline_ns, const std::function<bool()>& is_ended);

  // Throws the connection error that an earlier function of ControllerPort has kept.  Does nothing
  // if there was no error.
  void Check() const;

  // Waits for the answers to all commands that the robot has not answered yet.  Throws
  // remote::Error.
  void Finish();

  // Returns whether the robot stands.  Only a robot that stands accepts commands.
  bool Stands() const;

  // Returns whether ControllerCore has sent the lights since the last call of TakeNewStep().
  // ControllerCore sends the lights in each iteration of its loop, so this tells that the iteration
  // is complete.  Sets `*step_ms` to the time step.
  bool TakeNewStep(int* step_ms);

  // Returns the frame number of the newest sensor values.
  uint32_t frame() const { return core_.Sensors().frame; }

 private:
  // ---- Functions of ControllerPort, which ControllerCore calls
  bool IsLedReady() override { return true; }
  bool IsEarReady() override { return true; }
  bool IsBatchMoverReady() override { return true; }
  void SendLeds(Uint32 on, int frames) override;
  void SendEars(Uint32 on) override { wanted_ears_ = on; }
  void SendBatch(const BatchMoverCommand& batch) override { wanted_ = batch; }
  void SendMover(const MoverCommand& command) override;
  bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) override;
  int BatteryCapacity() override { return battery_percent_; }
  void EnableCamera(bool on) override;
  void TimeStepRounded(int asked_ms, int used_ms) override;
  void UnknownDevice(const char* locator) override;
  void Remark(const char* text) override;
  void Print(const char* text) override;
  void RunLoop(void (*body)(void*), void* argument) override { body(argument); }
  bool SuspendLoop() override;
  void ContinueLoop() override { is_continued_ = true; }
  void EndLoop() override {}

  // A packet of commands (BATCH) that was sent to the robot and whose answers have not come yet.
  struct Batch {
    openr::remote::RequestId id;
    std::vector<RobotCommand> commands;
  };

  void HandleEvent(const openr::remote::Event& event);
  void StoreSensors(const openr::remote::Sensors& sensors, uint32_t frame);
  void StoreMotionState(int key_frame, bool is_over);
  void HandleAnswers(bool waits);
  void CopyNewPicture();
  void PingIfSilent();
  void AddLights(RcCommand command, const char* kind, int count, Uint32 now, Uint32* sent,
                 std::vector<RobotCommand>* commands) const;
  void Send(const std::vector<RobotCommand>& commands);
  std::string LocalMotion(const std::string& name) const;
  std::string FetchMotion(const std::string& name);
  void WarnOfRefusal(const std::string& text);
  template <typename Function>
  bool Guarded(const Function& function, std::string* refusal);

  const openr::remote::Address address_;
  const openr::remote::Options options_;
  const std::string folder_;
  const std::function<void()> on_step_;
  openr::remote::Connection robot_;
  const RobotConstants* const constants_;
  ControllerCore core_;
  JointCommands joints_;
  std::deque<Batch> batches_;
  std::unique_ptr<CameraFetcher> camera_;
  std::exception_ptr failure_;

  // The joint positions, and the motors to switch on or off, that the controller wants; nullopt: no
  // change.
  std::optional<BatchMoverCommand> wanted_;
  // Joints whose new positions the robot has refused as BUSY, perhaps because a motion plays, and
  // the text of the warning for each.
  std::vector<std::pair<int, std::string>> busy_;
  Uint32 wanted_ears_ = 0;
  Uint32 sent_leds_ = 0;  // the lights that were commanded last; at first all lights are off
  Uint32 sent_ears_ = 0;
  int state_ = -1;  // state of the robot's object JointMover (MoverState); -1: not known yet
  int battery_percent_ = 0;
  std::string playing_;      // file of the motion that plays for the controller; "": none
  uint32_t play_frame_ = 0;  // frame number in the answer to MTN_PLAY for this motion
  // Time step that came with the last SendLeds(); 0: SendLeds() was not called since the last
  // TakeNewStep().
  int step_ms_ = 0;
  int rounded_ms_ = 0;  // the rounded time step that the user was told last; 0: none
  bool is_continued_ = false;
  int64_t heard_ns_;                  // time of the robot's last event or answer
  std::optional<int64_t> warned_ns_;  // time of the last warning of WarnOfRefusal()
  // Id of the request INFO that was sent to a silent robot and is not answered yet; 0: none.
  openr::remote::RequestId life_ = 0;
};

}  // namespace openr_host
