// The server of the panel, with a run that the test plays itself.
#include "tests/openr/panel_server.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

class PanelServerTest : public PanelTest {
 protected:
  void SetUp() override {
    PanelTest::SetUp();
    if (!IsSkipped()) Start();
  }

  void Start(const std::string& port = "0") {
    server_ = std::make_unique<ProgramRun>(
        std::vector<std::string>{"panel", "--port", port, "--run", run_.id()});
    ASSERT_TRUE(server_->WaitForOutput("\n"));
    ReadAddress(server_->said());
  }

  // Opens a page of the run and waits until the run has its connection.
  std::unique_ptr<WebSocketClient> Page() {
    auto page = std::make_unique<WebSocketClient>(port_, Known());
    EXPECT_TRUE(page->is_open()) << page->answer();
    run_.Accept();
    return page;
  }

  FakeRun run_{"played"};
  std::unique_ptr<ProgramRun> server_;
};

TEST_F(PanelServerTest, ThePageComesWithHeadersThatKeepItToItself) {
  const std::string answer = Http(port_, "/");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(answer, HasSubstr("content-type: text/html; charset=utf-8\r\n"));
  EXPECT_THAT(answer, HasSubstr("content-security-policy: default-src 'self'; "));
  EXPECT_THAT(answer, HasSubstr("x-content-type-options: nosniff\r\n"));
  EXPECT_THAT(answer, HasSubstr("referrer-policy: no-referrer\r\n"));
  EXPECT_THAT(answer, HasSubstr("cache-control: no-cache\r\n"));
  EXPECT_THAT(answer, HasSubstr("<!doctype html>"));
}

TEST_F(PanelServerTest, FilesOutsideOfThePageAreNotServed) {
  for (const char* const path :
       {"/../bin/openr", "/../../bin/openr", "/..%2f..%2fbin/openr", "/%2e%2e/bin/openr",
        "/assets/../../bin/openr", "//etc/passwd", "/.git", "/nothing.js", "/assets/", "/assets"}) {
    const std::string answer = Http(port_, path);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 404 ")) << path;
    EXPECT_LT(answer.size(), 2000u) << path;
  }
}

TEST_F(PanelServerTest, APathThatIsTooLongIsRefused) {
  EXPECT_THAT(Http(port_, "/" + std::string(2047, 'a')), StartsWith("HTTP/1.1 404 "));
  for (const size_t size : {size_t{2048}, size_t{5000}, size_t{12'000}})
    EXPECT_THAT(Http(port_, "/" + std::string(size, 'a')), StartsWith("HTTP/1.1 414 ")) << size;
}

// libwebsockets 4.1 never ends to parse this request if it comes in one packet behind another one.
TEST_F(PanelServerTest, ARequestBehindAnotherDoesNotStopTheServer) {
  TcpClient client(port_);
  client.Write(
      "GET / HTTP/1.1\r\nHo\xdat: x\r\n\r\nGET /no%20file?a=b HTTP/1.1\r\n\v\nPOST / HTTP/1.0\r\n"
      "Host: elsewhere\r\nContent-Length: 3\r\n\r\nabc");
  EXPECT_THAT(client.ReadUntil("\r\n\r\n"), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(Http(port_, "/"), StartsWith("HTTP/1.1 200 OK\r\n"));
}

TEST_F(PanelServerTest, OtherMethodsThanGetAreRefused) {
  EXPECT_THAT(Http(port_, "/", "", "POST"), StartsWith("HTTP/1.1 405 "));
}

TEST_F(PanelServerTest, AnotherNameOfThisHostIsRefused) {
  EXPECT_THAT(Http(port_, "/", "evil.example:" + std::to_string(port_)),
              StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(Http(port_, "/", "127.0.0.1:1"), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(Http(port_, "/", "localhost:" + std::to_string(port_)), StartsWith("HTTP/1.1 200 "));
}

TEST_F(PanelServerTest, AWebSocketNeedsTokenHostAndOrigin) {
  const auto status = [this](Handshake handshake) {
    const std::string answer = WebSocketClient(port_, handshake).answer();
    return answer.substr(0, answer.find(' ', 9));
  };
  const auto changed = [this](auto change) {
    Handshake handshake = Known();
    change(&handshake);
    return handshake;
  };
  EXPECT_EQ(status(Known()), "HTTP/1.1 101");
  EXPECT_EQ(status(changed([](Handshake* h) { h->origin = "-"; })), "HTTP/1.1 101");
  EXPECT_EQ(status(changed([](Handshake* h) { h->protocol = ""; })), "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->protocol.back() ^= 1; })), "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->protocol += ", chat"; })), "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->origin = "http://evil.example"; })),
            "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->origin = "null"; })), "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->host = "evil.example"; })), "HTTP/1.0 403");
  EXPECT_EQ(status(changed([](Handshake* h) { h->path = "/other"; })), "HTTP/1.0 404");
}

