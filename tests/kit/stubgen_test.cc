#include "kit/stubgen.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGood =
    "ObjectName : Mover\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
    "Service : \"Mover.A.T.S\", null, null\nService : \"Mover.B.T.O\", null, null\n";
constexpr const char* kBad = "ObjectName : Mover\nNumOfOSubject : 1\nNumOfOObserver : 1\n";

class StubgenTest : public testing::Test {
 protected:
  StubgenTest() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              (std::string("openr_stubgen_") + info->name() + "_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~StubgenTest() override { fs::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  void WriteFile(const std::string& name, const std::string& text) {
    std::ofstream(Path(name), std::ios::binary) << text;
  }
  std::string ReadFile(const std::string& name) const {
    std::ifstream in(Path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  std::vector<std::string> Names(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(Path(folder))) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  int Run(const StubgenOptions& options) { return RunStubgen(options, in_, out_, err_); }

  fs::path folder_;
  std::istringstream in_;
  std::ostringstream out_;
  std::ostringstream err_;
};

using NameList = std::vector<std::string>;
const NameList kFourFiles = {"MoverStub.cc", "MoverStub.h", "def.h", "entry.h"};

TEST_F(StubgenTest, FourFilesAndNothingElseAreWritten) {
  WriteFile("stub.cfg", kGood);
  EXPECT_EQ(Run({Path("stub.cfg"), Path("out")}), 0);
  EXPECT_EQ(Names("out"), kFourFiles);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(StubgenTest, SummaryCountsServicesAndNamesTheFiles) {
  WriteFile("stub.cfg", std::string(kGood) + "Extra : Tick()\n");
  Run({Path("stub.cfg"), Path("out")});
  EXPECT_EQ(out_.str(), "Mover: 1 subject, 1 observer, 1 extra entry; selectors 0 to 8\nwrote " +
                            Path("out/def.h") + "\nwrote " + Path("out/entry.h") + "\nwrote " +
                            Path("out/MoverStub.h") + "\nwrote " + Path("out/MoverStub.cc") + "\n");
}

TEST_F(StubgenTest, StandardInputIsReadWithoutAFile) {
  in_.str(kGood);
  EXPECT_EQ(Run({"", Path("out")}), 0);
  EXPECT_EQ(Names("out"), kFourFiles);
}

TEST_F(StubgenTest, OutputNamesNoFolder) {
  WriteFile("my.cfg", kGood);
  Run({Path("my.cfg"), Path("out")});
  EXPECT_NE(ReadFile("out/def.h").find("// Made from my.cfg by"), std::string::npos);
  EXPECT_EQ(ReadFile("out/def.h").find(folder_.string()), std::string::npos);
}

TEST_F(StubgenTest, BadInputIsReportedWithItsFileAndWritesNothing) {
  WriteFile("stub.cfg", kBad);
  EXPECT_EQ(Run({Path("stub.cfg"), Path("out")}), 1);
  EXPECT_EQ(err_.str().substr(0, Path("stub.cfg").size() + 4), Path("stub.cfg") + ":2: ");
  EXPECT_FALSE(fs::exists(Path("out")));
}

TEST_F(StubgenTest, BadInputLeavesOlderOutputAsItWas) {
  WriteFile("stub.cfg", kGood);
  ASSERT_EQ(Run({Path("stub.cfg"), folder_.string()}), 0);
  const std::string before = ReadFile("def.h");
  WriteFile("stub.cfg", kBad);
  EXPECT_EQ(Run({Path("stub.cfg"), folder_.string()}), 1);
  EXPECT_EQ(ReadFile("def.h"), before);
}

TEST_F(StubgenTest, WarningsGoToErrAndDoNotStop) {
  WriteFile("stub.cfg", std::string(kGood) + "Extras : Tick()\n");
  EXPECT_EQ(Run({Path("stub.cfg"), Path("out")}), 0);
  EXPECT_NE(err_.str().find("did you mean 'Extra'?"), std::string::npos);
}

TEST_F(StubgenTest, MissingFileIsNamed) {
  EXPECT_EQ(Run({Path("none.cfg"), Path("out")}), 1);
  EXPECT_EQ(err_.str(), Path("none.cfg") + ": cannot be read: No such file or directory\n");
}

TEST_F(StubgenTest, FolderInPlaceOfTheFileGetsASuggestion) {
  EXPECT_EQ(Run({folder_.string(), Path("out")}), 1);
  EXPECT_EQ(err_.str(), folder_.string() + ": is a folder; did you mean '" + folder_.string() +
                            "/stub.cfg'?\n");
}

TEST_F(StubgenTest, OutputThatCannotBeReplacedLeavesNoNewFileBehind) {
  WriteFile("stub.cfg", kGood);
  fs::create_directories(Path("out/MoverStub.cc"));  // a folder where a file shall go
  EXPECT_EQ(Run({Path("stub.cfg"), Path("out")}), 1);
  EXPECT_EQ(Names("out"), NameList{"MoverStub.cc"});
  EXPECT_EQ(err_.str(), Path("out/MoverStub.cc") +
                            ": is a folder; remove it, a file of this name is to be written\n");
}

TEST_F(StubgenTest, OutputFolderThatIsAFileIsRefused) {
  WriteFile("stub.cfg", kGood);
  WriteFile("out", "");
  EXPECT_EQ(Run({Path("stub.cfg"), Path("out")}), 1);
  EXPECT_NE(err_.str().find(Path("out") + ": cannot be made: "), std::string::npos);
}

int MainWith(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = StubgenMain(static_cast<int>(argv.size()), argv.data());
  testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  return code;
}

TEST_F(StubgenTest, CommandLineNamesFileAndFolder) {
  WriteFile("stub.cfg", kGood);
  EXPECT_EQ(MainWith({"stubgen2", Path("stub.cfg"), "-o", Path("out")}), 0);
  EXPECT_EQ(Names("out"), kFourFiles);
}

TEST_F(StubgenTest, BadInputEndsWithOne) {
  WriteFile("stub.cfg", kBad);
  EXPECT_EQ(MainWith({"stubgen2", Path("stub.cfg"), "-o", Path("out")}), 1);
}

TEST_F(StubgenTest, UnknownOptionEndsWithTwo) { EXPECT_EQ(MainWith({"stubgen2", "--colour"}), 2); }

TEST_F(StubgenTest, TwoFilesEndWithTwo) {
  EXPECT_EQ(MainWith({"stubgen2", Path("a.cfg"), Path("b.cfg")}), 2);
}

TEST_F(StubgenTest, HelpEndsWithZero) { EXPECT_EQ(MainWith({"stubgen2", "--help"}), 0); }

}  // namespace
}  // namespace openr_host
