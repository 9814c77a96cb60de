// The panel of a real run: what it does, and that it does not disturb the run.
#include <fcntl.h>
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/openr/panel_server.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// Returns the bytes of a file; those that can be read of a process that ends meanwhile.
std::string ReadAll(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class PanelRunTest : public PanelTest {
 protected:
  // Starts a run whose panel is at port_.
  std::unique_ptr<ProgramRun> Start(std::vector<std::string> flags = {}) {
    std::vector<std::string> arguments = {"run",     "--rc-port",    "0", "--body",     "ideal",
                                          "--panel", "--panel-port", "0", "--run-name", "shown"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    auto run = std::make_unique<ProgramRun>(arguments);
    EXPECT_TRUE(run->WaitFor("panel: ")) << run->heard();
    EXPECT_TRUE(run->WaitUntil([&] {
      const std::string& text = run->heard();
      return text.find('\n', text.find("panel: ")) != std::string::npos;
    }));
    ReadAddress(run->heard());
    return run;
  }

  // Returns the process id of the panel's server of `run`; 0 if there is none.
  static int ServerOf(const ProgramRun& run) {
    std::string words = "panel";
    words += '\0';
    words += "--run";
    words += '\0';
    words += "shown." + std::to_string(run.pid());
    for (const auto& entry : fs::directory_iterator("/proc")) {
      if (ReadAll(entry.path() / "cmdline").find(words) != std::string::npos)
        return std::stoi(entry.path().filename());
    }
    return 0;
  }

  // Waits until the process has ended, as long as a test may take.  One that has ended but that
  // init has not waited for yet has no command line any more.
  static bool IsGone(int process) {
    for (int i = 0; i < 12'000; ++i) {
      if (ReadAll("/proc/" + std::to_string(process) + "/cmdline").empty()) return true;
      usleep(10'000);
    }
    return false;
  }

  // Returns the descriptors of a process, and what they lead to.
  static std::map<int, std::string> DescriptorsOf(int process) {
    std::map<int, std::string> descriptors;
    for (const auto& entry : fs::directory_iterator("/proc/" + std::to_string(process) + "/fd")) {
      std::error_code error;  // set if the process has closed it meanwhile
      const fs::path target = fs::read_symlink(entry.path(), error);
      if (!error) descriptors[std::stoi(entry.path().filename())] = target;
    }
    return descriptors;
  }

  static std::pair<Json, Json> Hashes(const std::string& file) {
    const Json report = Json::parse(ReadAll(file));
    return {report.at("trace_hash"), report.at("state_hash")};
  }
};

TEST_F(PanelRunTest, APageUsesTheRemoteControl) {
  const auto run = Start({"--rate", "10"});  // the dog stands up first, for 12 s
  WebSocketClient page(port_, Known());
  const auto call = [&page](Json request) {
    request["do"] = "rc";
    return page.Ask(request);
  };
  ASSERT_TRUE(run->WaitFor("remote control: "));
  const Json robot = call({{"call", "connect"}, {"id", 1}});
  EXPECT_EQ(robot.at("robot"), "ERS-210");
  EXPECT_EQ(robot.at("processor"), 2);
  EXPECT_EQ(robot.at("joints").size(), 18u);
  EXPECT_EQ(robot.at("joints")[1].at("name"), "neck_pan");
  EXPECT_EQ(robot.at("joints")[1].at("max_deg"), 89.6);
  EXPECT_EQ(robot.at("sensors").size(), 13u);
  EXPECT_EQ(robot.at("ears").size(), 2u);

  Json answer;
  do {
    answer = call({{"call", "move"}, {"joint", "neck_pan"}, {"deg", 20}});
  } while (answer.contains("error"));  // the dog stands up first
  EXPECT_EQ(answer.at("value"), 20);
  EXPECT_EQ(call({{"call", "move"}, {"joint", 1}, {"deg", 500}}).at("value"), 89.6);
  EXPECT_EQ(call({{"call", "speed"}, {"joint", "neck_pan"}, {"value", 50}}).at("value"), 50);
  EXPECT_EQ(call({{"call", "led"}, {"index", 0}, {"on", true}, {"id", 5}}), Json({{"id", 5}}));
  EXPECT_TRUE(call({{"call", "sensors"}}).contains("joints_deg"));
  EXPECT_EQ(call({{"call", "power"}}).at("motor_power"), true);
  EXPECT_EQ(call({{"call", "motors"}, {"on", false}}), Json::object());
  // RCServer has answered before JointMover switches the power.
  while (call({{"call", "power"}}).at("motor_power") == true) {
  }
  EXPECT_EQ(call({{"call", "motors"}, {"on", true}}), Json::object());
  EXPECT_THAT(call({{"call", "move"}, {"joint", "tale"}, {"deg", 1}}).at("error"),
              HasSubstr("the robot has no 'tale'"));
  EXPECT_THAT(call({{"call", "sit"}}).at("error"), HasSubstr("'sit' is no call"));
}

TEST_F(PanelRunTest, APageMovesFilesAndEndsTheRun) {
  const auto run = Start();
  ASSERT_TRUE(run->WaitFor("remote control: "));
  WebSocketClient page(port_, Known());
  const Json walk =
      page.Ask({{"do", "rc"}, {"call", "download"}, {"name", "WALK.MTN"}, {"id", 1}}).at("data");
  const Json event = page.Ask({{"do", "rc"},
                               {"call", "upload"},
                               {"kind", "motion"},
                               {"name", "mine.mtn"},
                               {"data", walk},
                               {"id", 2}});
  EXPECT_EQ(event, Json({{"event", "upload"}, {"id", 2}, {"sent", 3564}, {"size", 3564}}));
  EXPECT_EQ(Json::parse(page.Receive()), Json({{"name", "MINE.MTN"}, {"size", 3564}, {"id", 2}}));
  const Json motions = page.Ask({{"do", "rc"}, {"call", "motions"}}).at("motions");
  EXPECT_THAT(motions.dump(), HasSubstr(R"({"name":"MINE.MTN","size":3564})"));
  const Json wrong = page.Ask({{"do", "rc"},
                               {"call", "upload"},
                               {"kind", "motion"},
                               {"name", "mine.mtn"},
                               {"data", "AAAA"}});
  EXPECT_THAT(wrong.at("error"), HasSubstr("MINE.MTN: "));
  const Json too_often = page.Ask({{"do", "rc"},
                                   {"call", "upload"},
                                   {"kind", "motion"},
                                   {"name", "mine.mtn"},
                                   {"data", walk},
                                   {"loops", 65536}});
  EXPECT_EQ(too_often, Json({{"error", "request: loops: is 65536, must be 1 to 65535"}}));
  const Json half =
      page.Ask({{"do", "rc"}, {"call", "play"}, {"name", "MINE.MTN"}, {"loops", 1.5}});
  EXPECT_EQ(half, Json({{"error", "request: loops: must be a whole number, is 1.5"}}));
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "move"}, {"joint", 1.5}, {"deg", 1}}),
            Json({{"error", "request: joint: must be a name or a whole number, is 1.5"}}));
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "move"}, {"joint", "neck_pan"}}),
            Json({{"error", "request: 'deg' is missing"}}));
  EXPECT_EQ(page.Ask({{"do", "rc"}}), Json({{"error", "request: 'call' is missing"}}));
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "motions"}}).at("motions"), motions);
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "delete"}, {"name", "MINE.MTN"}}), Json::object());
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "delete"}, {"name", "MINE.MTN"}}).at("status"), 8);
  EXPECT_EQ(page.Ask({{"do", "rc"}, {"call", "shutdown"}}), Json::object());
  EXPECT_THAT(page.Receive(), HasSubstr("\"event\":\"ended\""));
  EXPECT_EQ(page.Receive(), "close 4001");
  EXPECT_EQ(run->Finish().status, 0);
}

