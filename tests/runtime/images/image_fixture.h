// A stick in a temporary folder with the probe image on it, and somebody to talk to it.
#pragma once

#include <MCOOP.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cfenv>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include "runtime/core/load_stick.h"
#include "runtime/stick/memory_stick.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {

namespace fs = std::filesystem;

// Talks to the probe: sends a text, keeps the answers.
class Talker : public CodeObject {
 public:
  explicit Talker(int number) {
    out = AddSubject(fmt::format("Talker{}.Out.Text.S", number));
    in = AddObserver(fmt::format("Talker{}.In.Text.O", number), [this](const ONotifyEvent& event) {
      answer = static_cast<const char*>(event.Data(0));
      in->AssertReady();
    });
    sleep = AddExtra("Sleep", [this](void*) {
      bool timed_out = false;
      const uint64_t box = system().requests().OpenBox();
      system().requests().Await(box, kSleepUs, "nothing", &timed_out);
    });
    AddExtra("Tick", [this](void*) { ++ticks; });
    AddExtra("Answer", [this](void*) {
      ++questions;
      rounding = std::fegetround();
      char reply[] = "me";
      Reply(reply, sizeof reply);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    in->AssertReady();
    return oSUCCESS;
  }
  std::string Ask(const std::string& text) {
    answer = "(no answer)";
    RunAs(this, [&] {
      out->SetData(text.c_str(), text.size() + 1);
      out->NotifyObservers();
    });
    system().RunFor(1000);
    return answer;
  }

  static constexpr int64_t kSleepUs = 5000;

  OSubject* out;
  OObserver* in;
  Selector sleep;  // the entry whose handler waits for kSleepUs
  std::string answer;
  // The number of messages to Tick, the sixth entry, which a constructor of the probe orders.
  int ticks = 0;
  int questions = 0;  // the number of requests to Answer, the seventh entry
  int rounding = -1;  // the rounding mode during the last of them (std::fegetround())
};

class ImageTest : public testing::Test {
 protected:
  ImageTest() {
    std::string name = (fs::temp_directory_path() / "openr-image-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    root = name;
    for (const char* folder : {"OPEN-R/MW/CONF", "OPEN-R/MW/OBJS", "OPEN-R/MW/DATA/P"}) {
      fs::create_directories(root / folder);
    }
    fs::copy_file(fs::path(OPENR_IMAGES) / "PROBE.BIN", root / "OPEN-R/MW/OBJS/PROBE.BIN");
    Write("OPEN-R/MW/DATA/P/HELLO.TXT", "hello stick");
    Write("OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/PROBE.BIN\r\n");
    Write("OPEN-R/MW/CONF/CONNECT.CFG",
          "Talker0.Out.Text.S Probe.In.Text.O\nProbe.Out.Text.S Talker0.In.Text.O\n");
    stick = std::make_shared<FolderStick>(root);
  }
  ~ImageTest() override { fs::remove_all(root); }

  void Write(const std::string& name, const std::string& text) {
    std::ofstream(root / name, std::ios::binary) << text;
  }
  void Start(SystemOptions options = {}) {
    options.console = [this](std::string_view text) { printed += text; };
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", stick);
    talker = system->AddObject<Talker>(0, "talker", 0);
    EXPECT_TRUE(LoadStick(system.get(), 0));
    system->Boot();
    system->RunFor(1000);
  }
  void SendExtra(const char* name) {
    Object* const probe = system->FindObject(0, "probe");
    for (const auto& [selector, entry] : probe->entry_names().names()) {
      if (entry != name) continue;
      system->Post(system->NewMessage(probe->id, selector));
      system->RunFor(1000);
      return;
    }
    FAIL() << "no entry " << name;
  }
  std::string Findings() {
    std::string text;
    for (const Finding& finding : system->findings().all()) text += finding.text + "\n";
    return text;
  }

  fs::path root;
  std::shared_ptr<FolderStick> stick;
  std::string printed;
  std::unique_ptr<System> system;
  Talker* talker = nullptr;
};

}  // namespace openr_host