TEST_F(PanelServerTest, RunsAreListedWithTheOwnOne) {
  WebSocketClient page(port_, Known());
  page.Send(R"({"do":"runs","id":7})");
  // The server asks each run for its state, behind the connection of the page.
  run_.Accept();
  run_.Accept();
  EXPECT_EQ(run_.Line(), R"({"do":"status"})");
  run_.Write("{\"model\":\"ERS-7\",\"time_s\":1.5}\n");
  const Json answer = Json::parse(page.Receive());
  EXPECT_EQ(answer.at("id"), 7);
  EXPECT_EQ(answer.at("own"), run_.id());
  ASSERT_EQ(answer.at("runs").size(), 1u);
  const Json expected = {{"name", "played"},
                         {"process", getpid()},
                         {"run", run_.id()},
                         {"model", "ERS-7"},
                         {"time_s", 1.5}};
  EXPECT_EQ(answer.at("runs")[0], expected);
}

TEST_F(PanelServerTest, ARunThatIsSilentIsListedWithoutItsState) {
  WebSocketClient page(port_, Known());
  const Json answer = page.Ask({{"do", "runs"}});
  ASSERT_EQ(answer.at("runs").size(), 1u);
  EXPECT_TRUE(answer.at("runs")[0].at("model").is_null());
}

TEST_F(PanelServerTest, OtherRequestsAndTheirAnswersPassThroughUnchanged) {
  const auto page = Page();
  const std::string request = R"({ "id": 12, "do":"objects",  "x": "\u00e4\n" })";
  page->Send(request);
  EXPECT_EQ(run_.Line(), request);
  run_.Write("{\"objects\": [ ],\"id\":12}\n{\"event\":\"pose\"}\n");
  EXPECT_EQ(page->Receive(), R"({"objects": [ ],"id":12})");
  EXPECT_EQ(page->Receive(), R"({"event":"pose"})");
  page->Send("{\"do\":\n\"status\"}");
  EXPECT_EQ(run_.Line(), R"({"do": "status"})");
}

TEST_F(PanelServerTest, WhatIsNoRequestIsRefusedAndThePageGoesOn) {
  const auto page = Page();
  for (const char* const text : {"hello", "[]", "7", "{\"do\":"}) {
    page->Send(text);
    EXPECT_EQ(page->Receive(), R"({"error":"the request is no JSON object"})");
  }
  page->Send(R"({"do":"rc","call":"info","robot":1e300,"id":2})");
  EXPECT_EQ(page->Receive(), R"({"error":"the number 1e+300 is too large","id":2})");
  page->Send(R"({"do":"rc","call":"info","robot":-1,"id":4})");
  EXPECT_EQ(page->Receive(), R"({"error":"there is no robot -1","id":4})");
  page->Send(R"({"do":7,"id":3})");
  EXPECT_THAT(page->Receive(), HasSubstr("\"id\":3"));
  page->Send(R"({"do":"status"})");
  EXPECT_EQ(run_.Line(), R"({"do":"status"})");
}

TEST_F(PanelServerTest, ARequestThatIsNestedTooDeeplyIsRefusedWithItsId) {
  const auto page = Page();
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  page->Send(R"({"do":"rc","call":"upload","x":)" + deep + R"(,"id":9})");
  EXPECT_EQ(page->Receive(), R"({"error":"the JSON is nested more than 100 levels deep","id":9})");
  page->Send(R"({"do":"rc","call":"upload","id":)" + deep + "}");
  EXPECT_EQ(page->Receive(), R"({"error":"the JSON is nested more than 100 levels deep"})");
  page->Send(R"({"do":"status"})");
  EXPECT_EQ(run_.Line(), R"({"do":"status"})");
}

TEST_F(PanelServerTest, MessagesThatAreTooLongOrNoTextEndThePage) {
  const std::string filler(100'000, 'x');
  const auto last_word = [this](const std::string& message, int opcode) {
    const auto page = Page();
    page->Send(message, opcode);
    EXPECT_THAT(page->Receive(), HasSubstr("\"event\":\"ended\""));
    return page->Receive();
  };
  EXPECT_EQ(last_word(filler, WebSocketClient::kText), "close 1009");
  EXPECT_EQ(last_word(R"({"do":"input","line":"upload )" + filler + "\"}", WebSocketClient::kText),
            "close 1009");
  EXPECT_EQ(
      last_word(R"({"do":"input","x":"upload","line":")" + filler + "\"}", WebSocketClient::kText),
      "close 1009");
  EXPECT_EQ(last_word(R"({"do":"rc","call":"upload","data":")" + std::string(13 << 20, 'A') + "\"}",
                      WebSocketClient::kText),
            "close 1009");
  EXPECT_EQ(last_word("{}", WebSocketClient::kBinary), "close 1003");
}

