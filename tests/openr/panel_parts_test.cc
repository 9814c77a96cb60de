// Parts of the panel's server, without a server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "cli/base64.h"
#include "openr/panel/access.h"
#include "openr/panel/listen.h"
#include "openr/panel/page_queue.h"
#include "openr/panel/pair_bridge.h"
#include "openr/panel/panel_process.h"
#include "openr/panel/rc_bridge.h"
#include "openr/panel/rc_forwarder.h"
#include "openr/panel/runs_lister.h"
#include "openr/panel/spare_descriptor.h"
#include "openr/panel/static_files.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::ordered_json;

TEST(Base64Test, BytesComeBackAsTheyWere) {
  EXPECT_EQ(ToBase64(""), "");
  EXPECT_EQ(ToBase64("f"), "Zg==");
  EXPECT_EQ(ToBase64("fo"), "Zm8=");
  EXPECT_EQ(ToBase64("foobar"), "Zm9vYmFy");
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(FromBase64(ToBase64(all)), all);
  EXPECT_EQ(FromBase64("Zg=="), "f");
}

TEST(Base64Test, OtherTextsAreRefused) {
  for (const char* const text : {"Zg", "Zg=", "Zg=a", "====", "Z===", "Zm9v YmFy", "Zm9-", "=m9v"})
    EXPECT_EQ(FromBase64(text), std::nullopt) << text;
}

TEST(AccessTest, TokensDifferAndHave128Bits) {
  EXPECT_NE(NewToken(), NewToken());
  EXPECT_EQ(NewToken().size(), 32u);
  EXPECT_TRUE(IsSameSecret("abc", "abc"));
  for (const char* const other : {"", "ab", "abcd", "abd", "bbc"})
    EXPECT_FALSE(IsSameSecret("abc", other));
}

TEST(StaticFilesTest, OnlyFilesBelowTheFolderAreFound) {
  const ScratchFolder scratch;
  scratch.Write("page/index.html", "x");
  scratch.Write("page/assets/a.js", "x");
  scratch.Write("page/.hidden", "x");
  scratch.Write("secret.txt", "x");
  std::filesystem::create_symlink(scratch.File("secret.txt"), scratch.File("page/link.txt"));
  const std::string folder = scratch.File("page");
  EXPECT_EQ(FindStaticFile(folder, "/"), folder + "/index.html");
  EXPECT_EQ(FindStaticFile(folder, "/index.html"), folder + "/index.html");
  EXPECT_EQ(FindStaticFile(folder, "/assets/a.js"), folder + "/assets/a.js");
  for (const char* const path : {"", "index.html", "/assets", "/assets/", "/.hidden", "/link.txt",
                                 "/../secret.txt", "/assets/../../secret.txt", "//index.html"})
    EXPECT_EQ(FindStaticFile(folder, path), "") << path;
  EXPECT_EQ(FindStaticFile("", "/"), "");
}

TEST(StaticFilesTest, TypesAndAgesFitTheFiles) {
  EXPECT_EQ(ContentTypeOf("assets/a.b.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("a.css"), "text/css; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("a.unknown"), "application/octet-stream");
  EXPECT_EQ(CacheControlOf("/assets/a.js"), "private, max-age=31536000, immutable");
  EXPECT_EQ(CacheControlOf("/"), "no-cache");
}

TEST(PageQueueTest, OnlyTheNewestStateOfAKindWaits) {
  PageQueue queue;
  for (const char* const text :
       {R"({"event":"pose","n":1})", R"({"event":"values","n":1})", R"({"id":1})",
        R"({"event":"log","n":1})", R"({"event":"pose","n":2})", R"({"event":"log","n":2})",
        R"({"event":"poses","n":1})", R"({"event":"poses","n":2})"})
    EXPECT_TRUE(queue.Add(text));
  std::vector<std::string> sent;
  while (!queue.empty()) sent.push_back(queue.Next());
  EXPECT_THAT(sent,
              ElementsAre(R"({"event":"values","n":1})", R"({"id":1})", R"({"event":"log","n":1})",
                          R"({"event":"pose","n":2})", R"({"event":"log","n":2})",
                          R"({"event":"poses","n":1})", R"({"event":"poses","n":2})"));
  EXPECT_EQ(queue.Next(), "");
}

TEST(PageQueueTest, StatesGiveWayToAnswers) {
  PageQueue queue;
  const std::string part(PageQueue::kBytesMax / 2, 'x');
  EXPECT_TRUE(queue.Add(part));
  EXPECT_TRUE(queue.Add(R"({"event":"graph"})"));
  EXPECT_TRUE(queue.Add(part));
  EXPECT_EQ(queue.Next(), part);
  EXPECT_EQ(queue.Next(), part);
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.Add(part));
  EXPECT_TRUE(queue.Add(part));
  EXPECT_FALSE(queue.Add("x"));
}

