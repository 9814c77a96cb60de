// Two network namespaces that stand for two hosts, and a cable between them that can fail
// (relay.h).
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "tests/distribution/relay.h"
#include "tests/distribution/same_run.h"

namespace openr_host {

// Returns "name-1234", unique on this machine.
inline std::string RunName(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

constexpr const char* kNoHosts = "two hosts on this one: root, iproute2 and /dev/net/tun";

class TwoHosts {
 public:
  static constexpr const char* kHere = "10.77.0.1";
  static constexpr const char* kThere = "10.77.0.2";

  ~TwoHosts() {
    cable_.reset();
    Do("ip netns del " + here_);
    Do("ip netns del " + there_);
  }

  // Connects the two hosts.  Returns false when this machine does not allow network namespaces.
  bool Connect(uint32_t seed = 1) {
    const int left = Make(here_, kHere), right = Make(there_, kThere);
    if (left >= 0 && right >= 0) cable_ = std::make_unique<Relay>(left, right, seed);
    return cable_ != nullptr;
  }
  // Does the same for SetUp().  Where changes are accepted (CI), a test must not be skipped
  // unnoticed.
  void ConnectOrSkip() {
    if (Connect()) return;
    const char* const ci = std::getenv("CI");
    if (ci != nullptr && std::string(ci) == "true") FAIL() << "this needs " << kNoHosts;
    GTEST_SKIP() << kNoHosts;
  }
  Relay& cable() { return *cable_; }
  void Cut() { cable_->Cut(); }
  void Mend() { cable_->Mend(); }
  // Cuts the cable so that senders on the host get errors, unlike Cut().
  void Unplug() { Do("ip -n " + here_ + " link set cable down"); }

  // Starts openr on a host, with `arguments` and the addresses of both hosts.
  std::unique_ptr<ProgramRun> StartHere(const Words& arguments) {
    return StartIn(here_, "here", arguments + Words{"--dds-address", kHere, "--dds-peer", kThere});
  }
  std::unique_ptr<ProgramRun> StartThere(const Words& arguments) {
    return StartIn(there_, "there",
                   arguments + Words{"--dds-address", kThere, "--dds-peer", kHere});
  }

 private:
  static int Do(const std::string& command) {
    return std::system(("(" + command + ") 2>/dev/null").c_str());
  }
  // Makes a host.  Returns the other end of its interface; -1 on failure.
  static int Make(const std::string& host, const std::string& address) {
    std::string name;
    const int end = OpenTun(&name);
    const std::string in_host = "ip -n " + host;
    if (end >= 0 && Do("ip netns add " + host) == 0 &&
        Do("ip link set " + name + " netns " + host) == 0 &&
        Do(in_host + " link set " + name + " name cable") == 0 &&
        Do(in_host + " addr add " + address + "/24 dev cable") == 0 &&
        Do(in_host + " link set cable up && " + in_host + " link set lo up") == 0) {
      return end;
    }
    close(end);
    return -1;
  }
  // Starts openr in a process whose host name is `name`.
  static std::unique_ptr<ProgramRun> StartIn(const std::string& host, const std::string& name,
                                             const Words& arguments) {
    return std::make_unique<ProgramRun>(Words{"-c",
                                              "exec ip netns exec \"$0\" unshare --uts "
                                              "sh -c 'hostname \"$0\" && exec \"$@\"' \"$@\"",
                                              host, name, OPENR_PROGRAM} +
                                            arguments,
                                        "/bin/sh");
  }

  const std::string here_ = RunName("openr-a");
  const std::string there_ = RunName("openr-b");
  std::unique_ptr<Relay> cable_;
};

}  // namespace openr_host
