// The end of a run, as a page of the panel hears of it.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "tests/openr/panel_server.h"

namespace openr_host {
namespace {

// The server still has requests for the run when the run ends, so it finds out by a failed write.
// The server is stopped meanwhile, so it finds the last answer and the end at the same time.
TEST_F(PanelTest, ThePageGetsTheLastAnswerOfARunThatTakesNoRequests) {
  FakeRun run("played");
  ProgramRun server({"panel", "--port", "0", "--run", run.id()});
  ASSERT_TRUE(server.WaitForOutput("\n"));
  ReadAddress(server.said());
  WebSocketClient page(port_, Known());
  run.Accept();
  // More requests than the socket of the run and the server together take.
  const std::string request = R"({"do":"status","x":")" + std::string(60'000, 'a') + "\"}";
  for (int i = 0; i < 10; ++i) page.Send(request);
  usleep(500'000);  // the server takes as many of them as it can
  server.Signal(SIGSTOP);
  int status = 0;
  ASSERT_EQ(waitpid(server.pid(), &status, WUNTRACED), server.pid());
  ASSERT_TRUE(WIFSTOPPED(status));
  run.Write("{\"id\":1}\n");
  run.Close();
  server.Signal(SIGCONT);
  EXPECT_EQ(page.Receive(), R"({"id":1})");
  EXPECT_EQ(page.Receive(), R"({"event":"ended","why":"run played (process )" +
                                std::to_string(getpid()) + ") has ended\"}");
  EXPECT_EQ(page.Receive(), "close 4001");
}

}  // namespace
}  // namespace openr_host
