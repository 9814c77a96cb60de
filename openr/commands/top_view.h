// Formats the runs for openr top, as a table or as JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "distribution/run_status.h"

namespace openr_host {

// The runs whose status was received, each with the time of its last status.
class RunsHeard {
 public:
  struct Run {
    RunStatus status;
    double heard_s = 0;  // by the wall clock of this process
  };

  void Take(const std::vector<RunStatus>& news, double now_s);

  // Removes runs that ended some time ago.
  void Forget(double now_s);

  bool empty() const { return runs_.empty(); }
  std::vector<Run> All() const;

 private:
  using Key = std::tuple<std::string, std::string, int64_t>;  // name, host, process id
  std::map<Key, Run> runs_;
};

// Returns the table.  `columns` is the width of the screen: columns of the table are left out, the
// least important first, and other lines are broken.  0: the width is not limited.
std::string TopText(const std::vector<RunsHeard::Run>& runs, double now_s, size_t columns = 0);

// Returns {"runs": [...]}.
nlohmann::ordered_json TopJson(const std::vector<RunsHeard::Run>& runs, double now_s);

// Returns the first `rows` lines of `text`, cut to `columns` characters, for a screen with its
// cursor at the top left.  Says how many lines are left out.
std::string OnScreen(const std::string& text, size_t rows, size_t columns);

}  // namespace openr_host
