// Why a run ended: the last line on the screen and `ended_by` in the report (docs/cli.md).
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

using Words = std::vector<std::string>;

Words RunWords(const Words& more) {
  Words words{"run", "--rate", "max", "--rc-port", "0", "--body", "ideal"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void ExpectEnd(const ProgramResult& result, const std::string& report, const std::string& by,
               const std::string& why) {
  const json parsed = json::parse(report, nullptr, false);
  ASSERT_TRUE(parsed.is_object()) << result.err;
  EXPECT_EQ(parsed.value("ended_by", json()), by) << result.err;
  EXPECT_THAT(parsed.value("ended_why", ""), HasSubstr(why));
  EXPECT_THAT(result.err,
              EndsWith("\nended by " + by + ": " + parsed.value("ended_why", "no reason") + "\n"));
}

void ExpectEndOf(const Words& words, int status, const std::string& by, const std::string& why) {
  Words all = RunWords(words);
  all.push_back("--json");
  const ProgramResult result = RunProgram(all);
  EXPECT_EQ(result.status, status) << result.err;
  ExpectEnd(result, result.out, by, why);
}

void ExpectEndOfTrouble(const std::string& word, const Words& more, int status,
                        const std::string& by, const std::string& why) {
  const ScratchFolder stick;
  stick.MakeTrouble(word);
  Words words{"--stick", stick.path()};
  words.insert(words.end(), more.begin(), more.end());
  ExpectEndOf(words, status, by, why);
}

TEST(EndingTest, TheTimeThatWasAskedFor) {
  ExpectEndOfTrouble("nothing", {"--for", "100ms"}, 0, "time", "--for 100ms is over");
}

TEST(EndingTest, TheTimeThatWasAskedForAsThePersonWroteIt) {
  ExpectEndOfTrouble("nothing", {"--for", "6000s"}, 0, "time", "--for 6000s is over");
  ExpectEndOfTrouble("nothing", {"--for", "0.5min"}, 0, "time", "--for 0.5min is over");
}

TEST(EndingTest, Silence) {
  ExpectEndOfTrouble("nothing", {"--until-idle"}, 0, "idle", "for 1 s (--until-idle)");
}

TEST(EndingTest, AnObjectThatShutsTheRobotDown) {
  ExpectEndOfTrouble("shutdown", {}, 0, "power-off", "Trouble shut the robot down");
}

TEST(EndingTest, AnObjectThatCallsFatal) {
  ExpectEndOfTrouble("fatal", {}, 1, "fatal", "Trouble called OPENR::Fatal(");
}

TEST(EndingTest, ACrashIsInTheReportAndInTheLastLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer reports crashes itself";
#endif
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result = RunProgram(RunWords({"--stick", stick.path(), "--json"}));
  EXPECT_EQ(result.status, 1);
  ExpectEnd(result, result.out, "crash", "crash: SIGSEGV");
}

TEST(EndingTest, AHandlerThatDoesNotReturn) {
  ExpectEndOfTrouble("hang", {"--handler-limit", "200ms"}, 1, "handler-limit",
                     "a handler does not return: DoStart");
}

TEST(EndingTest, AShortLimitOfHandlersIsToldExactly) {
  ExpectEndOfTrouble("hang", {"--handler-limit", "250ms"}, 1, "handler-limit",
                     "has used more than 0.25 s of processor time");
}

TEST(EndingTest, ARobotThatDoesNotBoot) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  std::filesystem::remove(stick.File("OPEN-R/MW/OBJS/TROUBLE.BIN"));
  ExpectEndOf({"--stick", stick.path(), "--for", "1s"}, 1, "no-boot", "the findings say why");
}

// field-notes.md 4.6
TEST(EndingTest, OnlyACrashLeavesARecord) {
  const auto leaves_record = [](const std::string& word, const std::string& events,
                                const Words& more, int status, const std::string& by) {
    const ScratchFolder stick;
    stick.MakeTrouble(word);
    const std::string image = stick.File("OPEN-R/MW/OBJS/TROUBLE.BIN");
    if (word == "absent") std::filesystem::remove(image);
    if (word == "cut off") std::filesystem::resize_file(image, 5000);
    Words words{"--stick", stick.path(), "--for", "1s"};
    words.insert(words.end(), more.begin(), more.end());
    if (!events.empty()) {
      stick.Write("run.events", events);
      words.insert(words.end(), {"--events", stick.File("run.events")});
    }
    ExpectEndOf(words, status, by, "");
    return std::filesystem::exists(stick.File("OPEN-R/EMON.LOG"));
  };
  EXPECT_FALSE(leaves_record("nothing", "0.1s heat battery 71\n", {"--strict"}, 1, "strict"));
  EXPECT_FALSE(leaves_record("nothing", "0.1s draw 9000 for 1s\n", {"--strict"}, 1, "strict"));
  EXPECT_FALSE(leaves_record("hang", "", {"--handler-limit", "200ms"}, 1, "handler-limit"));
  EXPECT_FALSE(leaves_record("absent", "", {}, 1, "no-boot"));
  EXPECT_FALSE(leaves_record("cut off", "", {}, 1, "no-boot"));
#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reports crashes itself
  EXPECT_TRUE(leaves_record("crash", "", {}, 1, "crash"));
#endif
}

// field-notes.md 4.6.  Somebody holds a leg: the ERS-210 shuts down after 30 s of load, the ERS-7
// finds a jam.
TEST(EndingTest, AJointThatIsHeldLeavesNoRecordWhenStrict) {
  for (const auto& [robot, why] : {std::pair{"ers210", ""}, std::pair{"ers7", "was jammed"}}) {
    const ScratchFolder stick;
    std::filesystem::copy(OPENR_STICK, stick.path(), std::filesystem::copy_options::recursive);
    stick.Write("run.events", "14s turn LF_j2 60 for 40s\n");
    const ProgramResult result = RunProgram(
        {"run", "--rate", "max", "--rc-port", "0", "--stick", stick.path(), "--robot", robot,
         "--events", stick.File("run.events"), "--for", "60s", "--strict", "--json"});
    EXPECT_EQ(result.status, 1) << result.err;
    ExpectEnd(result, result.out, "strict", why);
    EXPECT_FALSE(std::filesystem::exists(stick.File("OPEN-R/EMON.LOG"))) << robot;
  }
}

// A line that cannot be read, and one whose object is not there, which is known after DoInit.
TEST(EndingTest, AStickThatStrictRefuses) {
  for (const char* line : {"Trouble.Out.Text.S\n", "Nobody.Out.Text.S Trouble.In.Text.O\n"}) {
    const ScratchFolder stick;
    stick.MakeTrouble("nothing");
    stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", line);
    ExpectEndOf({"--stick", stick.path(), "--strict", "--for", "1s"}, 1, "no-boot", "--strict");
  }
}

TEST(EndingTest, ABatteryThatIsLow) {
  ExpectEndOf({"--battery", "10%", "--for", "1min"}, 0, "battery",
              "PowerMonitor shut the robot down with 9 % left in its battery; --battery 100%");
}

TEST(EndingTest, ABatteryThatStaysFullEndsNothing) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  ExpectEndOf({"--battery", "100%", "--for", "1min"}, 0, "time", "--for 1min is over");
}

