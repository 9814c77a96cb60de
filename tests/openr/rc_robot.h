// A robot that runs in another process, for tests that ask it with `openr rc` or openr::remote.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "openr/remote/connection.h"
#include "tests/openr/program_run.h"

namespace openr_host {

namespace remote = openr::remote;

// Runs with the ideal body and stands after Start().
class RcRobot {
 public:
  RcRobot()
      : run_({"run", "--rate", "max", "--no-panel", "--rc-port", "0", "--body", "ideal"}),
        is_ready_(run_.WaitFor("state: accepting-commands") &&
                  run_.WaitFor("openr rc 127.0.0.1:")) {}
  ~RcRobot() { run_.Signal(SIGINT); }

  // Returns "" when the robot stands, else what the run has said.
  std::string Problem() { return is_ready_ ? "" : run_.Finish().err; }

  std::string address() const {
    const std::string& text = run_.heard();
    const size_t begin = text.find("127.0.0.1:");
    return text.substr(begin, text.find(' ', begin) - begin);
  }
  remote::Address remote_address() const { return remote::ParseAddress(address()); }

  ProgramResult Rc(const std::vector<std::string>& words) const {
    std::vector<std::string> arguments{"rc", address(), "--json"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return RunProgram(arguments);
  }

  // Returns the answers of a command that must succeed, one JSON object for each line.
  std::vector<nlohmann::json> Answers(const std::vector<std::string>& words) const {
    const ProgramResult result = Rc(words);
    EXPECT_EQ(result.status, 0) << result.err;
    std::vector<nlohmann::json> answers;
    for (size_t at = 0; at < result.out.size();) {
      const size_t end = result.out.find('\n', at);
      answers.push_back(nlohmann::json::parse(result.out.substr(at, end - at)));
      at = end == std::string::npos ? end : end + 1;
    }
    return answers;
  }

 private:
  ProgramRun run_;
  const bool is_ready_;
};

}  // namespace openr_host
