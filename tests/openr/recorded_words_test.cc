// Recordings with messages in words: those of the network stack, and what traces show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "Messages.h"
#include "openr/inspect/replayer.h"
#include "openr/inspect/trace_text.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class RecordedWordsTest : public testing::Test {
 protected:
  RecordedWordsTest() : file_(folder_.File("run.rec")) {
    const ProgramResult run = RunProgram({"run", "--body", "ideal", "--for", "1s", "--rate", "max",
                                          "--no-panel", "--rc-port", "0", "--record", file_});
    EXPECT_EQ(run.status, 0) << run.err;
  }

  // Returns the difference that a replay of the recording `file` finds.
  static std::string Replay(const std::string& file) {
    Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
    replayer.RunUntil(INT64_MAX);
    EXPECT_TRUE(replayer.at_end() || !replayer.difference().empty());
    return replayer.difference();
  }

  // Makes a copy of the recording, with the entries of messages of the network stack changed by
  // `change`.
  template <typename Change>
  std::string CopyWithDescriptions(Change change) const {
    const std::string copy = folder_.File("copy.rec");
    TraceReader reader(file_);
    TraceWriter writer(copy, reader.header());
    while (reader.Peek() != nullptr) {
      TraceEntry entry = reader.Take();
      if (entry.payload.starts_with("IPStack: ")) change(&entry);
      writer.AddEntry(entry);
    }
    writer.Flush();
    return copy;
  }

  const ScratchFolder folder_;
  const std::string file_;
};

TEST_F(RecordedWordsTest, ARecordingWithoutDescriptionsOfNetworkMessagesReplays) {
  EXPECT_EQ(Replay(file_), "");
  EXPECT_EQ(Replay(CopyWithDescriptions([](TraceEntry* entry) { entry->payload.clear(); })), "");
}

TEST_F(RecordedWordsTest, ADescriptionInOtherWordsIsNoDifference) {
  EXPECT_EQ(Replay(CopyWithDescriptions([](TraceEntry* entry) { entry->payload += "!"; })), "");
}

TEST_F(RecordedWordsTest, AnotherNetworkMessageIsNamedInWords) {
  const std::string difference = Replay(CopyWithDescriptions([](TraceEntry* entry) {
    const size_t port = entry->payload.find(":54000");
    if (port == std::string::npos) return;
    entry->payload.replace(port, 6, ":54321");
    ++entry->record.payload_hash;
  }));
  EXPECT_NE(difference.find(": is 'IPStack: TCP Listen, endpoint "), std::string::npos)
      << difference;
  EXPECT_NE(difference.find(":54321 to 0.0.0.0:0' when recorded"), std::string::npos) << difference;
}

TEST_F(RecordedWordsTest, TextAndPerfettoSayWhatMessagesSay) {
  const auto write = [&](auto* function) {
    TraceReader reader(file_);
    std::string text;
    function(&reader, TraceFilter{.object = "RCServer", .service = "", .values = true},
             [&](std::string_view piece) { text += piece; });
    return text;
  };
  EXPECT_NE(write(&WriteTraceText).find("\n        IPStack: CreateEndpoint, TCP, pool of "),
            std::string::npos);
  std::vector<std::string> said;
  const auto perfetto = nlohmann::json::parse(write(&WriteTracePerfetto));
  for (const auto& event : perfetto["traceEvents"]) {
    if (event["ph"] == "X") said.push_back(event["args"].value("said", ""));
  }
  EXPECT_NE(std::find(said.begin(), said.end(), "boot"), said.end());
  const auto is_listen = [](const std::string& text) {
    return text.starts_with("IPStack: TCP Listen, endpoint ");
  };
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), is_listen));
}

TEST_F(RecordedWordsTest, ATableHasTheWholeContentInItsLastColumnIfValuesAreAskedFor) {
  const auto table = [&](bool values) {
    TraceReader reader(file_);
    std::vector<std::string> lines;
    std::string text;
    WriteTraceCsv(&reader, TraceFilter{.object = "RCServer", .service = "", .values = values},
                  [&](std::string_view piece) { text += piece; });
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  };
  const std::vector<std::string> with = table(true), without = table(false);
  ASSERT_EQ(with.size(), without.size());
  EXPECT_TRUE(without[0].ends_with(",bytes,payload_hash")) << without[0];
  EXPECT_TRUE(with[0].ends_with(",bytes,payload_hash,said")) << with[0];
  int boots = 0, requests = 0;
  size_t longest = 0;
  for (size_t i = 1; i < with.size(); ++i) {
    ASSERT_TRUE(with[i].starts_with(without[i] + ",")) << with[i];
    const std::string said = with[i].substr(without[i].size() + 1);
    boots += said == "boot";
    requests += said.starts_with("\"IPStack: TCP Listen, endpoint ");  // in quotes for its commas
    longest = std::max(longest, said.size());
  }
  EXPECT_EQ(boots, 2);  // DoInit and DoStart
  EXPECT_GT(requests, 0);
  EXPECT_GT(longest, 800u) << "a sensor vector is not cut";
}

// Returns whether `entry` is a message with the state of JointMover.
bool IsState(const TraceReader& reader, const TraceEntry& entry) {
  return entry.kind == TraceEntry::Kind::kMessage && !entry.payload.empty() &&
         reader.EntryName(entry.record.target, entry.record.selector)
             .ends_with("SetValueMessage.O (Notify)");
}

TEST_F(RecordedWordsTest, ADifferentValueIsNamedInWords) {
  const std::string copy = folder_.File("copy.rec");
  {
    TraceReader reader(file_);
    TraceWriter writer(copy, reader.header());
    bool is_changed = false;
    while (reader.Peek() != nullptr) {
      TraceEntry entry = reader.Take();
      if (!is_changed && IsState(reader, entry)) {
        is_changed = true;
        SetValueMessage state;
        ASSERT_EQ(entry.payload.size(), sizeof state);
        std::memcpy(&state, entry.payload.data(), sizeof state);
        state.commanded[0] = 174'533;  // 10 degrees
        state.commanded[1] = 349'066;
        entry.payload.assign(reinterpret_cast<const char*>(&state), sizeof state);
      }
      writer.AddEntry(entry);
    }
    ASSERT_TRUE(is_changed);
  }
  const std::string difference = Replay(copy);
  EXPECT_THAT(difference,
              ContainsRegex("SetValueMessage.O \\(Notify\\)\": state .*: byte [0-9]+ of "));
  EXPECT_THAT(difference, HasSubstr(" now, 'neck_tilt: commanded 10.00, measured "));
  EXPECT_THAT(difference, HasSubstr(" when recorded, and 1 more value"));
}

TEST_F(RecordedWordsTest, AMessageThatIsMissingIsNamedWithItsContent) {
  const std::string copy = folder_.File("copy.rec");
  {
    TraceReader reader(file_);
    TraceWriter writer(copy, reader.header());
    bool is_left_out = false;
    while (reader.Peek() != nullptr) {
      const TraceEntry entry = reader.Take();
      if (!is_left_out && IsState(reader, entry)) {
        is_left_out = true;
        continue;
      }
      writer.AddEntry(entry);
    }
    ASSERT_TRUE(is_left_out);
  }
  EXPECT_THAT(Replay(copy),
              ContainsRegex("now it is message [0-9]+ to .* that comes here: state "));
}

}  // namespace
}  // namespace openr_host
