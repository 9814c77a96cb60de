#include "bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Returns the medians of the rounds of variant `i`.  The ratio is the median of the ratios of the
// rounds, because another program that disturbs a round disturbs all variants of that round.  The
// same holds for the difference from the floor.
Figures MediansOf(const RowTimes& times, size_t i) {
  std::vector<double> ratios, more_ns;
  for (size_t round = 0; round < times.seconds[i].size(); ++round) {
    const double floor_s = times.seconds[0][round], time_s = times.seconds[i][round];
    ratios.push_back(time_s / floor_s);
    more_ns.push_back((time_s - floor_s) * 1e9);
  }
  return {MedianOf(times.seconds[i]) * 1e9, MedianOf(ratios), MedianOf(more_ns)};
}

// Returns the best round of variant `i`, compared with the best round of the floor.
Figures BestOf(const RowTimes& times, size_t i) {
  const auto best_ns = [&times](size_t variant) {
    return std::ranges::min(times.seconds[variant]) * 1e9;
  };
  return {best_ns(i), best_ns(i) / best_ns(0), best_ns(i) - best_ns(0)};
}

const char* VerdictOf(const Limit& limit, const Figures& medians, const Figures& best) {
  if (IsMet(limit, medians)) return "met";
  return IsMet(limit, best) ? "best met" : "missed";
}

// Returns the line of variant `i`, and a line for each limit after the first.
std::string LinesOf(const RowTimes& times, size_t i) {
  const Variant& variant = times.row.variants[i];
  const Figures medians = MediansOf(times, i), best = BestOf(times, i);
  std::string text = fmt::format("{:<46} {:<28} {:>10} {:>10} {:>8}", i == 0 ? times.row.name : "",
                                 variant.name, TextOfTime(medians.time_ns),
                                 TextOfTime(best.time_ns), fmt::format("{:.2f}x", medians.ratio));
  for (const Limit& limit : variant.limits) {
    if (&limit != &variant.limits.front()) text += fmt::format("\n{:106}", "");
    text += fmt::format(" {:>12} {}", TextOf(limit), VerdictOf(limit, medians, best));
  }
  return text + "\n";
}

Json JsonOf(const Limit& limit, const Figures& medians, const Figures& best) {
  return {{"kind", NameOf(limit.kind)},
          {"value", limit.value},
          {"met_by_medians", IsMet(limit, medians)},
          {"met_by_best_rounds", IsMet(limit, best)}};
}

// Returns the figures of variant `i`.
Json JsonOf(const RowTimes& times, size_t i) {
  const Row& row = times.row;
  const Figures medians = MediansOf(times, i), best = BestOf(times, i);
  Json json = {{"row", row.name},
               {"variant", row.variants[i].name},
               {"unit", row.unit},
               {"rounds", row.rounds},
               {"operations_a_round", row.count},
               {"median_ns", medians.time_ns},
               {"best_ns", best.time_ns},
               {"ratio_to_floor", medians.ratio},
               {"ratio_of_best_rounds", best.ratio},
               {"more_than_floor_ns", medians.more_ns},
               {"more_of_best_rounds_ns", best.more_ns}};
  if (!row.note.empty()) json["note"] = row.note;
  for (const Limit& limit : row.variants[i].limits)
    json["limits"].push_back(JsonOf(limit, medians, best));
  return json;
}

Json JsonOf(const Machine& machine) {
  return {{"processor", machine.processor}, {"family", machine.family},
          {"model", machine.model},         {"stepping", machine.stepping},
          {"vectors", machine.vectors},     {"processors", machine.processors},
          {"load", machine.load},           {"compiler", machine.compiler},
          {"c_library", machine.c_library}, {"commit", machine.commit}};
}

Json JsonOf(const DogMemory& memory) {
  Json json = {{"body", memory.body}, {"dogs", memory.dogs}, {"kb", memory.kb}};
  if (memory.dogs == 1) return json;
  json["further_dog_kb"] = memory.further_kb;
  json["limit_kb"] = kDogMemoryMax_kb;
  json["met"] = memory.further_kb <= kDogMemoryMax_kb;
  return json;
}

}  // namespace

std::string TableHead() {
  return fmt::format("{:<46} {:<28} {:>10} {:>10} {:>8} {:>12}", "row", "variant", "median", "best",
                     "ratio", "limit");
}

std::string TableOf(const RowTimes& times) {
  std::string text;
  for (size_t i = 0; i < times.row.variants.size(); ++i) text += LinesOf(times, i);
  if (times.row.variants.empty()) text = times.row.name + "\n";
  if (!times.row.note.empty()) text += fmt::format("    {}\n", times.row.note);
  return text;
}

void WriteJson(const std::string& path, const Machine& machine,
               const std::vector<DogMemory>& memory, const std::vector<RowTimes>& rows) {
  Json json = JsonOf(machine);
  json["memory"] = Json::array();
  for (const DogMemory& each : memory) json["memory"].push_back(JsonOf(each));
  json["rows"] = Json::array();
  for (const RowTimes& times : rows) {
    for (size_t i = 0; i < times.row.variants.size(); ++i) json["rows"].push_back(JsonOf(times, i));
    if (times.row.variants.empty())
      json["rows"].push_back({{"row", times.row.name}, {"note", times.row.note}});
  }
  std::ofstream(path) << json.dump(2) << "\n";
}

}  // namespace openr_host
