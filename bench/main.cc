// The program openr_bench, which is called as: openr_bench STICK [FILTER] [JSON]
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/machine.h"
#include "bench/report.h"

namespace {

using openr_host::Row;

std::vector<Row> AllRows(const std::string& stick) {
  std::vector<Row> rows;
  // The rows between processes come last, because they bind this process to one processor.
  for (const std::vector<Row>& some :
       {openr_host::MessageRows(), openr_host::GraphRows(stick), openr_host::UpperHalvesRows(stick),
        openr_host::CameraRows(stick), openr_host::ScaleRows(stick), openr_host::ProgramRows(stick),
        openr_host::DistributionRows()})
    rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

void Run(const std::string& stick, const std::string& filter, const std::string& json_path) {
  const openr_host::Machine machine = openr_host::DescribeMachine();
  fmt::print("{}", TextOf(machine));
  // Measures the memory before the rows run, because it is measured in forks of this process, which
  // would have the memory of the rows, too.
  const auto memory = openr_host::MeasureMemoryOfDogs(stick, filter);
  const auto times = openr_host::RunRows(AllRows(stick), filter);
  if (!json_path.empty()) openr_host::WriteJson(json_path, machine, memory, times);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: openr_bench STICK [FILTER] [JSON]\n");
    return 2;
  }
  try {
    if (argc == 4 && std::string(argv[1]) == "--peer") return openr_host::RunPeer(argv[2], argv[3]);
    Run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : "");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
