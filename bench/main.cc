// openr_bench [--filter TEXT] [--json FILE] [--stick DIR --models DIR]
#include <cstring>
#include <string>

#include "bench/bench.h"

int main(int argc, char** argv) {
  std::string filter, json, stick, models;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--filter") == 0) filter = argv[i + 1];
    if (std::strcmp(argv[i], "--json") == 0) json = argv[i + 1];
    if (std::strcmp(argv[i], "--stick") == 0) stick = argv[i + 1];
    if (std::strcmp(argv[i], "--models") == 0) models = argv[i + 1];
  }
  std::vector<openr_host::Row> rows = openr_host::MessageRows();
  if (!stick.empty() && !models.empty()) {
    for (auto& row : openr_host::GraphRows(stick, models)) rows.push_back(std::move(row));
  }
  openr_host::RunRows(rows, filter, json);
  return 0;
}
