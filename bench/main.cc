// The program openr_bench, which is called as: openr_bench STICK [FILTER] [JSON]
#include <cstdio>
#include <exception>
#include <string>

#include "bench/bench.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: openr_bench STICK [FILTER] [JSON]\n");
    return 2;
  }
  try {
    if (argc == 4 && std::string(argv[1]) == "--peer") return openr_host::RunPeer(argv[2], argv[3]);
    std::vector<openr_host::Row> rows = openr_host::MessageRows();
    for (auto& row : openr_host::GraphRows(argv[1])) rows.push_back(std::move(row));
    for (auto& row : openr_host::CameraRows(argv[1])) rows.push_back(std::move(row));
    for (auto& row : openr_host::ScaleRows(argv[1])) rows.push_back(std::move(row));
    for (auto& row : openr_host::DistributionRows()) rows.push_back(std::move(row));
    const std::string filter = argc > 2 ? argv[2] : "";
    // Measures the memory before the rows run, because it is measured in forks of this process,
    // which would have the memory of the rows, too.
    openr_host::PrintMemoryOfDogs(argv[1], filter);
    openr_host::RunRows(rows, filter, argc > 3 ? argv[3] : "");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
