// A small object under test, and the bench it lies on.
#pragma once

#include <OPENR/OSyslog.h>
#include <gtest/gtest-spi.h>
#include <openr/testing.h>

#include <functional>
#include <vector>

namespace openr::testing {

// Sends twice of every number it gets, and says ready again.
class Doubler : public openr_host::CodeObject {
 public:
  Doubler() {
    in_ = AddObserver("Doubler.In.int.O", [this](const ONotifyEvent& event) {
      for (int i = 0; i < event.NumOfData(); ++i) {
        const int twice = 2 * *static_cast<const int*>(event.Data(i));
        out_->SetData(&twice, sizeof twice);
        out_->NotifyObservers();
      }
      in_->AssertReady();
    });
    out_ = AddSubject("Doubler.Out.int.S");
    AddExtra("Alarm", [this](void* message) {
      alarms.push_back(*static_cast<int*>(message));
      if (on_alarm) on_alarm();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    in_->AssertReady();
    return oSUCCESS;
  }

  std::vector<int> alarms;
  std::function<void()> on_alarm;

 private:
  OObserver* in_;
  OSubject* out_;
};

class DoublerTest : public ::testing::Test {
 protected:
  // Between a feeding and a watching probe, Test1 and Test2.
  void Build(BenchOptions options = {}) {
    bench_.emplace(std::move(options));
    doubler = &bench().Add<Doubler>("Doubler");
    in = &bench().Feed("Doubler.In.int.O");
    out = &bench().Watch("Doubler.Out.int.S");
  }
  void BuildAndBoot(BenchOptions options = {}) {
    Build(std::move(options));
    bench().Boot();
  }
  Bench& bench() { return *bench_; }
  // Destroys the bench within the test, because the failures that ~Bench() adds are tested, too.
  void EndBench() { bench_.reset(); }

  Doubler* doubler = nullptr;
  ProbeSubject* in = nullptr;
  ProbeObserver* out = nullptr;

 private:
  std::optional<Bench> bench_;
};

using Ints = std::vector<int>;
using Texts = std::vector<std::string>;

}  // namespace openr::testing
