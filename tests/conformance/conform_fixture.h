// Two objects built from stub.cfg files on a stick of their own: Teller acts, Hearer hears
// (tests/images/Conform).  They do what texts tell them; what they print is compared.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "runtime/base/temp_folder.h"
#include "runtime/core/code_object.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {

// Processes of their own for the objects, in the program that tests distribution
// (tests/distribution/apart_test.cc).
class Elsewhere {
 public:
  virtual ~Elsewhere() = default;
  virtual StandIns StandInsFor(System* system) = 0;
  virtual void Connect() = 0;  // before the boot
};
inline std::unique_ptr<Elsewhere> (*make_elsewhere)(const std::filesystem::path& stick) = nullptr;
inline std::set<std::string> here_only;  // tests that say something about one process

class ConformTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    if (make_elsewhere != nullptr && here_only.contains(test.name())) GTEST_SKIP() << "here only";
  }

  ConformTest() : root(folder.path()) {
    namespace fs = std::filesystem;
    for (const char* name : {"OPEN-R/MW/CONF", "OPEN-R/MW/OBJS", "OPEN-R/MW/DATA/P"})
      fs::create_directories(root / name);
    for (const char* name : {"TELLER.BIN", "HEARER.BIN"})
      fs::copy_file(fs::path(OPENR_IMAGES) / name, root / "OPEN-R/MW/OBJS" / name);
    Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TELLER.BIN\n/MS/OPEN-R/MW/OBJS/HEARER.BIN\n");
    Config("CONNECT.CFG", "Teller.Out.Number.S Hearer.In.Number.O\n");
    Data("HELLO.TXT", "hello stick");
    stick = std::make_shared<FolderStick>(root);
  }

  void Write(const std::string& name, const std::string& text) {
    std::ofstream(root / name, std::ios::binary) << text;
  }
  void Config(const std::string& name, const std::string& text) {
    Write("OPEN-R/MW/CONF/" + name, text);
  }
  void Data(const std::string& name, const std::string& text) {
    Write("OPEN-R/MW/DATA/P/" + name, text);
  }

  // Makes the system and its objects; true when the robot would boot.
  bool Load(SystemOptions options = {}) {
    elsewhere.reset();
    options.console = [this](std::string_view text) { printed += text; };
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", stick);
    if (make_elsewhere == nullptr) return LoadStick(system.get(), 0);
    elsewhere = make_elsewhere(root);
    return LoadStick(system.get(), 0, elsewhere->StandInsFor(system.get()));
  }
  void Boot() {
    if (elsewhere != nullptr) elsewhere->Connect();
    system->Boot();
    Settle();
  }
  // Up to the first command; forgets what was printed on the way.
  void Start(SystemOptions options = {}) {
    EXPECT_TRUE(Load(std::move(options))) << Findings();
    Boot();
    printed.clear();
  }

  void Settle() { system->RunFor(1000); }
  void Tell(const std::string& command) { Command("teller", command); }
  void Hear(const std::string& command) { Command("hearer", command); }
  std::string Said() { return std::exchange(printed, ""); }
  // Returns the text that the object prints for one command.
  std::string Answer(const std::string& command) {
    printed.clear();
    Tell(command);
    return Said();
  }

  ObjectId IdOf(const std::string& name) { return system->FindObject(0, name)->id; }
  Selector EntryOf(const std::string& object, const std::string& entry) {
    for (const auto& [selector, name] : system->FindObject(0, object)->entry_names().names()) {
      if (name == entry) return selector;
    }
    ADD_FAILURE() << "no entry " << entry;
    return UNDEF;
  }
  int32_t Post(const std::string& object, const std::string& entry, const std::string& text) {
    OwnedMessage message = system->NewMessage(IdOf(object), EntryOf(object, entry));
    std::memcpy(message->payload, text.c_str(), text.size() + 1);
    message->size = static_cast<uint32_t>(text.size() + 1);
    return system->Post(std::move(message));
  }

  std::string Findings() {
    std::string text;
    for (const Finding& finding : system->findings().all()) text += finding.text + "\n";
    return text;
  }
  bool Found(const std::string& part) { return Findings().find(part) != std::string::npos; }

  const TempFolder folder;
  const std::filesystem::path root;
  std::shared_ptr<FolderStick> stick;
  std::string printed;
  std::unique_ptr<System> system;
  std::unique_ptr<Elsewhere> elsewhere;  // ends before the system

 private:
  void Command(const char* object, const std::string& command) {
    Post(object, "Command", command);
    Settle();
  }
};

}  // namespace openr_host
