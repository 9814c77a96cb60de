#include "openr/commands/top_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "cli/counted.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;
using Run = RunStatusList::Run;

// A run is shown as silent if its last status came longer ago than this.  Each run sends its status
// once a second.
constexpr double kSilent_s = 3;
constexpr double kEnded_s = 10;   // time for which a run is shown after its end
constexpr size_t kStateMax = 40;  // largest number of characters of an object's state in the table

// The process in which an object runs, and the host of this process.
struct ProcessHost {
  std::string process;
  std::string host;
  int64_t pid = 0;
  std::string lost;
};

ProcessHost HostOf(const RunStatus& run, const RunStatus::Object& object) {
  for (const RunStatus::Process& process : run.processes) {
    if (!object.process.empty() && process.name == object.process)
      return {process.name, process.host, process.pid, process.lost};
  }
  return {object.process, run.host, run.pid, ""};
}

// Returns the time since the last status of `run` if it is longer than kSilent_s, because the table
// of openr top then warns that the run is silent.  Else, and for a run that has ended, returns 0.
double Silence_s(const Run& run, double now_s) {
  const double silent_s = now_s - run.heard_s;
  return run.status.has_ended || silent_s < kSilent_s ? 0 : silent_s;
}

enum Column {
  kObject,
  kProcess,
  kHost,
  kPid,
  kPriority,
  kRate,
  kMean,
  kP99,
  kQueue,
  kDrops,
  kState
};
constexpr size_t kColumns = kState + 1;
using Row = std::array<std::string, kColumns>;
// Number of characters in each column of the table of openr top; 0: the column is left out.
using Widths = std::array<size_t, kColumns>;

Row RowOf(const RunStatus& run, const RunStatus::Object& object, bool has_robots) {
  const ProcessHost place = HostOf(run, object);
  const std::string process = place.process.empty() ? "-" : place.process;
  const bool is_timed = object.handlers.count > 0;
  return {has_robots ? fmt::format("{}:{}", object.robot, object.name) : object.name,
          place.lost.empty() ? process : process + " (lost)",
          place.host,
          std::to_string(place.pid),
          std::to_string(object.priority),
          fmt::format("{:.1f}", object.messages_per_s),
          is_timed ? fmt::format("{:.0f}", object.handlers.mean_us) : "-",
          is_timed ? fmt::format("{:.0f}", object.handlers.p99_us) : "-",
          std::to_string(object.waiting),
          std::to_string(object.dropped),
          place.lost.empty() ? object.state.substr(0, kStateMax) : "lost"};
}

size_t LineWidth(const Widths& widths) {
  size_t sum = 0;
  for (const size_t width : widths) sum += width == 0 ? 0 : width + 2;
  return sum;
}

