// Formats the status of runs for openr top, as a table or as JSON.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "distribution/run_status.h"

namespace openr_host {

// The runs that have sent their status, each with its last status and the arrival time of that
// status.
class RunStatusList {
 public:
  struct Run {
    RunStatus status;
    double heard_s = 0;  // time at which the last status came, by this process's clock
  };

  void Update(const std::vector<RunStatus>& news, double now_s);

  // Removes the runs that ended more than 10 s ago.  Until then the table of openr top shows how
  // these runs ended.
  void RemoveEnded(double now_s);

  bool empty() const { return runs_.empty(); }
  std::vector<Run> All() const;

 private:
  using Key = std::tuple<std::string, std::string, int64_t>;  // name, host and process id of a run
  std::map<Key, Run> runs_;
};

// Returns the text that openr top shows: for each run a headline and a table with a row for each
// object.  If the table is wider than `columns` characters, leaves out its least important columns.
// Also wraps the headline and other long lines.  If `columns` is 0, the width has no limit.
std::string TopText(const std::vector<RunStatusList::Run>& runs, double now_s, size_t columns = 0);

// Returns the JSON {"runs": [...]}, with one object for each run.
nlohmann::ordered_json TopJson(const std::vector<RunStatusList::Run>& runs, double now_s);

// Returns `text` as a page for a terminal whose cursor is at the top left.  The page has at most
// `rows` lines of `columns` characters; if lines are left out, the last line says how many.  Each
// line clears the rest of its row, because the page is printed over the previous page.
std::string OnScreen(const std::string& text, size_t rows, size_t columns);

}  // namespace openr_host