TEST(EndingTest, ABatteryThatIsLowFromTheBootOnEndsNothingAndANoteSaysSo) {
  for (const bool is_low : {true, false}) {
    const ProgramResult result = RunProgram(
        RunWords({"--battery", is_low ? "9%" : "10%", "--for", "1s", "--robots", "2", "--json"}));
    EXPECT_EQ(result.status, 0) << result.err;
    const json report = json::parse(result.out);
    std::vector<json> notes;
    for (const json& finding : report["findings"]) {
      // Another run on this machine may have the port of the second robot, which is a finding too.
      if (finding["text"].get<std::string>().starts_with("--battery")) notes.push_back(finding);
    }
    ASSERT_EQ(notes.size(), is_low ? 1u : 0u);
    if (!is_low) continue;
    EXPECT_EQ(notes[0]["severity"], "note");
    EXPECT_THAT(result.err, HasSubstr("note: --battery 9%: "));
    EXPECT_THAT(result.err, HasSubstr("so the battery does not end the run; give 10% or more"));
  }
}

TEST(EndingTest, ABatteryThatMakesNoSenseIsAWrongCommandLine) {
  for (const char* wrong : {"0%", "101%", "50", "full", ""}) {
    const ProgramResult result = RunProgram(RunWords({"--battery", wrong, "--for", "1s"}));
    EXPECT_EQ(result.status, 2) << wrong;
    EXPECT_THAT(result.err, HasSubstr("100% (stays full), drain (full at boot)")) << wrong;
  }
}

