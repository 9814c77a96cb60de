// Benchmarks.  Every figure is compared with a figure of the same run: with a floor, the least that
// the work can cost, or with a peer, another way to do similar work.
//
// A row times two or more variants in turn, several rounds each.  It reports the median of the
// rounds and the best round of each variant, because other programs use these machines too, and
// they can only make a round slower.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct Variant {
  std::string name;
  // A function that does `count` operations.  The time of the call is measured.
  std::function<void(int64_t count)> run;
};

struct Row {
  std::string name;
  std::string unit;               // unit of the figures, such as "ns a message"
  int64_t count = 0;              // operations per round
  std::vector<Variant> variants;  // the first is the floor, with which the others are compared
  double target = 0;              // goal for the ratio of the second variant to the floor; 0: none
  int rounds = 7;                 // number of rounds, at least 5
};

// Runs the rows whose name contains `filter`; prints a table to standard output and
// writes JSON to `json_path` unless it is empty.  The JSON also names the machine, the compiler,
// the C library, and the commit that the environment variable OPENR_COMMIT gives.
void RunRows(const std::vector<Row>& rows, const std::string& filter, const std::string& json_path);

// Returns the wall time in seconds, counted from an arbitrary moment.
double WallSeconds();

std::vector<Row> MessageRows();
std::vector<Row> DistributionRows();
// Runs the other process of a row of DistributionRows(), which is started as `openr_bench --peer
// KIND NAME`.  Returns the exit code.
int RunPeer(const std::string& kind, const std::string& name);
// For the next functions, `stick` is the folder of a Memory Stick, which holds OPEN-R/.
std::vector<Row> GraphRows(const std::string& stick);
std::vector<Row> CameraRows(const std::string& stick);
std::vector<Row> ScaleRows(const std::string& stick);
// Prints how much memory a process with 1, 10 and 100 dogs needs, if the row's name "memory a dog"
// contains `filter`.
void PrintMemoryOfDogs(const std::string& stick, const std::string& filter);

}  // namespace openr_host
