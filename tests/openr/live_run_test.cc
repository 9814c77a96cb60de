// openr poke and openr attach: acting on a run that goes on.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "cli/process.h"
#include "openr/live/live_client.h"
#include "openr/live/live_folder.h"
#include "openr/live/live_server.h"
#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/watcher.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

// Every test has a folder of sockets of its own.
class LiveRunTest : public ::testing::Test {
 protected:
  LiveRunTest() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }
  ~LiveRunTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  // Starts a run in real time, which ends when its ProgramRun does.
  std::unique_ptr<ProgramRun> Start(std::vector<std::string> flags = {}) {
    std::vector<std::string> arguments = {"run",   "--rc-port",  "0",          "--body",
                                          "ideal", "--no-panel", "--run-name", "alive"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    auto run = std::make_unique<ProgramRun>(arguments);
    EXPECT_TRUE(run->WaitFor("remote control: "));
    return run;
  }

  ProcessResult Openr(std::vector<std::string> arguments, const std::string& input = "") {
    arguments.insert(arguments.begin(), OPENR_PROGRAM);
    return RunProcess(arguments, {.captures_error = true, .captures_out = true, .input = input});
  }

  const TempFolder folder_;
};

TEST_F(LiveRunTest, APokeReachesTheRunAndItsRecording) {
  const std::string file = folder_.path() + "/run.rec";
  const auto run = Start({"--record", file});
  const ProcessResult poke = Openr({"poke", "alive", "press", "chin"});
  EXPECT_EQ(poke.status, 0) << poke.output;
  EXPECT_THAT(poke.output, HasSubstr(" s: press chin\n"));
  const ProcessResult sensors = Openr({"attach", "alive"}, "sensors\n");
  EXPECT_THAT(sensors.output, HasSubstr("chin                        1  Chin switch"));
  EXPECT_EQ(Openr({"poke", "alive", "press pause"}).status, 0);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("ended by pause: PowerMonitor shut the robot down"));
  EXPECT_THAT(Openr({"trace", file}).output, HasSubstr("press chin\n"));
  EXPECT_EQ(Openr({"replay", file}).status, 0);
}

TEST_F(LiveRunTest, FindingsSayWhichMessageWasHandledAndWhatItSaid) {
  const ScratchFolder stick;
  stick.MakeTrouble("nan");
  ProgramRun run({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--run-name", "alive",
                  "--stick", stick.path()});
  ASSERT_TRUE(run.WaitFor("is running"));
  const std::string handled = "[^\n]*made NaN[^\n]* \\(message [0-9]+: boot\\)\n";
  const ProcessResult look = Openr({"attach", "alive"}, "findings\nobject Trouble\n");
  EXPECT_THAT(look.output, ContainsRegex("warning: Trouble \\(t=0.000 s\\): " + handled));
  EXPECT_THAT(look.output, ContainsRegex("  warning: " + handled));
  Watcher watcher(LiveRuns().at(0).socket);
  watcher.Ask(R"({"do":"watch","period_ms":16,"events":["findings"]})");
  const Json event = watcher.WaitFor("findings");
  for (const Json& source : {event, watcher.Ask(R"({"do":"findings"})")}) {
    const Json& finding = source.at("findings").at(0);
    EXPECT_GT(finding.at("message"), 0);
    EXPECT_EQ(finding.at("said"), "boot");
  }
}

TEST_F(LiveRunTest, ARunThatIsLookedAtIsTheSameRun) {
  const std::string watched = folder_.path() + "/watched.json";
  ProgramRun run({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--run-name", "alive",
                  "--for", "2s", "--report", watched});
  EXPECT_TRUE(run.WaitFor("remote control: "));
  const ProcessResult look = Openr(
      {"attach", "alive"}, "status\nobjects\nobject RCServer\nsensors\njoints\nfindings\nhelp\n");
  EXPECT_EQ(look.status, 0) << look.output;
  for (const char* const part :
       {"t=", "JointMover", "RCServer.", "distance", "RF_j1", "no findings", "push X Y Z"})
    EXPECT_THAT(look.output, HasSubstr(part));
  EXPECT_EQ(run.Finish().status, 0);
  const std::string alone = folder_.path() + "/alone.json";
  EXPECT_EQ(Openr({"run", "--rc-port", "0", "--body", "ideal", "--no-panel", "--rate", "max",
                   "--for", "2s", "--report", alone})
                .status,
            0);
  const auto hashes = [](const std::string& file) {
    std::ifstream stream(file);
    const Json report = Json::parse(stream);
    return std::pair(report["trace_hash"], report["state_hash"]);
  };
  EXPECT_EQ(hashes(watched), hashes(alone));
}

