// The stick that came with the program is that of every run without --stick, and no run writes it.
#include <gmock/gmock.h>
#include <stdlib.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

// The program as it is installed, with a default stick whose object does what it is told; and a
// cache folder of its own.
class Installed {
 public:
  explicit Installed(const std::string& word) {
    const fs::path built = fs::path(OPENR_PROGRAM).parent_path().parent_path();
    fs::create_directory(prefix_.File("bin"));
    fs::copy_file(OPENR_PROGRAM, program());
    fs::create_symlink(built / "lib", prefix_.File("lib"));
    fs::create_symlink(built / "share", prefix_.File("share"));
    trouble_.MakeTrouble(word);
    fs::copy(trouble_.path(), stick(), fs::copy_options::recursive);
    setenv("XDG_CACHE_HOME", prefix_.File("cache").c_str(), 1);
    before_ = Files(stick());
  }
  ~Installed() { unsetenv("XDG_CACHE_HOME"); }
  Installed(const Installed&) = delete;
  Installed& operator=(const Installed&) = delete;

  ProgramResult Run(std::vector<std::string> arguments) const {
    return ProgramRun(std::move(arguments), program()).Finish();
  }
  ProgramResult RunFor1s(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"run",        "--for",     "1s", "--rate", "max",
                                          "--no-panel", "--rc-port", "0",  "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments);
  }

  std::string program() const { return prefix_.File("bin/openr"); }
  std::string stick() const { return prefix_.File("stick"); }
  std::string File(const std::string& name) const { return prefix_.File(name); }
  std::string Read(const std::string& name) const { return prefix_.Read(name); }
  // The same files under another name.
  const ScratchFolder& other_stick() const { return trouble_; }

  bool IsAsBefore() const { return Files(stick()) == before_; }

 private:
  using Listing = std::map<std::string, std::pair<std::string, fs::file_time_type>>;

  // Content, of files, and time of each.
  static Listing Files(const std::string& folder) {
    Listing files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      std::string content;
      if (entry.is_regular_file()) {
        std::ifstream file(entry.path(), std::ios::binary);
        content.assign(std::istreambuf_iterator<char>(file), {});
      }
      files[entry.path()] = {content, entry.last_write_time()};
    }
    return files;
  }

  ScratchFolder prefix_, trouble_;
  Listing before_;
};

TEST(DefaultStickTest, WhatObjectsWriteIsGoneAfterTheRun) {
  const Installed installed("write");
  const ProgramResult result = installed.RunFor1s({});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("left behind: 1\n"));
  EXPECT_TRUE(installed.IsAsBefore());
}

TEST(DefaultStickTest, AStickThatIsNamedIsWrittenAndTheRunIsTheSame) {
  const Installed installed("write");
  const ProgramResult by_default = installed.RunFor1s({});
  const ProgramResult named = installed.RunFor1s({"--stick", installed.other_stick().path()});
  EXPECT_EQ(installed.other_stick().Read("OPEN-R/MW/DATA/P/LEFT.TXT"), "left");
  const json a = json::parse(by_default.out), b = json::parse(named.out);
  EXPECT_EQ(a["trace_hash"], b["trace_hash"]);
  EXPECT_EQ(a["state_hash"], b["state_hash"]);
}

TEST(DefaultStickTest, ThePersonMayNameTheDefaultStick) {
  const Installed installed("write");
  EXPECT_EQ(installed.RunFor1s({"--stick", installed.stick()}).status, 0);
  EXPECT_EQ(installed.Read("stick/OPEN-R/MW/DATA/P/LEFT.TXT"), "left");
}

TEST(DefaultStickTest, AStickThatNobodyMayWriteIsACopyThatObjectsMay) {
  const Installed installed("write");
  for (const auto& entry : fs::recursive_directory_iterator(installed.stick()))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::remove);
  EXPECT_THAT(installed.RunFor1s({}).err, HasSubstr("left behind: 1\n"));
  for (const auto& entry : fs::recursive_directory_iterator(installed.stick()))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
}

TEST(DefaultStickTest, OtherCommandsDoNotWriteIt) {
  const Installed installed("write");
  const std::string file = installed.File("r.trace");
  EXPECT_EQ(installed.RunFor1s({"--record", file}).status, 0);
  EXPECT_EQ(installed.Run({"replay", file}).status, 0);
  EXPECT_EQ(installed.Run({"graph", "--for", "1s"}).status, 0);
  EXPECT_EQ(installed.RunFor1s({"--robots", "2"}).status, 0);
  installed.Run({"explore", "--runs", "2", "--for", "100ms", "--jobs", "1"});
  EXPECT_TRUE(installed.IsAsBefore());
}

TEST(DefaultStickTest, ARecordingNamesTheStickThatIsThereAfterwards) {
  const Installed installed("write");
  const std::string file = installed.File("r.trace");
  installed.RunFor1s({"--record", file});
  EXPECT_THAT(installed.Read("r.trace"), HasSubstr("\"stick\":\"" + installed.stick() + "\""));
}

TEST(DefaultStickTest, OfAProcessOfItsOwnAsWell) {
  const Installed installed("write");
  const ProgramResult result = installed.RunFor1s({"--isolate", "Trouble"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("left behind: 1\n"));
  EXPECT_TRUE(installed.IsAsBefore());
}

// The default stick needs a folder for its copy, and any stick one for the images of the run.
TEST(DefaultStickTest, APlaceForTemporaryFoldersThatCannotBeUsedIsNamed) {
  const Installed installed("nothing");
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/proc", 1);  // where not even root makes a folder
  const ProgramResult copied = installed.RunFor1s({});
  const ProgramResult named = installed.RunFor1s({"--stick", installed.stick()});
  before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  for (const ProgramResult& result : {copied, named}) {
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr("openr: /proc: no temporary folder can be made there: "));
  }
}

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports crashes itself
TEST(DefaultStickTest, TheRecordOfACrashIsInTheCacheFolder) {
  const Installed installed("crash");
  const std::string file = installed.File("cache/openr-host/EMON.LOG");
  const std::vector<std::vector<std::string>> runs = {{}, {"--isolate", "Trouble"}};
  for (const auto& flags : runs) {
    fs::remove(file);
    const ProgramResult result = installed.RunFor1s(flags);
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr("openr: wrote " + file + "\n"));
    EXPECT_THAT(installed.Read("cache/openr-host/EMON.LOG"), HasSubstr("EXCEPTION SIGSEGV"));
    EXPECT_TRUE(installed.IsAsBefore());
    EXPECT_THAT(json::parse(result.out)["findings"].dump(), HasSubstr("; record: " + file + "; "));
  }
}

TEST(DefaultStickTest, ACacheFolderThatCannotBeMadeIsNamedAfterACrash) {
  const Installed installed("crash");
  std::ofstream(installed.File("cache")) << "a file, where the cache folder has to be";
  const ProgramResult result = installed.RunFor1s({});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("openr: " + installed.File("cache/openr-host/EMON.LOG") +
                                    ": the record of the crash cannot be written: "));
}
#endif

}  // namespace
}  // namespace openr_host