// By an object that watches the button, and by the program when none does.
TEST(EndingTest, ThePauseButton) {
  const ScratchFolder folder;
  folder.MakeTrouble("nothing");
  for (const bool is_watched : {true, false}) {
    Words words = RunWords({"--report", folder.File("r.json")});
    if (!is_watched) words.insert(words.end(), {"--stick", folder.path()});
    ProgramRun run(words);
    ASSERT_TRUE(run.WaitFor(is_watched ? "state: sleeping" : "is running"));
    run.Signal(SIGINT);
    const ProgramResult& result = run.Finish();
    EXPECT_EQ(result.status, 0) << result.err;
    ExpectEnd(result, folder.Read("r.json"), "pause",
              is_watched ? "PowerMonitor shut the robot down after the pause button"
                         : "no object shut the robot down within 1 s");
  }
}

TEST(EndingTest, ASecondSignal) {
  const ScratchFolder folder;
  folder.MakeTrouble("nothing");
  ProgramRun run({"run", "--rate", "0.01", "--rc-port", "0", "--body", "ideal", "--stick",
                  folder.path(), "--report", folder.File("r.json")});
  ASSERT_TRUE(run.WaitFor("is running"));
  for (const int signal : {SIGSTOP, SIGINT, SIGTERM, SIGCONT}) run.Signal(signal);  // both at once
  const ProgramResult& result = run.Finish();
  ExpectEnd(result, folder.Read("r.json"), "signal", "came again");
}

TEST(EndingTest, ASecondSignalEndsAHandlerThatDoesNotReturn) {
  for (const char* const word : {"sayhang", "lock"}) {
    SCOPED_TRACE(word);
    const ScratchFolder folder;
    folder.MakeTrouble(word);
    ProgramRun run(RunWords(
        {"--stick", folder.path(), "--handler-limit", "0s", "--report", folder.File("r.json")}));
    ASSERT_TRUE(run.WaitFor("it hangs now"));
    for (const int signal : {SIGSTOP, SIGINT, SIGTERM, SIGCONT}) run.Signal(signal);
    const ProgramResult& result = run.Finish();
    EXPECT_EQ(result.status, 1);
    ExpectEnd(result, folder.Read("r.json"), "signal",
              "Trouble: a handler does not return: DoStart (selector 1) still ran 1 s after Ctrl-C "
              "or SIGTERM had come twice");
  }
}

// More than three are sent: one that comes while the one before is not yet heard is lost.
TEST(EndingTest, AThirdSignalSaysThatThereIsNoReport) {
  const ScratchFolder stick;
  stick.MakeTrouble("hang");
  ProgramRun run(RunWords({"--stick", stick.path(), "--handler-limit", "0s"}));
  ASSERT_TRUE(run.WaitFor(" Trouble\n"));
  for (int i = 0; i < 100; ++i) {
    run.Signal(SIGTERM);
    usleep(10'000);
  }
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, EndsWith("\nended by signal: Ctrl-C or SIGTERM came three times; no "
                                   "report is written\n"));
}

TEST(EndingTest, OfSeveralRobotsEachSaysItself) {
  const ScratchFolder stick;
  stick.MakeTrouble("shutdown");
  const ProgramResult result =
      RunProgram(RunWords({"--stick", stick.path(), "--robots", "2", "--json"}));
  const json report = json::parse(result.out);
  EXPECT_EQ(report["ended_by"], "power-off");
  for (const json& robot : report["robots"]) EXPECT_EQ(robot["ended_by"], "power-off");
  EXPECT_EQ(
      json::parse(RunProgram(RunWords({"--for", "100ms", "--json"})).out)["robots"][0]["ended_by"],
      nullptr);
}

TEST(EndingTest, AReplaySaysWhyTheRecordedRunEnded) {
  const ScratchFolder folder;
  const std::string file = folder.File("run.rec");
  ProgramResult result = RunProgram(
      RunWords({"--battery", "10%", "--for", "1min", "--record", file, "--no-payloads"}));
  ASSERT_EQ(result.status, 0) << result.err;
  result = RunProgram({"replay", file, "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json answer = json::parse(result.out);
  EXPECT_TRUE(answer["equal"]);
  EXPECT_EQ(answer["ended_by"], "battery");
  EXPECT_THAT(answer["ended_why"].get<std::string>(), HasSubstr("with 9 % left"));
  EXPECT_THAT(result.err, HasSubstr("the recorded run was ended by battery: "));
  EXPECT_THAT(RunProgram({"trace", file}).out, HasSubstr("\nended by battery: PowerMonitor"));
}

// Records a run on a stick whose object does `word`, and returns what openr trace shows of it.
ProgramResult TraceOfTrouble(const std::string& word) {
  const ScratchFolder folder;
  folder.MakeTrouble(word);
  const std::string file = folder.File("run.rec");
  RunProgram(RunWords({"--stick", folder.path(), "--record", file, "--handler-limit", "200ms"}));
  return RunProgram({"trace", file});
}

TEST(EndingTest, ARecordingOfACrashHasTheReason) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer reports crashes itself";
#endif
  const ProgramResult result = TraceOfTrouble("crash");
  EXPECT_THAT(result.out, HasSubstr("ended by crash: Trouble: crash: SIGSEGV"));
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.status, 0);
}