TEST_F(LiveRunTest, RefusalsSayWhatIsWrong) {
  const auto run = Start();
  const ProcessResult wrong = Openr({"poke", "alive", "press", "chinn"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.output, HasSubstr("did you mean 'chin'?"));
  const ProcessResult other = Openr({"poke", "--robot", "1", "alive", "press", "chin"});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.output, HasSubstr("there is no robot 1; this run has 1"));
  const ProcessResult nobody = Openr({"poke", "dead", "press", "chin"});
  EXPECT_EQ(nobody.status, 1);
  EXPECT_THAT(nobody.output, HasSubstr("there is no run 'dead'; runs that go on: alive (process "));
  const ProcessResult script = Openr({"attach", "alive"}, "object JointMvoer\npush 0 -5 0\n");
  EXPECT_EQ(script.status, 1);
  EXPECT_THAT(script.output, HasSubstr("did you mean 'JointMover'?"));
  EXPECT_THAT(script.output, HasSubstr("use --body ode"));
  EXPECT_THAT(Openr({"poke", "alive"}).output, HasSubstr("press SENSOR [N%] [for DURATION]"));
}

TEST_F(LiveRunTest, TheInputsAreListedInTwoColumns) {
  const auto run = Start();
  const std::string list = Openr({"poke", "alive"}).output;
  // Returns the place of `help`, the text about an input, in its line.
  const auto column_of = [&list](const char* help) {
    const size_t at = list.find(help);
    EXPECT_NE(at, std::string::npos) << help << " is not in\n" << list;
    return at - list.rfind('\n', at) - 1;
  };
  const size_t column = column_of("Makes a part faulty.");
  for (const char* const help : {"Lets the robot fall.", "Gives servos their set points"})
    EXPECT_EQ(column_of(help), column) << list;
}

TEST_F(LiveRunTest, SeveralRunsOfOneNameNeedTheProcessId) {
  const auto first = Start();
  const auto second = Start();
  const ProcessResult both = Openr({"poke", "alive", "press", "chin"});
  EXPECT_EQ(both.status, 1);
  EXPECT_THAT(both.output, HasSubstr("'alive' names several runs; give the process id"));
  ASSERT_EQ(LiveRuns().size(), 2u);
  EXPECT_EQ(Openr({"poke", std::to_string(LiveRuns()[1].process), "press", "chin"}).status, 0);
}

TEST_F(LiveRunTest, TheSocketOfAKilledRunIsRemoved) {
  auto run = Start();
  ASSERT_EQ(LiveRuns().size(), 1u);
  const std::string socket = LiveRuns()[0].socket;
  run->Signal(SIGKILL);
  run->Finish();
  EXPECT_TRUE(std::filesystem::exists(socket));
  EXPECT_TRUE(LiveRuns().empty());
  EXPECT_FALSE(std::filesystem::exists(socket));
}

