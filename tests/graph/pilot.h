// An object that steers JointMover and hears what it says, as RCServer does.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "Messages.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {

class Pilot : public CodeObject {
 public:
  Pilot() {
    mover_ = AddSubject("Pilot.Mover.MoverCommand.S");
    batch_ = AddSubject("Pilot.BatchMover.BatchMoverCommand.S");
    set_value_ = AddObserver("Pilot.SetValue.SetValueMessage.O", [this](const ONotifyEvent& event) {
      for (int i = 0; i < event.NumOfData(); ++i) {
        reports.push_back(*static_cast<const SetValueMessage*>(event.Data(i)));
      }
      set_value_->AssertReady();
    });
  }
  static void Wire(System* system) {
    system->Connect({0, "Pilot.Mover.MoverCommand.S", "JointMover.Mover.MoverCommand.O", "test"});
    system->Connect({0, "Pilot.BatchMover.BatchMoverCommand.S",
                     "JointMover.BatchMover.BatchMoverCommand.O", "test"});
    system->Connect(
        {0, "JointMover.SetValue.SetValueMessage.S", "Pilot.SetValue.SetValueMessage.O", "test"});
  }
  OStatus DoStart(const OSystemEvent&) override {
    set_value_->AssertReady();
    return oSUCCESS;
  }

  void Send(int kind, int joint, int32_t value) {
    MoverCommand command = {};
    command.kind = kind;
    command.joint = joint;
    command.value = value;
    Send(command);
  }
  void Play(const std::string& file, int loops = 1, int key_frames_per_vector = 0) {
    MoverCommand command = {};
    command.kind = moverkindPLAY;
    command.loops = loops;
    command.keyFramesPerVector = key_frames_per_vector;
    std::strncpy(command.file, file.c_str(), sizeof command.file - 1);
    reports.clear();
    Send(command);
  }
  void Send(const BatchMoverCommand& command) {
    const CurrentScope scope(&system(), &host());
    batch_->SetData(&command, sizeof command);
    batch_->NotifyObservers();
  }

  // Whether the motion asked for last is over, played or not.
  bool MotionIsOver() const {
    for (const SetValueMessage& report : reports) {
      if (report.isOver != 0) return true;
    }
    return false;
  }

  std::vector<SetValueMessage> reports;

 private:
  void Send(const MoverCommand& command) {
    const CurrentScope scope(&system(), &host());
    mover_->SetData(&command, sizeof command);
    mover_->NotifyObservers();
  }

  OSubject* mover_;
  OSubject* batch_;
  OObserver* set_value_;
};

}  // namespace openr_host