TEST_F(PanelRunTest, ARequestOfAPageReachesTheRun) {
  const auto run = Start();
  WebSocketClient page(port_, Known("shown." + std::to_string(run->pid())));
  EXPECT_EQ(page.Ask({{"do", "status"}}).at("model"), "ERS-210");
  EXPECT_TRUE(page.Ask({{"do", "input"}, {"line", "press chin"}}).contains("time_s"));
  const Json runs = page.Ask({{"do", "runs"}});
  EXPECT_EQ(runs.at("own"), "shown." + std::to_string(run->pid()));
  EXPECT_EQ(runs.at("runs")[0].at("model"), "ERS-210");
}

TEST_F(PanelRunTest, TheServerEndsWithItsRun) {
  const auto run = Start();
  WebSocketClient page(port_, Known());
  const int server = ServerOf(*run);
  ASSERT_NE(server, 0);
  EXPECT_EQ(getsid(server), server);  // Ctrl-C in the terminal of the run does not reach it
  EXPECT_TRUE(page.Ask({{"do", "status"}}).contains("model"));
  run->Signal(SIGTERM);
  EXPECT_THAT(page.Receive(), HasSubstr("\"event\":\"ended\""));
  EXPECT_EQ(page.Receive(), "close 4001");
  EXPECT_EQ(run->Finish().status, 0);
  EXPECT_TRUE(IsGone(server));
}

TEST_F(PanelRunTest, TheServerEndsWithARunThatIsKilled) {
  const auto run = Start();
  const int server = ServerOf(*run);
  ASSERT_NE(server, 0);
  run->Signal(SIGKILL);
  EXPECT_EQ(run->Finish().status, 128 + SIGKILL);
  EXPECT_TRUE(IsGone(server));
}

