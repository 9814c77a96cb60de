#include "runtime/core/robot_table.h"

#include <algorithm>
#include <cstdint>

#include "runtime/core/dispatcher.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"

namespace openr_host {

RobotTable::RobotTable(System* system) : system_(system), off_robots_(system) {}

RobotTable::~RobotTable() = default;

int RobotTable::Add(const std::string& design, std::shared_ptr<MemoryStick> stick) {
  auto robot = std::make_unique<Robot>();
  robot->index = count();
  robot->design = design;
  robot->stick = std::move(stick);
  if (system_->options().strict) robot->memory.limit_bytes = kRobotMemoryBytes;
  robot->services = std::make_unique<RobotServices>();
  robots_.push_back(std::move(robot));
  return count() - 1;
}

void RobotTable::BeginShutdown(int index, const RunEnd& why) {
  // If the robot is off already and waits for its boot timer, cancels this wait, so that the robot
  // stays off.  The objects of the robot need not be stopped, because none of them runs.
  if (off_robots_.Remove(index)) {
    Get(index).end = why;
    return NoteIfAllAreOff(why);
  }
  NoteEnd(index, why);
  system_->manager().PostShutdown(index);
}

void RobotTable::CutPower(int index, const RunEnd& why) {
  // True at the end of a shutdown, which has set Robot::end already; false if the power is cut.
  const bool ends_shutdown = why.kind == EndKind::kPowerOff;
  const bool was_off = index < count() && Get(index).powered_off;
  // Records the power cut as the reason why the robot goes off (Robot::end).  The power cut
  // replaces the reason of a shutdown that has begun.  If the robot is off already, keeps its old
  // reason.
  if (index < count() && !ends_shutdown && !was_off) Get(index).end = why;
  NoteEnd(index, why);
  SwitchObjectsOff(index);
  if (index >= count()) return NoteIfAllAreOff(why);
  Get(index).powered_off = true;
  off_robots_.Remove(index);
  // Starts no boot timer if the power was cut during the shutdown: then the robot stays off.
  if (ends_shutdown && !was_off) WaitForBoot(&Get(index));
  NoteIfAllAreOff(*Get(index).end);
}

// Drops from now on all messages to the objects of robot number `index`.
void RobotTable::SwitchObjectsOff(int index) {
  for (const auto& object : system_->objects()) {
    // Does not mark the object manager as off, because it serves all robots of the System.
    if (object == nullptr || object->robot != index || object.get() == &system_->manager().host())
      continue;
    object->delivery().set_off(true);
  }
}

// Called after `robot` has shut down.  If a boot timer runs and the robot can be loaded again,
// switches the devices off and adds the robot to off_robots_, which boots it when the timer ends.
// Otherwise the robot stays off.
void RobotTable::WaitForBoot(Robot* robot) {
  const std::optional<int64_t> off_us = robot->services->TimeOffUs();
  if (!off_us || robot->load_again == nullptr) return;
  robot->services->SwitchOff();
  off_robots_.Add(robot->index, system_->now_us() + *off_us);
}

// Ends the run with the reason `why` if all robots are off and stay off.
void RobotTable::NoteIfAllAreOff(const RunEnd& why) {
  are_all_off_ = std::all_of(robots_.begin(), robots_.end(), [this](const auto& dog) {
    return dog->powered_off && !off_robots_.Contains(dog->index);
  });
  if (!are_all_off_) return;
  NoteRunEnd(why);
  system_->dispatcher().Stop();
}

bool RobotTable::LoadAgain(int index) {
  // Does not boot the robot if it was switched off for good after its boot was posted.
  if (!off_robots_.Remove(index)) return false;
  Robot& dog = Get(index);
  system_->object_table().RemoveAllOf(index);
  std::erase_if(connections_, [index](const auto& each) { return each.robot == index; });
  dog.design_data.clear();
  dog.end.reset();
  dog.booted_us = system_->now_us();
  ++dog.boots;
  const bool boots = dog.load_again();
  if (boots) {
    dog.powered_off = false;
  } else {
    // Drops the messages to the objects that were loaded: they get no DoInit, so they must not get
    // a DoStop either.
    SwitchObjectsOff(index);
    dog.end = {EndKind::kNoBoot, "the robot does not boot again; the findings say why"};
    NoteIfAllAreOff(*dog.end);
  }
  return boots;
}

void RobotTable::NoteEnd(int index, const RunEnd& why) {
  if (index < count() && !Get(index).end) Get(index).end = why;
}

void RobotTable::NoteRunEnd(const RunEnd& why) {
  if (!end_) end_ = why;
}

}  // namespace openr_host
