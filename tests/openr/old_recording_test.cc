// Recordings of older versions are read.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "openr/inspect/replayer.h"
#include "openr/inspect/trace_file.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

// A recording of version 3 has entries of their own for the pause button and for typed text.
TEST(OldRecordingTest, TypedTextAndThePauseButtonAreReadAsInputs) {
  TraceReader reader(OPENR_TEST_DATA "/version3.rec");
  std::vector<std::string> inputs;
  while (reader.Peek() != nullptr) {
    const TraceEntry entry = reader.Take();
    if (entry.kind == TraceEntry::Kind::kInput)
      inputs.push_back(std::to_string(entry.robot) + " " + entry.name);
  }
  EXPECT_EQ(inputs, (std::vector<std::string>{"0 type hello\n", "-1 press pause"}));
  EXPECT_EQ(reader.why_ended().first, "pause");
}

// Older programs left the field empty, and their cameras saw the test pattern.
TEST(OldRecordingTest, CamerasSawTheTestPattern) {
  EXPECT_EQ(TraceReader(OPENR_TEST_DATA "/version3.rec").header().images, "pattern");
}

// Older programs had no limit for typed text that no program has read.
TEST(OldRecordingTest, TypedTextThatIsTooLongNowIsRefusedWithACure) {
  const ScratchFolder folder;
  const std::string file = folder.File("run.rec"), old = folder.File("old.rec");
  const ProgramResult run = RunProgram({"run", "--body", "ideal", "--for", "100ms", "--rate", "max",
                                        "--no-panel", "--rc-port", "0", "--record", file});
  ASSERT_EQ(run.status, 0) << run.err;
  bool is_typed = false;
  {
    TraceReader reader(file);
    TraceWriter writer(old, reader.header());
    while (reader.Peek() != nullptr) {
      const TraceEntry entry = reader.Take();
      writer.AddEntry(entry);
      if (entry.kind != TraceEntry::Kind::kMessage || std::exchange(is_typed, true)) continue;
      TraceEntry input;
      input.kind = TraceEntry::Kind::kInput;
      input.time_us = entry.record.time_us;
      input.name = "type " + std::string(70'000, 'x');
      writer.AddEntry(input);
    }
    writer.Flush();
  }
  Replayer replayer({.file = old, .stick = "", .console = [](std::string_view) {}});
  replayer.RunUntil(INT64_MAX);
  const std::string difference = replayer.difference();
  EXPECT_LT(difference.size(), 1000u);
  EXPECT_TRUE(difference.starts_with("after message ")) << difference;
  for (const char* const part :
       {": the input 'type xxx", "' is refused now: ",
        "the text has 70001 bytes with its newline; at most 65536 can wait to be read",
        "; an older openr has recorded the run, which had no such limit: replay it with that one, "
        "or record the run again"})
    EXPECT_NE(difference.find(part), std::string::npos) << difference;
}

}  // namespace
}  // namespace openr_host