// A bridge to a robot that does not answer before Release(), and then is not there.
class RcBridgeTest : public ::testing::Test {
 protected:
  // Waits until `count` answers have come.
  std::vector<Json> Answers(size_t count) {
    std::vector<Json> answers;
    std::unique_lock lock(mutex_);
    while (answers.size() < count) {
      for (const std::string& text : answers_->TakeAll()) answers.push_back(Json::parse(text));
      if (answers.size() < count) changed_.wait_for(lock, std::chrono::milliseconds(10));
    }
    return answers;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::promise<void> release_;
  std::promise<void> asked_;  // the first call has begun
  std::atomic<int> calls_ = 0;
  const std::shared_ptr<AnswerQueue> answers_ =
      std::make_shared<AnswerQueue>([this] { changed_.notify_all(); });
  RcBridge bridge_{[this, released = release_.get_future().share()]() -> openr::remote::Address {
                     if (calls_++ == 0) asked_.set_value();
                     released.wait();
                     throw std::runtime_error("no robot");
                   },
                   answers_};
};

TEST_F(RcBridgeTest, TheNewestValueOfAJointReplacesThoseThatWait) {
  bridge_.Add({{"call", "connect"}, {"id", 1}}, 10);
  asked_.get_future().wait();
  for (const int id : {2, 3}) bridge_.Add({{"call", "move"}, {"joint", "a"}, {"id", id}}, 10);
  bridge_.Add({{"call", "move"}, {"joint", "b"}, {"id", 4}}, 10);
  bridge_.Add({{"call", "speed"}, {"joint", "a"}, {"id", 5}}, 10);
  bridge_.Add({{"call", "move"}, {"joint", "a"}, {"id", 6}}, 10);
  bridge_.Add({{"call", "stop"}, {"id", 7}}, 10);
  bridge_.Add({{"call", "stop"}, {"id", 8}}, 10);
  release_.set_value();
  std::vector<int> ids;
  for (const Json& answer : Answers(8)) {
    EXPECT_EQ(answer.at("error"), "no robot");
    ids.push_back(answer.at("id"));
  }
  EXPECT_THAT(ids, ElementsAre(1, 4, 5, 2, 3, 6, 7, 8));
  EXPECT_EQ(calls_, 6);
}

TEST_F(RcBridgeTest, CallsBeyondTheLimitAreRefused) {
  bridge_.Add({{"call", "connect"}, {"id", 0}}, 10);
  asked_.get_future().wait();
  for (size_t i = 1; i <= RcBridge::kCallsMax; ++i) bridge_.Add({{"call", "stop"}, {"id", i}}, 10);
  bridge_.Add({{"call", "stop"}, {"id", 1000}}, 10);
  bridge_.Add({{"call", "upload"}, {"id", 1001}}, RcBridge::kBytesMax);
  const std::vector<Json> refused = Answers(2);
  EXPECT_EQ(refused[0].at("id"), 1000);
  EXPECT_EQ(refused[1].at("error"), "too many commands wait for the robot; is it busy?");
  release_.set_value();
  EXPECT_EQ(Answers(RcBridge::kCallsMax + 1).size(), RcBridge::kCallsMax + 1);
}

// While a NoThreads exists, this process cannot make threads: the size of new stacks is set so high
// that no computer has memory for one.
class NoThreads {
 public:
  NoThreads() {
    EXPECT_EQ(pthread_getattr_default_np(&before_), 0);
    pthread_attr_t huge;
    EXPECT_EQ(pthread_getattr_default_np(&huge), 0);
    EXPECT_EQ(pthread_attr_setstacksize(&huge, size_t{1} << 60), 0);
    EXPECT_EQ(pthread_setattr_default_np(&huge), 0);
    pthread_attr_destroy(&huge);
  }
  ~NoThreads() {
    EXPECT_EQ(pthread_setattr_default_np(&before_), 0);
    pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_;
};

// A thread that could not be made must not count as a thread that runs.  Otherwise the server would
// soon reach its limit of threads and make no more, and would wait for such threads at its end.
// Each test fails to make more threads than this limit.
class NoThreadsTest : public ::testing::Test {
 protected:
  static constexpr int kPatienceMs = 60'000;

  NoThreadsTest() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }
  ~NoThreadsTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  // Waits until no thread of `Maker` runs any more, because threads of other tests may still run.
  template <typename Maker>
  static void WaitForThreads() {
    for (int i = 0; i < kPatienceMs && Maker::HasThreads(); ++i) usleep(1000);
    ASSERT_FALSE(Maker::HasThreads()) << "a thread is counted that does not run";
  }

  // Waits for the next answer that a thread gives.
  Json Answer() const {
    for (int i = 0; i < kPatienceMs; ++i) {
      const std::vector<std::string> texts = answers_->TakeAll();
      if (!texts.empty()) return Json::parse(texts[0]);
      usleep(1000);
    }
    ADD_FAILURE() << "no thread has answered";
    return nullptr;
  }

