// Benchmarks.  Every figure is compared with a figure of the same run: with a floor, the least that
// the work can cost, or with a peer, another way to do similar work.
//
// A row times two or more variants in turn, several rounds each.  It reports the median of the
// rounds and the best round of each variant, because other programs use these machines too, and
// they can only make a round slower.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/limit.h"

namespace openr_host {

struct Variant {
  std::string name = {};
  // A function that does `count` operations.  The time of the call is measured.
  std::function<void(int64_t count)> run = {};
  std::vector<Limit> limits = {};  // limits for this variant; its floor is the row's first variant
};

struct Row {
  std::string name = {};
  std::string unit = {};  // unit of the figures, such as "ns a message"
  int64_t count = 0;      // operations per round
  // The first variant is the floor, with which the others are compared.  Empty for a row that
  // cannot be measured on this machine; `note` then says why.
  std::vector<Variant> variants = {};
  int rounds = 7;  // number of rounds, at least 5
  // Number of operations before each round of a variant whose time is not measured.  They make what
  // the variant needs, and fill the processor's caches again after the variant before.
  int64_t warm_up = 1;
  std::string note = {};  // meaning of the figures, printed below them; "": nothing
};

// The times of a row: for each variant, the seconds that an operation took in each round.
struct RowTimes {
  Row row;
  std::vector<std::vector<double>> seconds;
};

// Runs the rows whose name contains `filter`, and prints a table to standard output.
std::vector<RowTimes> RunRows(const std::vector<Row>& rows, const std::string& filter);

// Returns a variant whose T is made by `make()` when its row runs first.  The T is kept until the
// bench ends.
template <typename T, typename Make>
Variant Lazily(const std::string& name, Make make, std::vector<Limit> limits = {}) {
  auto made = std::make_shared<std::unique_ptr<T>>();
  return {name,
          [made, make](int64_t count) {
            if (*made == nullptr) *made = make();
            (*made)->Run(count);
          },
          std::move(limits)};
}

std::vector<Row> MessageRows();
std::vector<Row> DistributionRows();
// Runs the other process of a row of DistributionRows(), which is started as `openr_bench --peer
// KIND NAME`.  Returns the exit code.
int RunPeer(const std::string& kind, const std::string& name);
// For the next functions, `stick` is the folder of a Memory Stick, which holds OPEN-R/.
std::vector<Row> GraphRows(const std::string& stick);
std::vector<Row> UpperHalvesRows(const std::string& stick);
std::vector<Row> CameraRows(const std::string& stick);
std::vector<Row> ScaleRows(const std::string& stick);
std::vector<Row> ProgramRows(const std::string& stick);

// Memory of a process with some dogs.
struct DogMemory {
  std::string body;       // kind of the dogs' bodies: "ideal" or "ode" (with physics)
  int dogs = 0;           // number of dogs in the process
  int64_t kb = 0;         // memory of the process, including the pages of files that it has read
  double further_kb = 0;  // memory for each dog after the first; 0 if there is one dog
};

// Limit for DogMemory::further_kb.
inline constexpr double kDogMemoryMax_kb = 1000;

// Measures the memory of processes with 1, 10 and 100 dogs, and prints it, if the row's name
// "memory a dog" contains `filter`.
std::vector<DogMemory> MeasureMemoryOfDogs(const std::string& stick, const std::string& filter);

}  // namespace openr_host
