// Recordings: written, read, replayed, damaged, stepped through.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "openr/inspect/recorder.h"
#include "openr/inspect/replayer.h"
#include "openr/inspect/trace_text.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;

class ReplayTest : public testing::Test {
 protected:
  ReplayTest() {
    std::string name = (fs::temp_directory_path() / "openr-replay-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    file_ = folder_ / "run.rec";
  }
  ~ReplayTest() override { fs::remove_all(folder_); }

  // A run of the stick, the pause button after a second.
  void Record(bool payloads = true, int64_t until_us = 2'000'000, bool has_end = true) {
    SimulationOptions options;
    options.stick = stick_;
    options.body = "ideal";
    options.host_network = false;
    options.console = [](std::string_view) {};
    Recorder recorder(file_, payloads);
    recorder.RecordNetworks(&options);
    Simulation simulation(options);
    recorder.Begin(&simulation, options, simulation.stick());
    System& system = simulation.system();
    system.Boot();
    system.RunUntil(1'000'000);
    EXPECT_EQ(system.inputs().Add(0, "press pause"), "");
    system.RunUntil(until_us);
    if (has_end) {
      EXPECT_EQ(recorder.Finish(&system), "");
    }
    messages_ = system.message_count();
    trace_hash_ = system.trace_hash();
  }

  std::string Replay() {
    Replayer replayer({.file = file_, .stick = "", .console = [](std::string_view) {}});
    replayer.RunUntil(INT64_MAX);
    count_ = replayer.count();
    problems_ = replayer.problems();
    EXPECT_TRUE(replayer.at_end() || !replayer.difference().empty());
    return replayer.difference();
  }

  // Takes the last `count` messages, and the inputs after them, out of the recording, whose end
  // stays where it was.
  void DropLast(uint64_t count) {
    const fs::path whole = folder_ / "whole.rec";
    fs::rename(file_, whole);
    TraceReader reader(whole);
    TraceWriter writer(file_, reader.header());
    bool is_late = false;
    while (reader.Peek() != nullptr) {
      const TraceEntry entry = reader.Take();
      const bool is_message = entry.kind == TraceEntry::Kind::kMessage;
      is_late = is_late || (is_message && entry.record.number > messages_ - count);
      if (!is_late || !(is_message || entry.kind == TraceEntry::Kind::kInput))
        writer.AddEntry(entry);
    }
    writer.Flush();
  }

  // XORs one byte of the file.
  void Flip(std::streamoff at) {
    std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const int byte = file.get();
    file.seekp(at);
    file.put(static_cast<char>(byte ^ 0x10));
  }

  // Returns what `openr replay --step` prints for these commands.
  std::string Step(const std::string& commands) {
    std::ofstream(folder_ / "commands") << commands;
    const std::string command = fmt::format("{} replay {} --step < {}", OPENR_PROGRAM,
                                            file_.string(), (folder_ / "commands").string());
    FILE* const pipe = popen(command.c_str(), "r");
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    EXPECT_EQ(pclose(pipe), 0) << text;
    return text;
  }

  // A stick with nothing but the keeper on it, for Record().
  void MakeKeepersStick() {
    const fs::path root = folder_ / "stick";
    fs::create_directories(root / "OPEN-R/MW/CONF");
    fs::create_directories(root / "OPEN-R/MW/OBJS");
    fs::copy_file(fs::path(OPENR_IMAGES) / "KEEPER.BIN", root / "OPEN-R/MW/OBJS/KEEPER.BIN");
    std::ofstream(root / "OPEN-R/MW/CONF/OBJECT.CFG") << "/MS/OPEN-R/MW/OBJS/KEEPER.BIN\n";
    std::ofstream(root / "OPEN-R/MW/CONF/CONNECT.CFG")
        << "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S "
           "Keeper.Sensor.OSensorFrameVectorData.O\n"
           "Keeper.Out.Number.S Keeper.In.Number.O\n";
    stick_ = root;
  }

  fs::path folder_, file_;
  std::string stick_;  // "": the default one
  uint64_t messages_ = 0, trace_hash_ = 0, count_ = 0;
  std::vector<std::string> problems_;
};

TEST_F(ReplayTest, ARecordingReplaysWithoutDifference) {
  Record();
  EXPECT_EQ(Replay(), "");
  EXPECT_EQ(count_, messages_);
  EXPECT_TRUE(problems_.empty());
}

TEST_F(ReplayTest, WithHashesOnlyAsWell) {
  Record();
  const auto whole = fs::file_size(file_);
  Record(false);
  EXPECT_LT(fs::file_size(file_), whole);
  EXPECT_EQ(Replay(), "");
  EXPECT_EQ(count_, messages_);
}

TEST_F(ReplayTest, TheReaderSeesWhatTheTraceSaw) {
  Record();
  TraceReader reader(file_);
  EXPECT_EQ(reader.header().images, "world");
  uint64_t messages = 0, hash = 0;
  int pauses = 0;
  while (reader.Peek() != nullptr) {
    const TraceEntry entry = reader.Take();
    messages += entry.kind == TraceEntry::Kind::kMessage;
    pauses += entry.kind == TraceEntry::Kind::kInput && entry.name == "press pause";
    if (entry.kind == TraceEntry::Kind::kEnd) hash = entry.trace_hash;
  }
  EXPECT_EQ(messages, messages_);
  EXPECT_EQ(pauses, 1);
  EXPECT_EQ(hash, trace_hash_);
}

// Wherever a byte of a message differs, the difference or the damage is named.
TEST_F(ReplayTest, AFlippedByteIsFoundAndNamed) {
  Record();
  const auto size = static_cast<std::streamoff>(fs::file_size(file_));
  int named = 0;
  for (std::streamoff at = 1000; at < size; at += size / 40) {
    SCOPED_TRACE(at);
    Flip(at);
    const std::string difference = Replay();
    ASSERT_FALSE(problems_.empty());
    EXPECT_NE(problems_[0].find("block "), std::string::npos) << problems_[0];
    named += difference.find("message ") != std::string::npos;
    Flip(at);
  }
  EXPECT_GT(named, 20);
  EXPECT_EQ(Replay(), "");
}

TEST_F(ReplayTest, AByteOfAPayloadIsNamedWithItsPlace) {
  Record();
  for (std::streamoff place = static_cast<std::streamoff>(fs::file_size(file_)) / 2;; ++place) {
    Flip(place);
    const std::string difference = Replay();
    Flip(place);
    if (difference.find(": byte ") == std::string::npos) continue;
    EXPECT_NE(difference.find("message "), std::string::npos) << difference;
    EXPECT_NE(difference.find(" -> "), std::string::npos) << difference;
    EXPECT_NE(difference.find("when recorded"), std::string::npos) << difference;
    break;
  }
}

TEST_F(ReplayTest, ACutFileIsUsedUpToItsLastBlock) {
  Record();
  fs::resize_file(file_, fs::file_size(file_) - 10);
  EXPECT_EQ(Replay(), "");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_NE(problems_[0].find("is cut off"), std::string::npos);
  EXPECT_LT(count_, messages_);
}

TEST_F(ReplayTest, MessagesAfterTheLastRecordedOneAreADifference) {
  Record(true, 1'000'000);
  DropLast(50);
  EXPECT_THAT(Replay(), ContainsRegex("after message [0-9]+: the recording has no further message "
                                      "before its end at t=1\\.000000 s, the run has message .* "
                                      "at t=0\\.9[0-9]+ s now"));
}

TEST_F(ReplayTest, AFileWithoutAnEndIsUsedAndItsNoteSaysThatTheEndIsNotKnown) {
  Record(true, 2'000'000, false);
  EXPECT_EQ(Replay(), "");
  EXPECT_TRUE(problems_.empty());
  EXPECT_EQ(count_, messages_);
  const std::string note = "openr: note: " + file_.string() +
                           ": the recording does not say how the run ended: its process was "
                           "killed, or it still runs\n";
  const ProgramResult trace = RunProgram({"trace", file_});
  EXPECT_EQ(trace.status, 0);
  EXPECT_EQ(trace.err, note);
  const ProgramResult replay = RunProgram({"replay", file_});
  EXPECT_EQ(replay.status, 0);
  EXPECT_EQ(replay.err.find(note), 0u) << replay.err;
}

TEST_F(ReplayTest, OtherFilesAreRefused) {
  std::ofstream(file_) << "something else";
  EXPECT_THROW(TraceReader{file_}, std::runtime_error);
  std::ofstream(file_, std::ios::binary) << "OPENRTRC" << std::string("\x09\0\0\0", 4);
  try {
    TraceReader reader(file_);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("version 9"), std::string::npos) << e.what();
  }
}

