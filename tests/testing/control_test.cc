// Threads and sockets are refused: they are nobody's messages.
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

class ControlTest : public DoublerTest {
 protected:
  ControlTest() { BuildAndBoot(); }
  void Alarm() { bench().Inject(ToEntry("Doubler", "Alarm"), 1); }
};

TEST_F(ControlTest, AThreadOfAnObjectIsRefused) {
  std::string what;
  doubler->on_alarm = [&] {
    try {
      std::thread([] {}).join();
    } catch (const std::system_error& e) {
      what = e.code().message();
    }
  };
  Alarm();
  EXPECT_NONFATAL_FAILURE(
      bench().RunFor(1ms),
      "), asked for a thread: refused, no two runs would be alike.  An object is "
      "woken by messages and timers, one handler at a time.");
  EXPECT_EQ(what, "Resource temporarily unavailable");
}

TEST_F(ControlTest, ASocketOfAnObjectIsRefused) {
  int descriptor = 0;
  doubler->on_alarm = [&] { descriptor = socket(AF_INET, SOCK_STREAM, 0); };
  Alarm();
  EXPECT_NONFATAL_FAILURE(bench().RunFor(1ms), "Doubler, in Alarm (message #");
  EXPECT_EQ(descriptor, -1);
  Alarm();
  EXPECT_NONFATAL_FAILURE(
      bench().Step(),
      "asked for a socket of the host: refused, no two runs would be alike.  The "
      "network of a bench is the robot's IPStack, with AddClient() at the other "
      "end.");
}

TEST_F(ControlTest, BetweenTheVerbsATestDoesWhatItLikes) {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  EXPECT_GE(descriptor, 0);
  close(descriptor);
  std::thread([] {}).join();
  EXPECT_TRUE(bench().RunFor(1ms));
}

TEST_F(ControlTest, AThreadThatLivesBesideTheBenchIsRefused) {
  std::atomic<bool> ends = false;
  std::thread other([&] {
    while (!ends) usleep(1000);
  });
  EXPECT_NONFATAL_FAILURE(bench().RunFor(1ms),
                          "This process has 2 threads, and no two runs beside others are alike.");
  Bench tolerant({.allow_threads = true});
  tolerant.Boot();
  EXPECT_TRUE(tolerant.RunFor(1ms));
  ends = true;
  other.join();
  EXPECT_TRUE(bench().RunFor(1ms));
}

}  // namespace
}  // namespace openr::testing
