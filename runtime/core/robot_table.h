// RobotTable: the robots of one System and the connections of their objects.  Switches robots off,
// boots them again, and knows why the run has ended.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/connection.h"
#include "runtime/core/off_robots.h"
#include "runtime/core/robot.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class MemoryStick;
class System;

class RobotTable {
 public:
  // `system` must outlive the table.
  explicit RobotTable(System* system);
  ~RobotTable();
  RobotTable(const RobotTable&) = delete;
  RobotTable& operator=(const RobotTable&) = delete;

  // Adds a robot to the table and returns the robot's index.  Called by System::AddRobot(), which
  // also adds a processor for the robot if there is a cost model.
  int Add(const std::string& design, std::shared_ptr<MemoryStick> stick);
  // Returns the robot with this index.  REQUIRES: 0 <= index < count().
  Robot& Get(int index) const { return *robots_.at(static_cast<size_t>(index)); }
  int count() const { return static_cast<int>(robots_.size()); }
  const std::vector<std::unique_ptr<Robot>>& all() const { return robots_; }

  // Adds a connection between two services, which the next boot of the robot makes.
  void Connect(Connection connection) { connections_.push_back(std::move(connection)); }
  const std::vector<Connection>& connections() const { return connections_; }

  // Begins the shutdown of robot number `index` with the reason `why`.  If the robot is off and
  // waits for its boot timer, only cancels this wait, so that the robot stays off.
  // System::Shutdown() passes the request to System::calls().  In the master process, calls() is
  // LocalCalls, which calls this function.  In a worker process, calls() sends the request to the
  // master process.
  void BeginShutdown(int index, const RunEnd& why);
  // Switches the power of the robot off.  System::PowerOff() passes the request to System::calls(),
  // which calls this function.
  void CutPower(int index, const RunEnd& why);
  // Removes the objects, services, connections and names of robot number `index`, which is off, and
  // loads them again.  If the robot does not boot, returns false and leaves the robot off for the
  // rest of the run.
  bool LoadAgain(int index);

  // Records `why` as the reason why robot number `index` goes off, unless a reason is recorded
  // already.  Only a System::PowerOff() during a shutdown replaces the reason of the shutdown.
  // BeginShutdown() and CutPower() call this function themselves.
  void NoteEnd(int index, const RunEnd& why);
  // Records `why` as the reason for the end of the run, unless a reason was recorded before.
  void NoteRunEnd(const RunEnd& why);
  // Returns why the run has ended: the reason given to NoteRunEnd(), or, when all robots are off,
  // the reason of the robot that went off last.  Has no value while the run goes on.
  const std::optional<RunEnd>& end() const { return end_; }
  // Returns whether all robots are off for good.
  bool are_all_off() const { return are_all_off_; }

  // The robots that are off and will boot again by themselves.
  OffRobots& off_robots() { return off_robots_; }
  const OffRobots& off_robots() const { return off_robots_; }

 private:
  void SwitchObjectsOff(int index);
  void WaitForBoot(Robot* robot);
  void NoteIfAllAreOff(const RunEnd& why);

  System* const system_;
  bool are_all_off_ = false;
  std::optional<RunEnd> end_;
  OffRobots off_robots_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<Connection> connections_;
};

}  // namespace openr_host