// Returns the width of each column, so that a row of the table of openr top has at most `columns`
// characters.  First shortens the last column, the state.  Then leaves out columns, the least
// important first (kGoes), until the row is short enough.  Space that is then left goes to the
// state.
Widths WidthsFor(const std::vector<Row>& rows, size_t columns) {
  constexpr size_t kStateMin = 12;
  constexpr Column kGoes[] = {kPriority, kPid, kHost, kP99, kMean, kDrops, kProcess};
  Widths widths{};
  for (const Row& row : rows) {
    for (size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  if (columns == 0) return widths;
  const size_t state = std::exchange(widths[kState], std::min(widths[kState], kStateMin));
  for (const Column column : kGoes) {
    if (LineWidth(widths) > columns) widths[column] = 0;
  }
  const size_t width = LineWidth(widths);
  if (width < columns) widths[kState] = std::min(state, widths[kState] + columns - width);
  return widths;
}

std::string TableText(const std::vector<Row>& rows, size_t columns) {
  // Columns of words, which are aligned left; columns of numbers are aligned right.
  constexpr Column kLeft[] = {kObject, kProcess, kHost, kState};
  const Widths widths = WidthsFor(rows, columns);
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      if (widths[i] == 0) continue;
      const bool is_left = std::find(std::begin(kLeft), std::end(kLeft), i) != std::end(kLeft);
      line += is_left ? fmt::format("  {:<{}.{}}", row[i], widths[i], widths[i])
                      : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

// Returns `line`, broken at spaces into lines of at most `columns` characters.  All of these lines
// except the first are indented.
std::string Fold(const std::string& line, size_t columns) {
  constexpr size_t kIndent = 4;
  // Does not break lines for a very narrow terminal, because the indent would leave hardly any
  // room.
  if (columns <= 2 * kIndent || line.size() <= columns) return line + "\n";
  size_t end = line.rfind(' ', columns);
  // Cuts a word that alone is longer than a line, because there is no space at which to break.
  if (end == std::string::npos || end <= kIndent) end = columns;
  const size_t next = line.find_first_not_of(' ', end);
  if (next == std::string::npos) return line.substr(0, end) + "\n";
  return line.substr(0, end) + "\n" + Fold(std::string(kIndent, ' ') + line.substr(next), columns);
}

std::string Headline(const Run& run, double now_s) {
  const RunStatus& status = run.status;
  std::string text = fmt::format(
      "{} on {} (pid {}): t={:.3f} s, {:.2f} x real time, {:.0f} messages/s, {} waiting",
      status.run, status.host, status.pid, static_cast<double>(status.virtual_us) / 1e6,
      status.x_real_time, status.messages_per_s, status.waiting);
  const double silent_s = Silence_s(run, now_s);
  if (status.has_ended) text += "; " + (status.end.empty() ? "ended" : status.end);
  if (silent_s > 0)
    text +=
        fmt::format("; silent for {:.0f} s: it waits for a process, is stopped, or gone", silent_s);
  return text;
}

Json ObjectJson(const RunStatus& run, const RunStatus::Object& object) {
  const ProcessHost place = HostOf(run, object);
  const RunStatus::Times& times = object.handlers;
  return {{"robot", object.robot},
          {"name", object.name},
          {"process", place.process},
          {"host", place.host},
          {"pid", place.pid},
          {"lost", place.lost},
          {"priority", object.priority},
          {"state", object.state},
          {"messages", object.messages},
          {"messages_per_s", object.messages_per_s},
          {"handler_us",
           times.count == 0
               ? Json()
               : Json{{"mean", times.mean_us}, {"p99", times.p99_us}, {"max", times.max_us}}},
          {"queue", object.waiting},
          {"queue_max", object.waiting_max},
          {"dropped", object.dropped}};
}

}  // namespace

void RunStatusList::Update(const std::vector<RunStatus>& news, double now_s) {
  for (const RunStatus& status : news) {
    const Key key = {status.run, status.host, status.pid};
    if (!status.objects.empty()) {
      runs_[key] = {status, now_s};
    } else if (const auto found = runs_.find(key); found != runs_.end()) {
      // A status without objects means that the run has ended.
      found->second.status.has_ended = true;
      found->second.heard_s = now_s;
    }
  }
}

void RunStatusList::RemoveEnded(double now_s) {
  std::erase_if(runs_, [now_s](const auto& entry) {
    return entry.second.status.has_ended && now_s - entry.second.heard_s > kEnded_s;
  });
}

std::vector<Run> RunStatusList::All() const {
  std::vector<Run> all;
  for (const auto& [key, run] : runs_) all.push_back(run);
  return all;
}

std::string TopText(const std::vector<Run>& runs, double now_s, size_t columns) {
  std::string text;
  for (const Run& run : runs) {
    const RunStatus& status = run.status;
    const bool has_robots = std::any_of(status.objects.begin(), status.objects.end(),
                                        [](const auto& object) { return object.robot > 0; });
    std::vector<Row> rows = {{"OBJECT", "PROCESS", "HOST", "PID", "PRIO", "MSG/S", "MEAN us",
                              "P99 us", "QUEUE", "DROPS", "STATE"}};
    for (const RunStatus::Object& object : status.objects)
      rows.push_back(RowOf(status, object, has_robots));
    text += Fold(Headline(run, now_s), columns) + TableText(rows, columns);
    if (status.objects_left_out > 0)
      text += fmt::format("  ... {}: a run tells of {}\n",
                          Counted(status.objects_left_out, "more object"), status.objects.size());
    for (const RunStatus::Process& process : status.processes) {
      if (!process.lost.empty()) text += Fold("  lost: " + process.lost, columns);
    }
  }
  return !text.empty() ? TerminalText(text)
                       : "no run was heard yet; openr top hears runs with --monitor, with --ros2,\n"
                         "or with objects in other processes\n";
}

Json TopJson(const std::vector<Run>& runs, double now_s) {
  Json list = Json::array();
  for (const Run& run : runs) {
    const RunStatus& status = run.status;
    Json processes = Json::array(), objects = Json::array();
    for (const RunStatus::Process& process : status.processes) {
      processes.push_back({{"name", process.name},
                           {"host", process.host},
                           {"pid", process.pid},
                           {"lost", process.lost}});
    }
    for (const RunStatus::Object& object : status.objects)
      objects.push_back(ObjectJson(status, object));
    list.push_back({{"run", status.run},
                    {"host", status.host},
                    {"pid", status.pid},
                    {"ended", status.has_ended},
                    {"end", status.end},
                    {"silent_s", Silence_s(run, now_s)},
                    {"virtual_time_s", static_cast<double>(status.virtual_us) / 1e6},
                    {"wall_time_s", status.wall_s},
                    {"x_real_time", status.x_real_time},
                    {"messages", status.messages},
                    {"messages_per_s", status.messages_per_s},
                    {"queue", status.waiting},
                    {"processes", std::move(processes)},
                    {"objects", std::move(objects)},
                    {"objects_left_out", status.objects_left_out}});
  }
  return {{"runs", std::move(list)}};
}

std::string OnScreen(const std::string& text, size_t rows, size_t columns) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line.substr(0, columns));
  if (lines.size() > rows && rows > 0) {
    const size_t left_out = lines.size() - (rows - 1);
    lines.resize(rows - 1);
    lines.push_back(fmt::format("... {}", Counted(left_out, "more line")).substr(0, columns));
  }
  // The text for the whole screen of the terminal, with control codes that clear the end of each
  // line and the rest of the screen.
  std::string screen;
  for (const std::string& line : lines) screen += (screen.empty() ? "" : "\r\n") + line + "\x1b[K";
  return screen + "\x1b[J";
}

}  // namespace openr_host
