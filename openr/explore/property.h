// Properties, which must hold in every run.
//
// PropertyTable() has the built-in properties; property_file.h reads others from files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "openr/explore/prepared_run.h"
#include "openr/simulation/standing.h"

namespace openr_host {

// The state of a run as properties see it.
struct RunView {
  const PreparedRun* prepared = nullptr;
  const std::vector<StandingMonitor>* standing = nullptr;  // by robot
  int64_t last_activity_us = 0;                            // activity.h
};

class Property {
 public:
  explicit Property(std::string name) : name_(std::move(name)) {}
  virtual ~Property() = default;

  const std::string& name() const { return name_; }

  // Checks the property after the boot, after every frame and at the end of the run.  Returns "",
  // or a text that says how the property is broken; then the run is over.
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

// Returns the built-in properties, without no-crash and handlers-return.  These two are always on,
// and are judged by another process, because a run that breaks them cannot go on.
const std::vector<PropertyEntry>& PropertyTable();
inline constexpr char kNoCrash[] = "no-crash";
inline constexpr char kHandlersReturn[] = "handlers-return";

// Returns kNoCrash or kHandlersReturn, whichever the text `record` (ending.h) is about.
const char* PropertyOfEnding(std::string_view record);

// The properties to check: names of built-in ones, "default" for the default ones, names of files,
// or a line as in such a file ("finally objects.B.state == done").
struct PropertyChoice {
  std::vector<std::string> names = {"default"};

  // Makes the properties.  Throws std::runtime_error when a name is not known or a file is wrong.
  std::vector<std::unique_ptr<Property>> Make() const;
};

}  // namespace openr_host