TEST_F(ReplayTest, AChangedStickIsRefused) {
  fs::copy(OPENR_STICK, folder_ / "stick", fs::copy_options::recursive);
  Record();
  std::ofstream(folder_ / "stick/OPEN-R/NEW.TXT") << "x";
  EXPECT_THROW(Replayer({.file = file_,
                         .stick = (folder_ / "stick").string(),
                         .console = [](std::string_view) {}}),
               std::runtime_error);
}

TEST_F(ReplayTest, ATraceOfAnObjectThatIsNotThereIsRefusedWithTheNamesThereAre) {
  Record();
  const ProgramResult result = RunProgram({"trace", file_, "--object", "Nope"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("there is no object 'Nope'; there are: "), std::string::npos);
  EXPECT_NE(result.err.find(", JointMover"), std::string::npos) << result.err;
  EXPECT_EQ(RunProgram({"trace", file_, "--service", "Nope"}).status, 1);
  EXPECT_EQ(RunProgram({"trace", file_, "--object", "JointMover"}).status, 0);
}

// Returns true if the entry's payload is what was hashed: the bytes of a message or a ready, or one
// or two regions of the same size of a notification to some observers (PayloadHash()).
bool HasItsHash(const TraceEntry& entry) {
  const auto hash_of = [&](size_t begin, size_t end) {
    return HashBytes(entry.payload.data() + begin, end - begin);
  };
  const size_t size = entry.payload.size();
  if (hash_of(0, size) == entry.record.payload_hash) return true;
  for (uint64_t observers = 0; observers < 8; ++observers) {
    const uint64_t one[] = {1, observers, hash_of(0, size)};
    const uint64_t two[] = {2, observers, hash_of(0, size / 2), hash_of(size / 2, size)};
    if (HashBytes(one, sizeof one) == entry.record.payload_hash) return true;
    if (HashBytes(two, sizeof two) == entry.record.payload_hash) return true;
  }
  return false;
}

// Versions before 5 wrote each message with its sender and receiver, and payloads in pieces.
TEST(OldRecordingTest, PayloadsOfVersion4AreRead) {
  TraceReader reader(OPENR_TEST_DATA "/version4.rec");
  int messages = 0, regions = 0;
  while (reader.Peek() != nullptr) {
    const TraceEntry entry = reader.Take();
    if (entry.kind != TraceEntry::Kind::kMessage) continue;
    ++messages;
    if (entry.payload.empty()) continue;
    EXPECT_TRUE(HasItsHash(entry)) << entry.record.number;
    regions += entry.payload.size() > 1000;
  }
  EXPECT_EQ(messages, 187);
  EXPECT_EQ(regions, 9);
  EXPECT_EQ(reader.problems(), std::vector<std::string>());
  EXPECT_EQ(reader.note(), "");
}

TEST_F(ReplayTest, PayloadsOfThisVersionHaveTheirHashes) {
  Record();
  TraceReader reader(file_);
  int payloads = 0, descriptions = 0;
  while (reader.Peek() != nullptr) {
    const TraceEntry entry = reader.Take();
    if (entry.kind != TraceEntry::Kind::kMessage || entry.payload.empty()) continue;
    // A message of the network stack has its description in place of its bytes.
    const bool is_described = entry.payload.starts_with("IPStack: ");
    EXPECT_TRUE(is_described || HasItsHash(entry)) << entry.record.number;
    ++payloads;
    descriptions += is_described;
  }
  EXPECT_GT(payloads, 300);
  EXPECT_GT(descriptions, 0);
}

// Version 2 had neither the battery nor the reason of the end.  This file is not all that a program
// of that time wrote: only its number of the version is.
TEST_F(ReplayTest, ARecordingOfTheVersionBeforeIsStillRead) {
  Record();
  std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(8);
  file.put(2);
  file.close();
  EXPECT_EQ(Replay(), "");
  EXPECT_EQ(count_, messages_);
}

TEST_F(ReplayTest, TextCsvAndPerfettoTellTheSameMessages) {
  Record();
  const auto write = [&](auto* function) {
    TraceReader reader(file_);
    std::string text;
    const TextSink out = [&](std::string_view piece) { text += piece; };
    function(&reader, TraceFilter{}, out);
    return text;
  };
  const std::string text = write(&WriteTraceText);
  EXPECT_NE(text.find("oobjectManager -> JointMover \"DoInit\""), std::string::npos);
  EXPECT_NE(text.find("input: robot 0 at t=1.000000: press pause"), std::string::npos);
  const std::string csv = write(&WriteTraceCsv);
  EXPECT_EQ(static_cast<uint64_t>(std::count(csv.begin(), csv.end(), '\n')), messages_ + 1);
  const auto perfetto = nlohmann::json::parse(write(&WriteTracePerfetto));
  uint64_t slices = 0, begins = 0, ends = 0;
  double last = -1;
  for (const auto& event : perfetto["traceEvents"]) {
    slices += event["ph"] == "X";
    begins += event["ph"] == "s";
    ends += event["ph"] == "f";
    if (event["ph"] != "X") continue;
    EXPECT_GT(event["ts"].get<double>(), last);
    last = event["ts"].get<double>();
  }
  EXPECT_EQ(slices, messages_);
  EXPECT_EQ(begins, ends);
  EXPECT_GT(begins, messages_ - 5);  // the boot and what came from outside have no cause
}

TEST_F(ReplayTest, GoingBackRestoresTheExactState) {
  Record();
  const std::string text = Step(
      "goto 100\nprint hash\nstep 400\nprint hash\nback 400\nprint hash\nstep 400\nprint hash\n"
      "goto 0.3s\nprint hash\ngoto 0.9s\ngoto 0.3s\nprint hash\nquit\n");
  std::vector<std::string> hashes;
  for (size_t at = text.find("trace "); at != std::string::npos; at = text.find("trace ", at + 1))
    hashes.push_back(text.substr(at, 45));
  ASSERT_EQ(hashes.size(), 6u) << text;
  EXPECT_EQ(hashes[2], hashes[0]);
  EXPECT_EQ(hashes[3], hashes[1]);
  EXPECT_NE(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[5], hashes[4]);
}

// If going back restored the map, the statics or the heap of the object wrongly, its messages after
// going back would differ from the recording.
TEST_F(ReplayTest, GoingBackRestoresWhatAnObjectKeeps) {
  MakeKeepersStick();
  Record(true, 10'000'000);
  ASSERT_GT(messages_, 2500u);  // several snapshots
  const std::string text = Step("run\nback 300\nback 1500\nstep 20\nback 60\nrun\nquit\n");
  EXPECT_EQ(text.find("difference"), std::string::npos) << text;
  const std::string end = "at the end of the recording";
  const size_t first = text.find(end);
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_NE(text.find(end, first + 1), std::string::npos) << text;
}

TEST_F(ReplayTest, BreaksStopWhereTheySayAndOutliveGoingBack) {
  Record();
  const std::string text = Step(
      "break state PowerMonitor nonsense\ndelete 1\nbreak service Effector.OCommandVectorData.O "
      "(Notify)\nrun\nback 5\nbreaks\n"
      "run\nprint waiting\nprint queue\nprint joints\nprint objects\nstop\nbreak this\nquit\n");
  EXPECT_NE(text.find("break 1: service Effector.OCommandVectorData.O (Notify)\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(") 1: service Effector.OCommandVectorData.O (Notify)\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("neck_pan"), std::string::npos) << text;
  // A message has its content on a line of its own.
  EXPECT_THAT(text, ContainsRegex("Effector.OCommandVectorData.O \\(Notify\\)\" [^\n]*\n"
                                  "        PRM:/r1/c1-Joint2:j1 to [^\n]* frames; "));
  EXPECT_NE(text.find("break object NAME, break service"), std::string::npos) << text;
  EXPECT_NE(text.find("no command 'stop'; did you mean 'step'?"), std::string::npos) << text;
}

TEST_F(ReplayTest, MessagesThatWaitHaveTheirContent) {
  Record();
  EXPECT_THAT(Step("step 5\nprint queue\nquit\n"),
              ContainsRegex("[0-9]+ due t=0.000000 to IPStack \"DoInit\": boot\n"));
}

TEST_F(ReplayTest, FindingsNameTheirMessages) {
  const ScratchFolder stick;
  stick.MakeTrouble("nan");
  const ProgramResult run = RunProgram({"run", "--rate", "max", "--for", "1s", "--no-panel",
                                        "--stick", stick.path(), "--record", file_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(Step("run\nprint findings\nquit\n"),
              ContainsRegex("Trouble: [^\n]*made NaN[^\n]* \\(message [0-9]+: boot\\)\n"));
}

TEST_F(ReplayTest, AConditionBreaksWhereItBeginsToHold) {
  Record();
  const std::string text = Step(
      "break when robots[0].joint.neck_pan << 3\nbreak when objects.JointMvoer.messages > 3\n"
      "break when objects.JointMover.messages >= 5\nrun\nprint objects.JointMover.messages\n"
      "back 1\nprint objects.JointMover.messages\nrun\nprint messages\nrun\nquit\n");
  EXPECT_NE(text.find("break when QUANTITY OP VALUE, like"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean 'JointMover'?"), std::string::npos) << text;
  const size_t hit = text.find("objects.JointMover.messages is 5\n");
  ASSERT_NE(hit, std::string::npos) << text;
  EXPECT_NE(text.find("objects.JointMover.messages is 4\n", hit), std::string::npos) << text;
  EXPECT_NE(text.find("break 1: ", hit), std::string::npos) << "again after going back\n" << text;
  EXPECT_NE(text.find("at the end of the recording"), std::string::npos)
      << "it holds for the rest and does not stop again\n"
      << text;
}

TEST_F(ReplayTest, GotoTakesTheNumbersThatTracesShow) {
  Record();
  const std::string text =
      Step("goto 300\ngoto 0\ngoto 300\ngoto 99999999\ngoto -1\nback -5\nstep abc\nquit\n");
  const std::string shown = ") " + std::string(4, ' ') + "300 t=";
  const size_t first = text.find(shown);
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_NE(text.find(shown, first + 1), std::string::npos) << text;
  EXPECT_NE(text.find("the recording has no message 99999999"), std::string::npos) << text;
  EXPECT_NE(text.find("'-1' is neither a number of a message nor"), std::string::npos) << text;
  EXPECT_NE(text.find("'-5' is no number"), std::string::npos) << text;
  EXPECT_NE(text.find("'abc' is no number"), std::string::npos) << text;
}

TEST_F(ReplayTest, AThousandMessagesBackIsTheExactState) {
  MakeKeepersStick();
  Record(true, 10'000'000);
  const std::string text =
      Step("step 1200\nprint hash\nstep 1000\nprint hash\nback 1000\nprint hash\nquit\n");
  std::vector<std::string> hashes;
  for (size_t at = text.find("trace "); at != std::string::npos; at = text.find("trace ", at + 1))
    hashes.push_back(text.substr(at, 45));
  ASSERT_EQ(hashes.size(), 3u) << text;
  EXPECT_NE(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

// After so many messages, many of the processes that were snapshots have been ended.
TEST_F(ReplayTest, GoingBackIsExactAfterSnapshotsWereThinnedOut) {
  MakeKeepersStick();
  Record(true, 120'000'000);
  ASSERT_GT(messages_, 25'000u);
  const std::string text = Step(
      "step 2500\nprint hash\nstep 2500\nprint hash\ngoto 60s\nprint hash\nstep 99999\n"
      "goto 60s\nprint hash\nstep 99999\nback 5\nback 20000\nstep 99999\n"
      "goto 0\nstep 5000\nprint hash\nstep 99999\nback 20000\ngoto 0\nstep 2500\nprint hash\n"
      "quit\n");
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("difference")));
  std::vector<std::string> hashes;
  for (size_t at = text.find("trace "); at != std::string::npos; at = text.find("trace ", at + 1))
    hashes.push_back(text.substr(at, 45));
  ASSERT_EQ(hashes.size(), 6u) << text;
  EXPECT_NE(hashes[0], hashes[1]);
  EXPECT_NE(hashes[1], hashes[2]);
  EXPECT_EQ(hashes[3], hashes[2]);
  EXPECT_EQ(hashes[4], hashes[1]);
  EXPECT_EQ(hashes[5], hashes[0]);
}

// The run writes to the stick; the stick is then another one than it began with.
TEST_F(ReplayTest, WhatTheRunChangedOnTheStickIsPutBack) {
  MakeKeepersStick();
  const fs::path data = fs::path(stick_) / "OPEN-R/MW/DATA/P";
  fs::create_directories(data);
  std::ofstream(data / "KEPT.TXT") << "before\n";
  Record();
  std::ifstream kept(data / "KEPT.TXT");
  std::string line;
  std::getline(kept, line);
  ASSERT_EQ(line, "1") << "the keeper writes what it keeps";
  EXPECT_EQ(Replay(), "");
  EXPECT_EQ(count_, messages_);
  EXPECT_TRUE(fs::exists(data / "KEPT.TXT"));
  std::ofstream(data / "OTHER.TXT") << "somebody else's\n";
  EXPECT_THROW(Replay(), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
