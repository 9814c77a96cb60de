// Robot: one robot of a System.  This file also has the constants that are the same for every
// robot, such as kFrameUs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "runtime/core/arena.h"
#include "runtime/core/message.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class MemoryStick;
class RobotServices;

// Length of a frame, the step in which the robot's sensors and joints work: 8 ms.
constexpr int64_t kFrameUs = 8000;

// RAM of the robot, for the system and all objects (field-notes.md 3.10).
constexpr size_t kRobotMemoryBytes = size_t{32} << 20;

// A robot: its model, its Memory Stick, its devices, and what its objects have registered.
struct Robot {
  int index = 0;
  std::string design;                       // model of the robot: "ERS-210"
  std::shared_ptr<MemoryStick> stick;       // null if the robot has no stick
  std::unique_ptr<RobotServices> services;  // the robot's simulated devices (robot_services.h)
  // The object and selector of each registered service.  The key is the service's name.
  std::map<std::string, std::pair<ObjectId, uint32_t>> directory;
  // The path of a file for each keyword in DESIGNDB.CFG.  The key is the keyword.
  std::map<std::string, std::string> design_data;
  // The object of each name that was given to Register() (MCOOP.h).
  std::map<std::string, ObjectId> names;
  MemoryBudget memory;      // memory that its objects use; limited only with SystemOptions::strict
  uint64_t stick_hash = 0;  // hash of the stick's content when LoadStick() was called
  bool powered_off = false;
  // The reason for the shutdown or the power-off; no value while the robot is on.
  std::optional<RunEnd> end;
  int64_t booted_us = 0;  // virtual time of the robot's last boot
  int boots = 1;          // number of times the robot has booted
  // A function that adds the robot's system objects and loads its stick once more, for a boot after
  // a shutdown.  Returns false if the robot does not boot.  Null if the robot cannot boot again.
  std::function<bool()> load_again;
};

}  // namespace openr_host