TEST_F(PanelServerTest, APageIsClosedWhenTheMessageThatIsTooLongHasEnded) {
  const auto page = Page();
  page->Send(std::string(100'000, 'x'), WebSocketClient::kText, false);
  EXPECT_THAT(page->Receive(), HasSubstr("\"why\":\"a message of more than 65536 bytes\""));
  for (int i = 0; i < 100; ++i)
    page->Send(std::string(100'000, 'x'), WebSocketClient::kContinuation, false);
  page->Send("x", WebSocketClient::kContinuation);
  EXPECT_EQ(page->Receive(), "close 1009");
}

TEST_F(PanelServerTest, AMessageWithoutEndIsCutOff) {
  const auto page = Page();
  const std::string part(1 << 20, 'x');
  page->Send(part, WebSocketClient::kText, false);
  for (int i = 0; i < 70; ++i) page->Send(part, WebSocketClient::kContinuation, false);
  std::string word = page->Receive();
  if (word.find("ended") != std::string::npos) word = page->Receive();
  EXPECT_EQ(word, "(lost)");
}

TEST_F(PanelServerTest, ASlowPageGetsFewerPosesAndTheNewestOne) {
  const auto page = Page();
  constexpr int kPoses = 2000;
  const std::string filler(20'000, 'x');
  for (int i = 1; i <= kPoses; ++i) {
    ASSERT_TRUE(run_.Write("{\"event\":\"pose\",\"time_s\":" + std::to_string(i) + ",\"x\":\"" +
                           filler + "\"}\n"));
  }
  ASSERT_TRUE(run_.Write("{\"id\":1}\n"));
  int count = 0;
  int last = 0;
  for (;;) {
    const Json message = Json::parse(page->Receive());
    if (message.contains("id")) break;
    ++count;
    EXPECT_GT(message.at("time_s"), last);
    last = message.at("time_s");
  }
  EXPECT_EQ(last, kPoses);
  EXPECT_LT(count, kPoses / 2);
}

TEST_F(PanelServerTest, APageThatTakesNoAnswersIsClosed) {
  const auto page = Page();
  const std::string answer = "{\"x\":\"" + std::string(60'000, 'x') + "\"}\n";
  int written = 0;
  while (written < 1000 && run_.Write(answer)) ++written;
  EXPECT_LT(written, 1000);  // the server has left the run too
  const auto other = Page();
  other->Send(R"({"do":"status"})");
  EXPECT_EQ(run_.Line(), R"({"do":"status"})");
}

TEST_F(PanelServerTest, APageWhoseRequestsNobodyTakesHasToWait) {
  const auto page = Page();
  constexpr int kRequests = 500;  // 30 MB, more than sockets and server keep
  const std::string filler(60'000, 'x');
  std::atomic<int> sent = 0;
  std::thread sender([&] {
    for (int i = 0; i < kRequests; ++i, ++sent)
      page->Send(R"({"do":"input","id":)" + std::to_string(i) + R"(,"line":")" + filler + "\"}");
  });
  // Waits until the page is not read any more.
  int before = -1;
  while (before != sent && sent < kRequests) {
    before = sent;
    usleep(300'000);
  }
  EXPECT_LT(sent, kRequests / 2);
  for (int i = 0; i < kRequests; ++i)
    EXPECT_THAT(run_.Line(), StartsWith(R"({"do":"input","id":)" + std::to_string(i) + ","));
  sender.join();
}

TEST_F(PanelServerTest, ThePageThatIsOneTooManyIsTold) {
  std::vector<std::unique_ptr<WebSocketClient>> pages;
  for (int i = 0; i < 16; ++i) pages.push_back(Page());
  WebSocketClient other(port_, Known());
  EXPECT_EQ(other.Receive(), R"({"event":"ended","why":"16 pages are open already; close one"})");
  EXPECT_EQ(other.Receive(), "close 1013");
  pages[3].reset();
  const auto next = Page();
  next->Send(R"({"do":"status"})");
  EXPECT_EQ(run_.Line(), R"({"do":"status"})");
}

TEST_F(PanelServerTest, APageHearsThatItsRunHasEnded) {
  const auto page = Page();
  run_.Write("{\"a\":1}\n");
  EXPECT_EQ(page->Receive(), "{\"a\":1}");
  run_.Close();
  const Json event = Json::parse(page->Receive());
  EXPECT_EQ(event.at("event"), "ended");
  EXPECT_THAT(event.at("why").get<std::string>(), HasSubstr("run played (process "));
  EXPECT_EQ(page->Receive(), "close 4001");
  const auto next = Page();  // a server that was started by hand goes on
  EXPECT_TRUE(next->is_open());
}

TEST_F(PanelServerTest, APageOfNoRunIsToldWhichThereAre) {
  WebSocketClient page(port_, Known("gone.1"));
  EXPECT_THAT(page.Receive(), HasSubstr("there is no run 'gone.1'; runs that go on: played"));
  EXPECT_EQ(page.Receive(), "close 4002");
}

TEST_F(PanelServerTest, ALongReasonForClosingHasWholeCharactersOnly) {
  for (const char* const begin : {"", "a"}) {
    std::string name = begin, known = begin;
    for (int i = 0; i < 60; ++i) name += "%C3%A9";
    while (17 + known.size() + 2 <= 123) known += "\xC3\xA9";
    WebSocketClient page(port_, Known(name));
    page.Receive();
    EXPECT_EQ(page.Receive(), "close 4002");
    EXPECT_EQ(page.close_reason(), "there is no run '" + known);
  }
}

TEST_F(PanelServerTest, APortThatIsTakenGivesTheNextFreeOne) {
  const int taken = port_;
  const auto first = std::move(server_);
  Start(std::to_string(taken));
  EXPECT_GT(port_, taken);
  EXPECT_THAT(Http(port_, "/"), StartsWith("HTTP/1.1 200 "));
}

TEST_F(PanelServerTest, ARobotThatIsNotThereIsAnError) {
  const auto page = Page();
  const Json answer =
      page->Ask({{"do", "rc"}, {"call", "connect"}, {"endpoint", "127.0.0.1:1"}, {"id", "a"}});
  EXPECT_EQ(answer.at("id"), "a");
  EXPECT_THAT(answer.at("error").get<std::string>(), HasSubstr("no program listens there"));
  const Json wrong = page->Ask({{"do", "rc"}, {"call", "connect"}, {"endpoint", "a:b:c"}});
  EXPECT_THAT(wrong.at("error").get<std::string>(), HasSubstr("more than one colon"));
}

// Each page uses as many robots as it may.  One page is closed while its robots do not answer, so
// that its threads go on, and the next page gets none.
TEST_F(PanelServerTest, ARobotThatWasRefusedMayBeAskedForAgain) {
  const int silent = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(bind(silent, any, size), 0);
  ASSERT_EQ(listen(silent, 16), 0);
  ASSERT_EQ(getsockname(silent, any, &size), 0);
  const auto call = [](int host, int port, const std::string& id) {
    return Json{{"do", "rc"},
                {"call", "connect"},
                {"endpoint", "127.0.0." + std::to_string(host) + ":" + std::to_string(port)},
                {"id", id}};
  };
  std::vector<std::unique_ptr<WebSocketClient>> pages;
  while (pages.size() < 15) {
    pages.push_back(Page());
    for (int host = 1; host <= 4; ++host) pages.back()->Ask(call(host, 1, "nobody listens"));
  }
  auto closed = Page();
  for (int host = 1; host <= 4; ++host)
    closed->Send(call(host, ntohs(address.sin_port), "silent").dump());
  closed->Send("hello");
  EXPECT_EQ(closed->Receive(), R"({"error":"the request is no JSON object"})");
  closed.reset();
  const auto next = Page();
  for (const char* const id : {"a", "b"}) {
    const Json answer = next->Ask(call(1, ntohs(address.sin_port), id));
    EXPECT_EQ(answer.value("id", ""), id) << answer;
    EXPECT_TRUE(answer.contains("error")) << answer;
  }
  close(silent);
}

// A server that has few descriptors.
class PanelDescriptorsTest : public PanelServerTest {
 protected:
  void SetUp() override {
    PanelServerTest::SetUp();
    if (IsSkipped()) return;
    ASSERT_EQ(prlimit(server_->pid(), RLIMIT_NOFILE, nullptr, &before_), 0);
    address_.sin_family = AF_INET;
    address_.sin_port = htons(static_cast<uint16_t>(port_));
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }

  // Lets the server open only descriptors with numbers below `limit`.
  void Limit(rlim_t limit) const {
    const rlimit few{limit, before_.rlim_max};
    ASSERT_EQ(prlimit(server_->pid(), RLIMIT_NOFILE, &few, nullptr), 0);
  }

  // Returns the descriptors of the server, and what they lead to.
  std::map<int, std::string> Descriptors() const {
    std::map<int, std::string> found;
    const std::string folder = "/proc/" + std::to_string(server_->pid()) + "/fd";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::error_code error;  // set if the server has closed the descriptor meanwhile
      const std::filesystem::path target = std::filesystem::read_symlink(entry.path(), error);
      if (!error) found[std::stoi(entry.path().filename())] = target;
    }
    return found;
  }

  int Connect() const {
    const int client = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&address_), sizeof address_), 0);
    return client;
  }

  // Connects more clients than the server has descriptors for, and expects that the last one is
  // closed.
  void ExpectConnectionsAreClosed() const {
    const int limit = Descriptors().rbegin()->first + 3;
    Limit(static_cast<rlim_t>(limit));
    std::vector<int> clients;
    for (int i = 0; i <= limit; ++i) clients.push_back(Connect());
    const timeval patience{30, 0};
    setsockopt(clients.back(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    char byte;
    EXPECT_EQ(recv(clients.back(), &byte, 1, 0), 0);
    for (const int client : clients) close(client);
    Limit(before_.rlim_cur);
    EXPECT_THAT(Http(port_, "/"), StartsWith("HTTP/1.1 200 OK\r\n"));
  }

  rlimit before_{};
  sockaddr_in address_{};
};

// A connection that stayed in the queue would wake the server's event loop again and again.
TEST_F(PanelDescriptorsTest, AConnectionForWhichNoDescriptorIsLeftIsClosed) {
  ExpectConnectionsAreClosed();
}

// The limit of descriptors is set to the number of the server's spare descriptor, which is the
// first /dev/null that the server has opened.  So the server closes this descriptor and can open
// nothing in its place.
TEST_F(PanelDescriptorsTest, ASpareDescriptorThatWasLostIsOpenedAgain) {
  int spare = 0;
  for (const auto& [number, target] : Descriptors()) {
    if (number > STDERR_FILENO && spare == 0 && target == "/dev/null") spare = number;
  }
  ASSERT_GT(spare, 0);
  Limit(static_cast<rlim_t>(spare));
  const int waiting = Connect();
  for (int i = 0; i < 3000 && Descriptors().contains(spare); ++i) usleep(10'000);
  EXPECT_FALSE(Descriptors().contains(spare));
  Limit(before_.rlim_cur);
  EXPECT_THAT(Http(port_, "/"), StartsWith("HTTP/1.1 200 OK\r\n"));
  close(waiting);
  ExpectConnectionsAreClosed();
}

TEST_F(PanelServerTest, CtrlCEndsAServerThatWasStartedByHand) {
  const auto page = Page();
  server_->Signal(SIGINT);
  EXPECT_EQ(server_->Finish().status, 0);
  EXPECT_EQ(run_.Line(), "");
}

// The server learns the end of the run, which has started it, by a pipe, and gets the answers of
// the run by a socket.  The server is stopped meanwhile, so it finds the last answer and the end at
// the same time.
TEST_F(PanelTest, ThePageGetsTheLastAnswerOfARunThatEnds) {
  FakeRun run("played");
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  fcntl(ends[0], F_SETFD, 0);  // the server inherits this end of the pipe
  ProgramRun server({"panel", "--port", "0", "--fd", std::to_string(ends[0]), "--run", run.id()});
  close(ends[0]);
  ASSERT_TRUE(server.WaitFor("\n"));
  ReadAddress(server.heard());
  WebSocketClient page(port_, Known());
  run.Accept();
  page.Send(R"({"do":"status","id":1})");
  EXPECT_EQ(run.Line(), R"({"do":"status","id":1})");
  server.Signal(SIGSTOP);
  int status = 0;
  ASSERT_EQ(waitpid(server.pid(), &status, WUNTRACED), server.pid());
  ASSERT_TRUE(WIFSTOPPED(status));
  run.Write("{\"id\":1}\n");
  close(ends[1]);
  server.Signal(SIGCONT);
  EXPECT_EQ(page.Receive(), R"({"id":1})");
  EXPECT_EQ(page.Receive(), R"({"event":"ended","why":"the run has ended"})");
  EXPECT_EQ(page.Receive(), "close 4001");
  EXPECT_EQ(server.Finish().status, 0);
}

}  // namespace
}  // namespace openr_host