  const ScratchFolder folder_;
  const std::shared_ptr<AnswerQueue> answers_ = std::make_shared<AnswerQueue>([] {});
};

TEST_F(NoThreadsTest, ABridgeToARobotIsMadeAfterFailures) {
  const auto find = []() -> openr::remote::Address { throw std::runtime_error("no robot"); };
  WaitForThreads<RcBridge>();
  {
    const NoThreads none;
    for (int i = 0; i <= RcBridge::kThreadsMax; ++i)
      EXPECT_THROW(RcBridge(find, answers_), std::system_error);
  }
  EXPECT_FALSE(RcBridge::HasThreads());
  RcBridge bridge(find, answers_);
  bridge.Add({{"call", "connect"}, {"id", 1}}, 10);
  EXPECT_EQ(Answer(), Json({{"error", "no robot"}, {"id", 1}}));
}

TEST_F(NoThreadsTest, ABridgeToTwoRobotsIsMadeAfterFailures) {
  const LiveRun run{"gone", 1, folder_.File("gone.1")};
  const nlohmann::json request = {{"endpoint", "127.0.0.1:1"}, {"id", 1}};
  WaitForThreads<PairBridge>();
  {
    const NoThreads none;
    for (int i = 0; i <= PairBridge::kThreadsMax; ++i)
      EXPECT_THROW(PairBridge(run, 0, request, answers_), std::system_error);
  }
  EXPECT_FALSE(PairBridge::HasThreads());
  const PairBridge bridge(run, 0, request, answers_);
  const Json answer = Answer();
  EXPECT_EQ(answer.value("id", 0), 1) << answer;
  EXPECT_TRUE(answer.contains("error")) << answer;
  WaitForThreads<PairBridge>();
}

TEST_F(NoThreadsTest, RunsAreListedAfterFailures) {
  RunsLister lister("own.1");
  WaitForThreads<RunsLister>();
  {
    const NoThreads none;
    for (int id = 1; id <= 100; ++id) EXPECT_THROW(lister.Ask(answers_, id), std::system_error);
  }
  EXPECT_FALSE(RunsLister::HasThreads());
  lister.Ask(answers_, 101);
  EXPECT_EQ(Answer(), Json({{"runs", Json::array()}, {"own", "own.1"}, {"id", 101}}));
  WaitForThreads<RunsLister>();
}

TEST_F(NoThreadsTest, AClientForWhichThereIsNoThreadIsClosed) {
  RcForwarder forwarder([]() -> openr::remote::Address { throw std::runtime_error("no robot"); },
                        "token", true);
  WaitForThreads<RcForwarder>();
  const NoThreads none;
  for (int i = 0; i <= RcForwarder::kWithoutTokenMax; ++i) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    forwarder.ServeClient(ends[1]);
    char byte;
    EXPECT_EQ(recv(ends[0], &byte, 1, 0), 0);
    close(ends[0]);
  }
  EXPECT_FALSE(RcForwarder::HasThreads());
}

// While a NoDescriptors exists, this process can open no descriptors.
class NoDescriptors {
 public:
  NoDescriptors() {
    EXPECT_EQ(getrlimit(RLIMIT_NOFILE, &before_), 0);
    const rlimit none{0, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  }
  ~NoDescriptors() { EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &before_), 0); }
  NoDescriptors(const NoDescriptors&) = delete;
  NoDescriptors& operator=(const NoDescriptors&) = delete;

 private:
  rlimit before_{};
};

// Without the pause, the event loop would call AcceptAll() again and again, and take all processor
// time.
TEST(SpareDescriptorTest, AcceptingPausesOnlyWhileThereIsNoDescriptor) {
  uint16_t port = 0;
  const int listener = Listen("127.0.0.1", &port);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int client = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

  int pauses = 0;
  std::vector<int> taken;
  const auto accept = [&](SpareDescriptor* spare) {
    return AcceptAll(listener, spare, [&](int connection) { taken.push_back(connection); });
  };
  auto none = std::make_unique<NoDescriptors>();
  SpareDescriptor spare([&] { ++pauses; });
  for (int call = 1; call <= 3; ++call) {
    EXPECT_TRUE(accept(&spare));
    EXPECT_EQ(pauses, call);
  }
  EXPECT_EQ(taken.size(), 0u);
  none.reset();
  EXPECT_TRUE(accept(&spare));
  EXPECT_EQ(pauses, 3);
  ASSERT_EQ(taken.size(), 1u);
  close(taken[0]);
  close(client);
  close(listener);
}

TEST(PanelProcessTest, AServerThatCannotBeStartedIsSaid) {
  testing::internal::CaptureStderr();
  {
    const NoDescriptors none;
    const PanelProcess panel(PanelOptions{.port = 0, .run = "played.1"});
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "openr: no panel: it cannot be started: Too many open files\n");
}

}  // namespace
}  // namespace openr_host