TEST_F(PanelRunTest, ARunGoesOnWithoutItsServer) {
  const std::string report = folder_.path() + "/report.json";
  const auto run = Start({"--for", "5s", "--report", report});
  const int server = ServerOf(*run);
  ASSERT_NE(server, 0);
  kill(server, SIGKILL);
  EXPECT_TRUE(IsGone(server));
  // The run notices at the end of a frame that its panel server has ended.
  const std::string process = std::to_string(run->pid());
  const std::string children = "/proc/" + process + "/task/" + process + "/children";
  while (!ReadAll(children).empty()) usleep(10'000);
  // A run that has ended is a process in the state Z, which has no children either.
  EXPECT_THAT(ReadAll("/proc/" + process + "/stat"), ::testing::Not(HasSubstr(") Z ")))
      << "the run goes on";
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(Json::parse(ReadAll(report)).at("ended_by"), "time");
}

TEST_F(PanelRunTest, TheServerHasNoDescriptorsOfTheRun) {
  const auto run = Start({"--record", folder_.path() + "/run.rec"});
  const int server = ServerOf(*run);
  ASSERT_NE(server, 0);
  for (const auto& [number, target] : DescriptorsOf(server)) {
    const bool is_own = target == "/dev/null" || target == "/dev/urandom" ||
                        target.starts_with("socket:") || target.starts_with("pipe:") ||
                        target.starts_with("anon_inode:");
    EXPECT_TRUE(is_own) << number << " is " << target;
  }
}

TEST_F(PanelRunTest, TheRunGivesItsDescriptorsToNoProgram) {
  const std::string record = folder_.path() + "/run.rec";
  const auto run = Start({"--record", record});
  bool has_record = false;
  for (const auto& [number, target] : DescriptorsOf(run->pid())) {
    has_record |= target == record;
    // The run has inherited those that this process would give to any program.
    const int flags_here = fcntl(number, F_GETFD);
    const bool is_inherited = flags_here >= 0 && (flags_here & FD_CLOEXEC) == 0;
    if (number <= STDERR_FILENO || is_inherited) continue;
    std::istringstream info(
        ReadAll("/proc/" + std::to_string(run->pid()) + "/fdinfo/" + std::to_string(number)));
    int flags = O_CLOEXEC;  // closed meanwhile
    for (std::string word; info >> word;) {
      if (word == "flags:") info >> std::oct >> flags;
    }
    EXPECT_TRUE(flags & O_CLOEXEC) << number << " is " << target;
  }
  EXPECT_TRUE(has_record);
}

TEST_F(PanelRunTest, ARunWhosePageOnlyLooksIsTheSameRun) {
  const std::string shown = folder_.path() + "/shown.json", alone = folder_.path() + "/alone.json";
  const auto run = Start({"--for", "120s", "--report", shown});
  WebSocketClient page(port_, Known());
  for (const char* const what : {"scene", "status", "objects", "sensors", "joints", "runs"})
    page.Send(Json({{"do", what}, {"id", what}}).dump());
  page.Send(
      R"({"do":"watch","period_ms":16,"events":["pose","values","graph","log","findings","clock"]})");
  // The run is in real time until the page has seen all that it asked for.  At full speed it could
  // end before, because a page that has not taken its answers yet gets no events.
  std::set<std::string> missing = {"scene",  "status", "objects", "sensors",
                                   "joints", "runs",   "pose",    "values"};
  std::set<std::string> missing_at_the_end = {"rate", "ended"};
  std::string message = page.Receive();
  for (; message[0] == '{'; message = page.Receive()) {
    const Json json = Json::parse(message);
    EXPECT_FALSE(json.contains("error")) << message;
    for (const char* const member : {"event", "id"}) {
      if (!json.contains(member)) continue;
      missing_at_the_end.erase(json.at(member).get<std::string>());
      if (missing.erase(json.at(member).get<std::string>()) == 1 && missing.empty())
        page.Send(R"({"do":"clock","rate":0,"id":"rate"})");
    }
  }
  EXPECT_EQ(message, "close 4001");
  EXPECT_THAT(missing_at_the_end, ::testing::IsEmpty());
  EXPECT_EQ(run->Finish().status, 0);
  const ProgramResult other = RunProgram({"run", "--rc-port", "0", "--body", "ideal", "--no-panel",
                                          "--rate", "max", "--for", "120s", "--report", alone});
  EXPECT_EQ(other.status, 0);
  EXPECT_EQ(Hashes(shown), Hashes(alone));
}

TEST_F(PanelRunTest, ARunMayEndBeforeItsPanelIsThere) {
  const ProgramResult result = RunProgram({"run", "--rc-port", "0", "--body", "ideal", "--panel",
                                           "--panel-port", "0", "--rate", "max", "--for", "100ms"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.find("there is no run"), std::string::npos) << result.err;
}

TEST_F(PanelRunTest, WithoutATerminalThereIsNoPanel) {
  const ProgramResult result =
      RunProgram({"run", "--rc-port", "0", "--body", "ideal", "--rate", "max", "--for", "100ms"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.find("panel"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace openr_host