TEST(EndingTest, ARecordingOfAHandlerThatDoesNotReturnHasTheReason) {
  const ProgramResult result = TraceOfTrouble("hang");
  EXPECT_THAT(result.out, HasSubstr("ended by handler-limit: Trouble: a handler does not return"));
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.status, 0);
}

TEST(EndingTest, AReplayHasAHandlerLimitOfItsOwn) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("hang");
  const std::string file = files.File("run.rec");
  RunProgram(RunWords({"--stick", stick.path(), "--record", file, "--handler-limit", "200ms"}));
  const ProgramResult result = RunProgram({"replay", file, "--handler-limit", "300ms"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("has used more than 0.3 s of processor time"));
  EXPECT_THAT(result.err, ContainsRegex("\nMESSAGE from oobjectManager, [0-9]+ bytes\n"));
  EXPECT_THAT(result.err, ContainsRegex("\nopenr: message [0-9]+: boot\n"));
  EXPECT_EQ(RunProgram({"replay", file, "--step", "--handler-limit", "1s"}).status, 2);
}

TEST(EndingTest, AnExplorationCountsTheReasons) {
  const ScratchFolder stick;
  stick.MakeTrouble("shutdown");
  const ProgramResult result =
      RunProgram({"explore", "--stick", stick.path(), "--runs", "3", "--for", "1s", "--jobs", "1",
                  "--battery", "50%", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["ended_by"], json({{"power-off", 3}}));
  EXPECT_THAT(result.err, HasSubstr("ended before their time: 3 by power-off\n"));
}

TEST(EndingTest, AClientWhoseRunEndsIsToldWhereItSaysWhy) {
  ProgramRun run(RunWords({}));
  const std::string said = " rc 127.0.0.1:";
  ASSERT_TRUE(run.WaitFor(said));
  ASSERT_TRUE(run.WaitFor("state: sleeping"));
  const std::string port =
      std::to_string(std::stoi(run.heard().substr(run.heard().find(said) + said.size())));
  ProgramRun client({"rc", "127.0.0.1:" + port, "sensors", "--watch", "--every", "10ms"});
  ASSERT_TRUE(client.WaitForOutput("battery"));
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 0);
  EXPECT_EQ(client.Finish().status, 1);
  EXPECT_THAT(client.heard(), HasSubstr("(\"ended by ...\") and 'ended_by' in its report say why"));
}

// A port of this computer that somebody listens on.
class TakenPort {
 public:
  explicit TakenPort(uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    // As the program binds it, which connections of the last minute do not keep from that.
    const int on = 1;
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    socklen_t size = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    const bool is_bound = bind(socket_, generic, size) == 0 && listen(socket_, 1) == 0;
    if (is_bound && getsockname(socket_, generic, &size) == 0) port_ = ntohs(address.sin_port);
  }
  ~TakenPort() { close(socket_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  uint16_t port() const { return port_; }  // 0: somebody else has it

 private:
  const int socket_;
  uint16_t port_ = 0;
};

TEST(RcPortTest, ATakenOneThatWasAskedForIsRefusedBeforeAnythingStarts) {
  const TakenPort taken(0);
  const ScratchFolder folder;
  const ProgramResult result =
      RunProgram({"run", "--for", "1s", "--rate", "max", "--rc-port", std::to_string(taken.port()),
                  "--record", folder.File("run.rec"), "--report", folder.File("r.json")});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("--rc-port: port " + std::to_string(taken.port()) +
                                    " of this computer cannot be had: Address already in use"));
  EXPECT_THAT(result.err, Not(HasSubstr("[oid:")));
  EXPECT_FALSE(std::filesystem::exists(folder.File("run.rec")));
  EXPECT_FALSE(std::filesystem::exists(folder.File("r.json")));
}

TEST(RcPortTest, WithoutAWishTheNextFreeOneIsTaken) {
  const TakenPort taken(54000);  // or somebody else has it: as good
  const ProgramResult result =
      RunProgram({"run", "--for", "500ms", "--rate", "max", "--body", "ideal", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const int port = json::parse(result.out)["rc_port"].get<int>();
  EXPECT_GT(port, 54000);
  EXPECT_LE(port, 54100);
}

}  // namespace
}  // namespace openr_host
