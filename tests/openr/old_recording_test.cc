// Recordings of older versions are read.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "openr/inspect/trace_file.h"

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

}  // namespace
}  // namespace openr_host
