// Compares a run in one process with the same run in several: recordings and reports must be equal.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/openr/program_run.h"

namespace openr_host {

using Words = std::vector<std::string>;
using nlohmann::json;

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Returns --isolate for each of the objects.
inline Words Isolated(const Words& objects) {
  Words flags;
  for (const std::string& object : objects) flags = flags + Words{"--isolate", object};
  return flags;
}

// Returns the process ids of the children of `parent`.
inline std::vector<pid_t> ChildrenOf(pid_t parent) {
  std::vector<pid_t> children;
  const std::string id = std::to_string(parent);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  for (pid_t child = 0; list >> child;) children.push_back(child);
  return children;
}

struct RecordedRun {
  int status = -1;
  std::string err;
  std::string recording;
  json report;

  std::string Hashes() const {
    return report.value("trace_hash", "none") + " " + report.value("state_hash", "none");
  }
};

inline const Words kQuickly = {"run", "--rate", "max", "--no-panel", "--rc-port", "0", "--json"};

// Runs `openr run` with these flags, as fast as it goes.
inline RecordedRun Record(const Words& flags) {
  const ScratchFolder folder;
  const ProgramResult result = RunProgram(kQuickly + Words{"--record", folder.File("r")} + flags);
  return {result.status, result.err, folder.Read("r"), json::parse(result.out, nullptr, false)};
}

// Returns what a report says of the objects, without the wall time and memory, which depend on the
// placement.
inline json WhatObjectsDid(const json& report) {
  json objects = report["objects"];
  for (json& object : objects) {
    for (const char* name : {"handler_us_max", "heap_bytes_max", "stack_bytes_max"})
      object.erase(name);
  }
  return objects;
}

// EXPECTs that both runs are equal, byte by byte.
inline void ExpectSame(const RecordedRun& one, const RecordedRun& other) {
  ASSERT_TRUE(one.report.contains("messages")) << one.err;
  ASSERT_TRUE(other.report.contains("messages")) << other.err;
  EXPECT_EQ(one.status, other.status) << other.err;
  EXPECT_EQ(one.Hashes(), other.Hashes());
  EXPECT_EQ(one.report["messages"], other.report["messages"]);
  EXPECT_GT(one.report["messages"].get<int>(), 20);
  EXPECT_EQ(one.report["findings"], other.report["findings"]);
  EXPECT_EQ(one.report["robots"][0]["joints_deg"], other.report["robots"][0]["joints_deg"]);
  EXPECT_EQ(WhatObjectsDid(one.report), WhatObjectsDid(other.report));
  ASSERT_FALSE(one.recording.empty());
  const auto [here, there] = std::mismatch(one.recording.begin(), one.recording.end(),
                                           other.recording.begin(), other.recording.end());
  EXPECT_TRUE(here == one.recording.end() && there == other.recording.end())
      << "recordings differ at byte " << here - one.recording.begin() << " of "
      << one.recording.size() << " and " << other.recording.size();
}

}  // namespace openr_host
