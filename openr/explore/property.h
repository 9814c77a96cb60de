// Properties: conditions that must hold in every run of an exploration.
//
// PropertyTable() has the built-in properties; property_file.h reads further properties from files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "openr/explore/prepared_run.h"
#include "openr/simulation/standing.h"

namespace openr_host {

// The parts of a run whose values properties can read.
struct RunView {
  const PreparedRun* prepared = nullptr;
  // A monitor for each robot, which tells whether the robot stands.
  const std::vector<StandingMonitor>* standing = nullptr;
  int64_t last_activity_us = 0;  // time of the last activity of an object (activity.h)
};

class Property {
 public:
  explicit Property(std::string name) : name_(std::move(name)) {}
  virtual ~Property() = default;

  const std::string& name() const { return name_; }

  // RunPlan() calls Check() after every frame of 8 ms, and CheckEnd() once at the end of the run.
  // Each function returns "" if the property holds, else a text that says how it is broken.  A
  // broken property ends the run.
  virtual std::string Check(const RunView&) { return ""; }
  virtual std::string CheckEnd(const RunView&) { return ""; }

 private:
  const std::string name_;
};

struct PropertyEntry {
  const char* name;
  const char* meaning;
  bool by_default;
  std::unique_ptr<Property> (*make)();
};

// Returns the built-in properties that are checked while a run goes on.  Two more properties must
// hold in every run: no-crash and handlers-return.  They are not in this table, because a run that
// breaks them ends its process; ForkServer::Run() reports them.
const std::vector<PropertyEntry>& PropertyTable();
inline constexpr char kNoCrash[] = "no-crash";
inline constexpr char kHandlersReturn[] = "handlers-return";

// Returns the name of the property that a run broke when its process ended early: no-crash or
// handlers-return.  `ended_by` is the reason of the end (EndName()).
const char* PropertyOfEnding(std::string_view ended_by);

// The properties that are checked in every run.  Each name is one of these: a built-in property, a
// property file, "default" for all default properties, or a line in the format of a property file
// ("finally objects.B.state == done").
struct PropertyChoice {
  std::vector<std::string> names = {"default"};

  // Makes the chosen properties and returns them.  Throws std::runtime_error when a name is not
  // known or a property file has an error.
  std::vector<std::unique_ptr<Property>> Make() const;
};

}  // namespace openr_host
