// What must hold in every run.
//
// Built-in properties are named in PropertyTable(); others come from files (property_file.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "openr/explore/prepared_run.h"
#include "openr/simulation/standing.h"

namespace openr_host {

// A run as properties see it.
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

  // After the boot and after every frame, and at the end of the run.  "" or how it is broken;
  // the run is over then.
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

// All built-in ones.  no-crash and handlers-return are always on and not here: a run that breaks
// them cannot look at itself.
const std::vector<PropertyEntry>& PropertyTable();
inline constexpr char kNoCrash[] = "no-crash";
inline constexpr char kHandlersReturn[] = "handlers-return";

// Which of them `record` (last_words.h) is about.
const char* PropertyOfEnding(std::string_view record);

// Which properties a run is to have: names of built-in ones, "default" for those that are so by
// default, files, or what a line of such a file says ("finally objects.B.state == done").
struct PropertyChoice {
  std::vector<std::string> names = {"default"};

  // Throws std::runtime_error when a name is neither or a file is wrong.
  std::vector<std::unique_ptr<Property>> Make() const;
};

}  // namespace openr_host
