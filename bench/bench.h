// Benchmarks: every figure stands beside a floor or a peer of the same run.
//
// A row times two or more variants in turn, several rounds each.  It reports the median of the
// rounds and the best round of each variant, because these machines are shared and noise only adds.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct Variant {
  std::string name;
  // Does `count` operations.
  std::function<void(int64_t count)> run;
};

struct Row {
  std::string name;
  std::string unit;               // of the figure: "ns a message"
  int64_t count = 0;              // operations per round
  std::vector<Variant> variants;  // the first is the floor
  double target = 0;              // ratio of the second to the floor that goals name; 0: none
  int rounds = 7;                 // at least 5
};

// Runs the rows whose name contains `filter`; prints a table to standard output and
// writes JSON to `json_path` unless it is empty.  The JSON also names the machine, the compiler,
// the C library, and the commit that the environment variable OPENR_COMMIT gives.
void RunRows(const std::vector<Row>& rows, const std::string& filter, const std::string& json_path);

// Seconds of wall time.
double WallSeconds();

std::vector<Row> MessageRows();
std::vector<Row> DistributionRows();
// The other end of some of these; `openr_bench --peer KIND NAME`.
int RunPeer(const std::string& kind, const std::string& name);
// `stick`: a folder that holds OPEN-R/.
std::vector<Row> GraphRows(const std::string& stick);
std::vector<Row> CameraRows(const std::string& stick);
std::vector<Row> ScaleRows(const std::string& stick);
// Prints the memory of 1, 10 and 100 dogs, if "memory a dog" contains `filter`.
void PrintMemoryOfDogs(const std::string& stick, const std::string& filter);

}  // namespace openr_host
