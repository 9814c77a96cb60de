#include "openr/explore/schedule_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "cli/counted.h"
#include "cli/json_text.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr size_t kDeviationsShown = 20;

std::string Time(const Json& time_us) {
  return time_us.is_number() ? fmt::format("t={:.6f} s", time_us.get<double>() * 1e-6) : "";
}

std::string DescribeDeviation(const Json& deviation) {
  const std::string kind = deviation["kind"].get<std::string>();
  const int64_t nth = deviation["nth"].get<int64_t>() + 1;
  if (kind == "frame") {
    return fmt::format("robot {} counts its frames from {} on", nth - 1,
                       deviation["us"].get<int64_t>());
  }
  if (kind == "fault") {
    return fmt::format("{}: robot {} gets the input '{}'", Time(deviation["time_us"]),
                       deviation["robot"].get<int>(),
                       deviation.value("line", fmt::format("fault {}", nth)));
  }
  const std::string object = deviation["object"].get<std::string>();
  if (kind == "start")
    return fmt::format("{} starts before those ahead of it (choice {})", object, nth);
  const std::string time = Time(deviation["time_us"]);
  if (kind == "tie")
    return fmt::format("{}: {} is first (tie {} of this instant)", time, object, nth);
  const int64_t us = deviation["us"].get<int64_t>();
  // Shows the number of the entry if the file does not have the entry's name.  A person may have
  // edited the file and removed the name.
  const std::string entry =
      deviation.value("entry", fmt::format("entry {}", deviation["selector"].get<uint32_t>()));
  if (kind == "cost") {
    return fmt::format("{}: {}, call {} of {}, takes {} us {}", time, object, nth, entry,
                       us < 0 ? -us : us, us < 0 ? "less" : "more");
  }
  return fmt::format("{}: message {} from {} to {}, {}, comes {} us later", time, nth,
                     deviation["sender"].get<std::string>(), object, entry, us);
}

}  // namespace

Json ScheduleToJson(const ExploredStick& stick, const Json& failure) {
  return {{"openr_explore", kVersion},
          {"stick", stick.simulation.stick},
          {"robot", stick.simulation.robot},
          {"world", stick.simulation.world},
          {"body", stick.simulation.body},
          {"robots", stick.simulation.robots},
          {"together", stick.simulation.together},
          {"more_sticks", stick.simulation.more_sticks},
          {"strict", stick.simulation.strict},
          {"guard", stick.simulation.guard_regions},
          {"cost", stick.simulation.cost_file},
          {"battery", stick.simulation.battery},
          {"images", stick.simulation.images},
          {"for_us", stick.for_us},
          {"properties", stick.properties},
          {"seed", failure.at("seed")},
          {"property", failure.at("property")},
          {"text", failure.at("text")},
          {"deviations", failure.at("deviations")}};
}

ScheduleFile ReadScheduleFile(const std::string& path, Json* deviations) try {
  const std::optional<std::string> text = ReadFile(path);
  if (!text) throw std::runtime_error(fmt::format("cannot be read: {}", std::strerror(errno)));
  const auto json = ParseJson<Json>(*text);
  CheckFractions(json, Fractions::kNone);
  if (json.value("openr_explore", 0) != kVersion) {
    throw std::runtime_error(fmt::format("no schedule of openr explore, version {}", kVersion));
  }
  ScheduleFile schedule;
  SimulationOptions& simulation = schedule.stick.simulation;
  simulation.stick = json.at("stick").get<std::string>();
  simulation.robot = json.at("robot").get<std::string>();
  simulation.world = json.at("world").get<std::string>();
  simulation.body = json.at("body").get<std::string>();
  simulation.robots = json.at("robots").get<int>();
  // Uses the defaults if the fields "together" and "more_sticks" are missing, because older
  // schedule files do not have these fields.  In the runs of these files each robot had a world of
  // its own, and all robots shared one stick.
  simulation.together = json.value("together", false);
  simulation.more_sticks = json.value("more_sticks", simulation.more_sticks);
  simulation.strict = json.at("strict").get<bool>();
  simulation.guard_regions = json.at("guard").get<bool>();
  simulation.cost_file = json.at("cost").get<std::string>();
  // Uses "drain" if the field "battery" is missing, because older schedule files do not have the
  // field and their runs had a battery that drains.
  simulation.battery = json.value("battery", "drain");
  // Uses the test pattern if the field "images" is missing, because older schedule files do not
  // have the field and the cameras of their runs saw the test pattern.
  simulation.images = json.value("images", kImagesOfPattern);
  schedule.stick.for_us = json.at("for_us").get<int64_t>();
  schedule.stick.properties = json.at("properties").get<std::vector<std::string>>();
  schedule.seed = json.at("seed").get<uint64_t>();
  schedule.property = json.at("property").get<std::string>();
  schedule.text = json.at("text").get<std::string>();
  *deviations = json.at("deviations");
  return schedule;
} catch (const std::exception& error) {
  throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
}

std::string DescribeFailure(const Json& failure) {
  std::string text = fmt::format("seed {} breaks {}", failure["seed"].get<uint64_t>(),
                                 failure["property"].get<std::string>());
  if (const std::string time = Time(failure["time_us"]); !time.empty()) text += " by " + time;
  text += fmt::format(": {}\n", failure["text"].get<std::string>());
  const Json& deviations = failure["deviations"];
  if (deviations.empty()) {
    text += "  it does so in the canonical order, too\n";
  } else {
    text += fmt::format("  it takes {} of {} from the canonical order ({} to find that):\n",
                        deviations.size(),
                        Counted(failure["deviations_found"].get<size_t>(), "deviation"),
                        Counted(failure["shorten_runs"].get<uint64_t>(), "run"));
  }
  for (size_t i = 0; i < deviations.size() && i < kDeviationsShown; ++i) {
    text += fmt::format("    {}\n", DescribeDeviation(deviations[i]));
  }
  if (deviations.size() > kDeviationsShown) {
    text += fmt::format("    and {} more\n", deviations.size() - kDeviationsShown);
  }
  for (const Json& wait : failure["waits"]) {
    text += fmt::format("  waiting: {}\n", wait.get<std::string>());
  }
  if (!failure["tail"].empty()) text += "  the last messages:\n";
  for (const Json& line : failure["tail"]) text += fmt::format("    {}\n", line.get<std::string>());
  return text;
}

}  // namespace openr_host
