// Uses of recordings: failing runs of openr explore, runs that go on live, one object
// alone, timelines.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "openr/inspect/answer_difference.h"
#include "openr/inspect/recorder.h"
#include "openr/inspect/replayer.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class RecordingsTest : public testing::Test {
 protected:
  RecordingsTest() {
    std::string name = (fs::temp_directory_path() / "openr-recordings-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  ~RecordingsTest() override { fs::remove_all(folder_); }

  std::string At(const std::string& name) const { return folder_ / name; }
  static ProgramResult Openr(const std::vector<std::string>& arguments) {
    return ProgramRun(arguments).Finish();
  }
  // Records a run of three seconds with the pause button pressed after one, unless `events` has
  // other inputs.
  void Record(const std::string& events = "1s press chin for 200ms\n") {
    std::ofstream(At("day.events")) << events;
    const ProgramResult run = Openr({"run", "--rate", "max", "--for", "3s", "--no-panel", "--body",
                                     "ideal", "--stick", OPENR_STICK, "--console", "/dev/null",
                                     "--events", At("day.events"), "--record", At("run.rec")});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  static std::string Content(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

TEST_F(RecordingsTest, FailingRunOfAnExplorationIsARecording) {
  const ProgramResult explored =
      Openr({"explore", "--stick", OPENR_STICK, "--for", "1s", "--runs", "200", "--property",
             "busy: always objects.Controller.queue_max < 3", "-o", At("failure.json"), "--record",
             At("failure.rec")});
  ASSERT_EQ(explored.status, 1) << explored.err;
  ASSERT_TRUE(fs::exists(At("failure.rec"))) << explored.err;
  const ProgramResult replayed = Openr({"replay", At("failure.rec"), "--json"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  const json answer = json::parse(replayed.out);
  EXPECT_TRUE(answer["equal"].get<bool>()) << replayed.err;
  EXPECT_THAT(answer["ended_why"].get<std::string>(), HasSubstr("'busy' is broken"));
  // The same from the file of the order.
  const ProgramResult again =
      Openr({"explore", "--replay", At("failure.json"), "--record", At("again.rec")});
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(Content(At("again.rec")), Content(At("failure.rec")));
  // A run of openr explore cannot go on in another way.
  const ProgramResult on = Openr({"replay", At("failure.rec"), "--continue-at", "0s"});
  EXPECT_EQ(on.status, 1);
  EXPECT_THAT(on.err, HasSubstr("is a run of openr explore"));
}

TEST_F(RecordingsTest, RunGoesOnFromAMomentOfItsRecording) {
  Record();
  const ProgramResult on = Openr({"replay", At("run.rec"), "--continue-at", "2s", "--for", "2s",
                                  "--rate", "max", "--record", At("new.rec")});
  ASSERT_EQ(on.status, 0) << on.err;
  EXPECT_THAT(on.err, HasSubstr("goes on from t=2.000 s"));
  EXPECT_THAT(on.err, HasSubstr("openr rc 127.0.0.1:"));
  const ProgramResult replayed = Openr({"replay", At("new.rec"), "--json"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  const json answer = json::parse(replayed.out);
  EXPECT_TRUE(answer["equal"].get<bool>()) << replayed.err;
  EXPECT_DOUBLE_EQ(answer["virtual_time_s"].get<double>(), 4);
  EXPECT_THAT(Openr({"trace", At("new.rec")}).out, HasSubstr("press chin for 200ms"));
  // The recording of a continued run can be continued itself.
  EXPECT_EQ(
      Openr({"replay", At("new.rec"), "--continue-at", "3500ms", "--for", "100ms", "--rate", "max"})
          .status,
      0);
}

// Nothing that happens after the moment depends on whether the run was continued.
TEST_F(RecordingsTest, RunThatGoesOnWithoutClientsIsTheRunItWas) {
  Record("");
  ASSERT_EQ(Openr({"replay", At("run.rec"), "--continue-at", "1s", "--for", "2s", "--rate", "max",
                   "--record", At("new.rec")})
                .status,
            0);
  const auto messages = [this](const std::string& name) {
    return Openr({"trace", At(name), "--format", "csv"}).out;
  };
  EXPECT_EQ(messages("new.rec"), messages("run.rec"));
}

TEST_F(RecordingsTest, MomentsThatDoNotExistAreRefused) {
  Record();
  const ProgramResult late = Openr({"replay", At("run.rec"), "--continue-at", "1min"});
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(late.err, HasSubstr("has nothing at t=60s; it ends at t=3s"));
  EXPECT_EQ(Openr({"replay", At("run.rec"), "--record", At("a.rec")}).status, 2);
  EXPECT_EQ(Openr({"replay", At("run.rec"), "--continue-at", "1s", "--step"}).status, 2);
}

TEST_F(RecordingsTest, SameBuildOfAnObjectAnswersAsRecorded) {
  Record();
  const ProgramResult result = Openr({"replay", At("run.rec"), "--only", "JointMover", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json answer = json::parse(result.out);
  EXPECT_GT(answer["answers"].get<int>(), 50);
  EXPECT_TRUE(answer["answer_differences"].empty());
  const ProgramResult lower = Openr({"replay", At("run.rec"), "--only", "jointmover", "--json"});
  ASSERT_EQ(lower.status, 0) << lower.err;
  EXPECT_THAT(lower.err, HasSubstr(" of JointMover, all as recorded"));
  EXPECT_EQ(json::parse(lower.out), answer);
  EXPECT_EQ(answer["only"], "JointMover");
  const ProgramResult wrong = Openr({"replay", At("run.rec"), "--only", "JointMovr"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.err, HasSubstr("no object 'JointMovr'; did you mean 'JointMover'?"));
}

// A recording in which one answer of JointMover has another byte stands for a build of it that
// answers so.  The message is its state, which RCServer only keeps for clients.
TEST_F(RecordingsTest, OtherAnswersAreNamedAndTheOthersGetTheRecordedOnes) {
  Record();
  uint64_t changed = 0;
  {
    TraceReader reader(At("run.rec"));
    TraceWriter writer(At("other.rec"), reader.header());
    int count = 0;
    while (reader.Peek() != nullptr) {
      TraceEntry entry = reader.Take();
      const TraceRecord& record = entry.record;
      const bool is_answer =
          entry.kind == TraceEntry::Kind::kMessage &&
          reader.ObjectName(record.sender) == "JointMover" &&
          reader.ObjectName(record.target) == "RCServer" &&
          reader.EntryName(record.target, record.selector).find("(Notify)") != std::string::npos;
      if (is_answer && ++count == 1) {
        changed = record.number;
        entry.payload.back() ^= 1;
        entry.record.payload_hash ^= 1;
      }
      writer.AddEntry(entry);
    }
  }
  ASSERT_GT(changed, 0U);
  const ProgramResult whole = Openr({"replay", At("other.rec")});
  EXPECT_EQ(whole.status, 1);
  EXPECT_THAT(whole.err, ContainsRegex(fmt::format(
                             "difference: message {} [^\n]* \\(Notify\\)\": state ", changed)));
  const ProgramResult only = Openr({"replay", At("other.rec"), "--only", "JointMover", "--json"});
  EXPECT_EQ(only.status, 1);
  const json answer = json::parse(only.out);
  EXPECT_THAT(only.err, HasSubstr(" of JointMover, 2 other than recorded\n"));
  EXPECT_THAT(only.err, HasSubstr(" messages replayed, 3.000 s of virtual time"));
  EXPECT_THAT(only.err, Not(HasSubstr(" equal,")));
  // RCServer and Controller get the same region, so the recorded bytes reach Controller, too.
  ASSERT_EQ(answer["answer_differences"].size(), 2U) << only.err;
  const json& difference = answer["answer_differences"][0];
  EXPECT_EQ(difference["message"], changed);
  EXPECT_EQ(difference["receiver"], "RCServer");
  EXPECT_EQ(difference["bytes_different"], 1);
  EXPECT_EQ(difference["first_byte"].get<int>(), difference["bytes"].get<int>() - 1);
  EXPECT_TRUE(answer["at_end"].get<bool>());
  EXPECT_EQ(answer["difference"], "");
}

TEST_F(RecordingsTest, DifferentValuesAreNamedWithBothTexts) {
  const RobotModel model = LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/ers210.json");
  const std::string then(48, '\0');
  std::string now = then;
  now[40] = 1;
  const AnswerDifference difference = CompareAnswer(model, "A.B.Unknown.O (Notify)", now, then);
  EXPECT_EQ(difference.first, 40U);
  EXPECT_EQ(difference.count, 1U);
  ASSERT_EQ(difference.now.size(), 1U);
  EXPECT_THAT(difference.now[0], HasSubstr(" 1 "));
  EXPECT_THAT(DescribeAnswer(difference), HasSubstr("1 of 0 bytes differ, from byte 40 on"));
}

TEST_F(RecordingsTest, ValuesOfMessagesAreShown) {
  Record();
  const ProgramResult trace =
      Openr({"trace", At("run.rec"), "--values", "--object", "JointMover", "--until", "300ms"});
  ASSERT_EQ(trace.status, 0);
  EXPECT_THAT(trace.out, HasSubstr(" deg in "));
  EXPECT_THAT(trace.out, HasSubstr("        ready (assert)"));
}

TEST_F(RecordingsTest, TimelineHasASliceForEachMessage) {
  Record();
  const ProgramResult replayed =
      Openr({"replay", At("run.rec"), "--timeline", At("a.json"), "--json"});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  const uint64_t messages = json::parse(replayed.out)["messages"];
  const json timeline = json::parse(Content(At("a.json")));
  uint64_t slices = 0;
  int boots = 0, vectors = 0;
  double last = -1;
  for (const json& event : timeline["traceEvents"]) {
    if (event["ph"] != "X") continue;
    ++slices;
    const std::string said = event["args"].value("said", "");
    boots += said == "boot";
    vectors += said.starts_with("PRM:/r1/c1-Joint2:j1 ");
    EXPECT_GE(event["ts"].get<double>(), last);
    last = event["ts"];
    EXPECT_TRUE(event["args"].contains("wall_us"));
    EXPECT_GE(event["ts"].get<double>(), event["args"]["virtual_time_s"].get<double>() * 1e6 - 1);
  }
  EXPECT_EQ(slices, messages);
  EXPECT_GE(boots, 8);  // DoInit and DoStart of four objects
  EXPECT_GT(vectors, 50);
  const ProgramResult wrong = Openr({"replay", At("run.rec"), "--timeline", At("a.txt")});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("ends in .json"));
}

TEST_F(RecordingsTest, SlicesAreAsLongAsTheCostFileSays) {
  std::ofstream(At("a.cost")) << "JointMover DoStart 20000\n";
  const ProgramResult run = Openr({"run", "--rate", "max", "--for", "1s", "--no-panel", "--body",
                                   "ideal", "--stick", OPENR_STICK, "--console", "/dev/null",
                                   "--cost", At("a.cost"), "--timeline", At("a.json")});
  ASSERT_EQ(run.status, 0) << run.err;
  int starts = 0;
  const json timeline = json::parse(Content(At("a.json")));
  for (const json& event : timeline["traceEvents"]) {
    if (event["ph"] != "X" || event["name"] != "DoStart") continue;
    if (!event["args"].contains("cost_us") || event["args"]["cost_us"] == 0) continue;
    ++starts;
    EXPECT_EQ(event["args"]["cost_us"], 20000);
    EXPECT_EQ(event["dur"], 20000);
  }
  EXPECT_EQ(starts, 1);
}

}  // namespace
}  // namespace openr_host
