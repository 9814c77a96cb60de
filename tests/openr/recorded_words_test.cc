// Recordings with messages in words: those of the network stack, and what traces show.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "openr/inspect/replayer.h"
#include "openr/inspect/trace_text.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

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

}  // namespace
}  // namespace openr_host