// Makes a socket at `path`.
int BindSocket(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  EXPECT_EQ(bind(made, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  return made;
}

// The process of this test is running, but has not opened the socket that has its id.
TEST_F(LiveRunTest, ADeadRunWhoseProcessIdIsUsedAgainIsNotListed) {
  const std::string path = LiveSocketPath("dead");
  const int dead = BindSocket(path);
  EXPECT_EQ(LiveRuns().size(), 1u) << "a run that does not listen yet";
  ASSERT_EQ(listen(dead, 1), 0);
  EXPECT_EQ(LiveRuns().size(), 1u);
  EXPECT_EQ(accept4(dead, nullptr, nullptr, SOCK_CLOEXEC), -1) << "LiveRuns() is a client";
  close(dead);
  EXPECT_TRUE(std::filesystem::exists(path));
  const ProcessResult poke = Openr({"poke", "dead", "press", "chin"});
  EXPECT_EQ(poke.status, 1);
  EXPECT_THAT(poke.output, HasSubstr("there is no run 'dead'; no run of this user goes on"));
  EXPECT_TRUE(std::filesystem::exists(path)) << "the process may be a run that is just opening it";
}

// Returns the path of a socket whose process does not exist here: either that process was killed,
// or it is in another container.
std::string SocketOfMissingProcess() {
  const pid_t missing = fork();
  if (missing == 0) _exit(0);
  waitpid(missing, nullptr, 0);
  return LiveFolder() + "/elsewhere." + std::to_string(missing);
}

TEST_F(LiveRunTest, ARunInAnotherContainerKeepsItsSocket) {
  const std::string path = SocketOfMissingProcess();
  const int open = BindSocket(path);
  ASSERT_EQ(LiveRuns().size(), 1u);
  EXPECT_EQ(LiveRuns()[0].name, "elsewhere");
  close(open);
  EXPECT_TRUE(LiveRuns().empty());
  EXPECT_FALSE(std::filesystem::exists(path));
}

// The socket has the id of this process, as the socket of a run in another container may have.
TEST_F(LiveRunTest, AnOpenSocketOfTheSameNameAndProcessIdIsNotReplaced) {
  const int open = BindSocket(LiveSocketPath("twin"));
  try {
    const LiveServer server("twin", nullptr, nullptr);
    ADD_FAILURE() << "the socket was replaced";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("twin." + std::to_string(getpid()) +
                                        ": cannot listen: another run has this socket open"));
  }
  EXPECT_EQ(LiveRuns().size(), 1u);
  close(open);
  const LiveServer server("twin", nullptr, nullptr);
  EXPECT_EQ(LiveRuns().size(), 1u);
}

TEST_F(LiveRunTest, TheNextRunRemovesTheSocketOfAKilledRun) {
  const std::string path = SocketOfMissingProcess();
  close(BindSocket(path));
  const auto run = Start();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(LiveRunTest, AFolderThatOthersCanEnterIsRefused) {
  const std::string folder = LiveFolder();
  chmod(folder.c_str(), 0755);
  EXPECT_THROW(LiveFolder(), std::runtime_error);
  std::filesystem::remove(folder);
  std::filesystem::create_symlink(folder_.path(), folder);
  EXPECT_THROW(LiveFolder(), std::runtime_error);
}

// A server in this process, without a run.
class LiveServerTest : public LiveRunTest {
 protected:
  LiveServerTest()
      : server_(
            std::in_place, "name",
            [](const nlohmann::json& request) -> Json {
              return {{"echo", request.at("do").get<std::string>()}};
            },
            nullptr) {}

  // Connects without waiting for the server.
  int Connect() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = LiveRuns().at(0).socket;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    const int client = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    EXPECT_EQ(connect(client, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    return client;
  }

  void Serve(int times = 3) {
    for (int i = 0; i < times; ++i) {
      usleep(3000);
      server_->Serve();
    }
  }

  // Returns all that has come; "(closed)" behind it if the server has closed the connection.
  std::string Read(int client) {
    std::string text;
    char buffer[4096];
    for (;;) {
      const ssize_t count = recv(client, buffer, sizeof buffer, 0);
      if (count < 0) return text;
      if (count == 0) return text + "(closed)";
      text.append(buffer, static_cast<size_t>(count));
    }
  }

  void Write(int client, const std::string& text) {
    ASSERT_EQ(send(client, text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }

  std::optional<LiveServer> server_;
};

TEST_F(LiveServerTest, RequestsMayComeInPiecesOrTogether) {
  const int client = Connect();
  Write(client, "{\"do\":");
  Serve();
  EXPECT_EQ(Read(client), "");
  Write(client, "\"a\"}\n{\"do\":\"b\"}\n{");
  Serve();
  EXPECT_EQ(Read(client), "{\"echo\":\"a\"}\n{\"echo\":\"b\"}\n");
  close(client);
}

TEST_F(LiveServerTest, TheIdOfARequestIsInItsAnswer) {
  const int client = Connect();
  Write(client, "{\"do\":\"a\",\"id\":7}\n{\"do\":8,\"id\":\"x\"}\n{\"do\":\"watch\",\"id\":9}\n");
  Serve();
  const std::string text = Read(client);
  EXPECT_THAT(text, HasSubstr("{\"echo\":\"a\",\"id\":7}\n"));
  EXPECT_THAT(text, HasSubstr("\"id\":\"x\"}\n"));
  EXPECT_THAT(text, HasSubstr("{\"error\":\"there is nothing to watch here\",\"id\":9}\n"));
  close(client);
}

TEST_F(LiveServerTest, GarbageGetsAnErrorAndTheConnectionGoesOn) {
  const int client = Connect();
  Write(client, "hello\n[]\n{\"do\":7}\n{\"do\":\"a\"}\n");
  Serve();
  const std::string text = Read(client);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4) << text;
  EXPECT_THAT(text, HasSubstr("parse error"));
  EXPECT_THAT(text, HasSubstr("{\"echo\":\"a\"}\n"));
  close(client);
}

// Writing such an id into the answer would overflow the stack of the run.
TEST_F(LiveServerTest, ADeeplyNestedRequestIsRefused) {
  const int client = Connect();
  const std::string deep = std::string(30'000, '[') + std::string(30'000, ']');
  const std::string error = "{\"error\":\"the JSON is nested more than 100 levels deep\"";
  Write(client, "{\"do\":\"a\",\"id\":" + deep + "}\n{\"do\":\"a\"}\n");
  Serve();
  EXPECT_EQ(Read(client), error + "}\n{\"echo\":\"a\"}\n");
  Write(client, "{\"do\":\"a\",\"x\":" + deep + ",\"id\":5}\n");
  Serve();
  EXPECT_EQ(Read(client), error + ",\"id\":5}\n");
  close(client);
}

TEST_F(LiveServerTest, ARequestWithoutAnEndIsClosed) {
  const int client = Connect();
  const std::string piece(16 << 10, 'x');
  for (int i = 0; i < 6; ++i) {
    send(client, piece.data(), piece.size(), MSG_NOSIGNAL);
    Serve();
  }
  EXPECT_EQ(Read(client), "(closed)");
  const int next = Connect();
  Write(next, "{\"do\":\"a\"}\n");
  Serve();
  EXPECT_EQ(Read(next), "{\"echo\":\"a\"}\n");
  close(client);
  close(next);
}

TEST_F(LiveServerTest, AClientThatTakesNoAnswersIsClosed) {
  const int client = Connect();
  const std::string request = "{\"do\":\"" + std::string(30'000, 'x') + "\"}\n";
  ssize_t sent = 1;
  for (int i = 0; i < 500 && sent > 0; ++i) {
    sent = send(client, request.data(), request.size(), MSG_NOSIGNAL);
    Serve(1);
  }
  EXPECT_LT(sent, 0);  // the server has closed the connection, though the client never read
  close(client);
}

TEST_F(LiveServerTest, AnswersThatWaitAreSentBeforeTheEnd) {
  const int client = Connect();
  const std::string answer = "{\"echo\":\"" + std::string(30'000, 'x') + "\"}\n";
  for (int i = 0; i < 20; ++i) {  // more than a socket holds
    Write(client, "{\"do\":\"" + std::string(30'000, 'x') + "\"}\n");
    Serve();
  }
  fcntl(client, F_SETFL, 0);  // waits when it reads
  std::string text;
  std::thread reader([&] { text = Read(client); });
  server_.reset();
  reader.join();
  EXPECT_EQ(text.size(), 20 * answer.size() + std::string("(closed)").size());
  EXPECT_TRUE(text.ends_with("(closed)"));
  close(client);
}

TEST_F(LiveServerTest, ClientsBeyondTheLimitAreClosed) {
  std::vector<int> clients;
  for (size_t i = 0; i <= LiveServer::kClientsMax; ++i) {
    clients.push_back(Connect());
    Serve();
  }
  EXPECT_EQ(Read(clients.back()), "(closed)");
  EXPECT_EQ(Read(clients.front()), "");
  for (const int client : clients) close(client);
}

}  // namespace
}  // namespace openr_host
