// What openr top shows: runs as a table for people, or as JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "distribution/run_status.h"

namespace openr_host {

// The runs that were heard, and when.
class RunsHeard {
 public:
  struct Run {
    RunStatus status;
    double heard_s = 0;  // by the wall clock of who listens
  };

  void Take(const std::vector<RunStatus>& news, double now_s);

  // Forgets those that ended some time ago.
  void Forget(double now_s);

  bool empty() const { return runs_.empty(); }
  std::vector<Run> All() const;

 private:
  using Key = std::tuple<std::string, std::string, int64_t>;  // name, host, process id
  std::map<Key, Run> runs_;
};

// Lines, each with its end.  `columns`: of the screen, for which columns of the table are left out,
// the least important first, and other lines are folded; 0: as wide as it is.
std::string TopText(const std::vector<RunsHeard::Run>& runs, double now_s, size_t columns = 0);

// {"runs": [...]}.
nlohmann::ordered_json TopJson(const std::vector<RunsHeard::Run>& runs, double now_s);

// The first `rows` lines of `text`, of `columns` characters at most, for a screen whose cursor is
// at home; says what is left out.
std::string OnScreen(const std::string& text, size_t rows, size_t columns);

}  // namespace openr_host
