// Recordings are read block by block, because the recording of a day has some GiB.
#include "openr/inspect/recording_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "cli/output_file.h"
#include "openr/inspect/trace_file.h"
#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr int kInputs = 20'000;

class RecordingBytesTest : public testing::Test {
 protected:
  std::string At(const std::string& name) const { return folder_.path() + "/" + name; }

  // Writes a recording of inputs, which has several blocks, and returns its path.
  std::string Write() const {
    TraceWriter writer(At("run.rec"), TraceHeader());
    for (int i = 0; i < kInputs; ++i) writer.AddInput(0, "press chin for 300ms", 8000 * i);
    writer.Flush();
    return At("run.rec");
  }

  const TempFolder folder_;
};

// Reads `reader` to its end, and returns the number of its entries.
int CountEntries(TraceReader* reader) {
  int count = 0;
  for (; reader->Peek() != nullptr; ++count) reader->Take();
  return count;
}

TEST_F(RecordingBytesTest, PartsOfAFileAreRead) {
  ASSERT_EQ(WriteFile(At("a"), "0123456789"), "");
  RecordingBytes bytes(At("a"));
  EXPECT_EQ(bytes.size(), 10u);
  EXPECT_EQ(bytes.Read(2, 3), "234");
  EXPECT_EQ(bytes.Read(8, 5), "89");
  EXPECT_EQ(bytes.Read(10, 1), "");
  EXPECT_EQ(bytes.Read(99, UINT64_MAX), "");
  EXPECT_EQ(bytes.error(), 0);
}

TEST_F(RecordingBytesTest, BytesThatComeAfterTheOpeningAreLeftOut) {
  ASSERT_EQ(WriteFile(At("a"), "0123"), "");
  RecordingBytes bytes(At("a"));
  fs::resize_file(At("a"), 1000);
  EXPECT_EQ(bytes.Read(0, 1000), "0123");
}

TEST_F(RecordingBytesTest, AFileThatIsNotThereIsNamed) {
  EXPECT_THROW(RecordingBytes(At("none")), std::runtime_error);
}

TEST_F(RecordingBytesTest, AReaderHasOnlyOneBlockOfTheRecording) {
  const std::string file = Write();
  TraceReader whole(file), shortened(file);
  EXPECT_EQ(CountEntries(&whole), kInputs);
  EXPECT_THAT(whole.problems(), testing::IsEmpty());
  ASSERT_NE(shortened.Peek(), nullptr);
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_LT(CountEntries(&shortened), kInputs);
  EXPECT_THAT(shortened.problems(), testing::ElementsAre(testing::EndsWith(": is cut off")));
}

TEST_F(RecordingBytesTest, ARecordingCanComeFromAPipe) {
  const std::string file = Write(), trace = std::string(OPENR_PROGRAM) + " trace ";
  const ProgramResult direct = ProgramRun({"-c", trace + file}, "/bin/bash").Finish();
  const ProgramResult piped =
      ProgramRun({"-c", "cat " + file + " | " + trace + "/dev/stdin"}, "/bin/bash").Finish();
  EXPECT_EQ(piped.status, direct.status) << piped.err;
  EXPECT_FALSE(direct.out.empty());
  EXPECT_EQ(piped.out, direct.out);
}

}  // namespace
}  // namespace openr_host
