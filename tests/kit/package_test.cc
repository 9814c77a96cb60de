// Tests of the CMake package and of the Makefile that an installation has for other build systems.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

constexpr char kHeard[] = "heard: greeting 1\nheard: greeting 2\nheard: greeting 3\n";

// The program of the fixture without its Makefiles, and an installation of what was built.
class PackageTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    prefix_ = new ScratchFolder();
    install_ = RunProcess({"cmake", "--install", OPENR_BUILD, "--prefix", prefix_->path()},
                          {{}, "", true, true});
  }
  static void TearDownTestSuite() { delete prefix_; }

  void SetUp() override {
    ASSERT_TRUE(install_.good()) << install_.output;
    for (const char* name : {"Makefile", "Sender/Makefile", "Receiver/Makefile"})
      std::filesystem::remove(folder_.File(name));
    folder_.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG",
                  "/MS/OPEN-R/MW/OBJS/SENDER.BIN\n/MS/OPEN-R/MW/OBJS/RECEIVER.BIN\n");
  }

  // With the installed program.
  std::string Say(const std::string& stick, const std::vector<std::string>& flags = {}) const {
    std::vector<std::string> command = {prefix_->File("bin/openr"),
                                        "run",
                                        "--stick",
                                        folder_.File(stick),
                                        "--for",
                                        "1s",
                                        "--rate",
                                        "max",
                                        "--no-panel"};
    command.insert(command.end(), flags.begin(), flags.end());
    const ProcessResult result = RunProcess(command, {{}, "", true, true});
    return KitFolder::WordsOfObjects(result.output);
  }

  static inline ScratchFolder* prefix_ = nullptr;
  static inline ProcessResult install_;
  const KitFolder folder_{"makefile"};
};

// openr::testing needs more than objects do.
TEST_F(PackageTest, WithoutAPackageOfTheTestsItSaysWhichAndObjectsAreStillThere) {
  folder_.Write("CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.16)\n"
                "project(chat LANGUAGES CXX)\n"
                "find_package(openr-host REQUIRED)\n"
                "if(TARGET openr::testing OR NOT COMMAND openr_add_object)\n"
                "  message(FATAL_ERROR \"not as promised\")\n"
                "endif()\n");
  const ProcessResult configured =
      RunProcess({"cmake", "-S", folder_.File(""), "-B", folder_.File("build"), "-G", "Ninja",
                  "-DCMAKE_PREFIX_PATH=" + prefix_->path(), "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=TRUE",
                  "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=TRUE"},
                 {{}, "", true, true});
  EXPECT_TRUE(configured.good()) << configured.output;
  EXPECT_THAT(configured.output,
              HasSubstr("no openr::testing without these packages: libfmt-dev libpng-dev"));
}

TEST_F(PackageTest, CMakeFindsThePackageAndBuildsObjectsAndAStick) {
  folder_.Write("CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.16)\n"
                "project(chat LANGUAGES CXX)\n"
                "find_package(openr-host REQUIRED)\n"
                "openr_add_object(NAME sender STUB Sender/stub.cfg OCF Sender/sender.ocf\n"
                "  SOURCES Sender/Sender.cc common/Greeting.cc INCLUDES Sender common)\n"
                "openr_add_object(NAME receiver STUB Receiver/stub.cfg OCF Receiver/receiver.ocf\n"
                "  SOURCES Receiver/Receiver.cc INCLUDES Receiver)\n"
                "openr_add_stick(NAME stick FOLDER MS OBJECTS sender receiver)\n");
  const ProcessResult configured =
      RunProcess({"cmake", "-S", folder_.File(""), "-B", folder_.File("build"), "-G", "Ninja",
                  "-DCMAKE_PREFIX_PATH=" + prefix_->path()},
                 {{}, "", true, true});
  ASSERT_TRUE(configured.good()) << configured.output;
  const ProcessResult built =
      RunProcess({"cmake", "--build", folder_.File("build")}, {{}, "", true, true});
  ASSERT_TRUE(built.good()) << built.output;
  EXPECT_EQ(Say("build/stick"), kHeard);
  // OBJECT.CFG names no POWERMON.BIN.
  EXPECT_FALSE(std::filesystem::exists(folder_.File("build/stick/OPEN-R/MW/OBJS/POWERMON.BIN")));
  EXPECT_TRUE(std::filesystem::exists(folder_.File("build/stick/OPEN-R/MW/DATA/P")));
}

TEST_F(PackageTest, TheTutorialOnTestingBuildsAsItsPageSays) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the installed library wants a program with sanitizers";
#endif
  const std::string build = folder_.File("build");
  const ProcessResult configured =
      RunProcess({"cmake", "-S", TUTORIAL, "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix_->path()},
                 {{}, "", true, true});
  ASSERT_TRUE(configured.good()) << configured.output;
  const ProcessResult built = RunProcess({"cmake", "--build", build}, {{}, "", true, true});
  ASSERT_TRUE(built.good()) << built.output;
  // All tests of the tutorial run, also when this program runs a share of its own.
  const ProcessResult run = RunProcess(
      {"env", "-u", "GTEST_TOTAL_SHARDS", "-u", "GTEST_SHARD_INDEX", build + "/meter_test"},
      {{}, "", true, true});
  EXPECT_TRUE(run.good()) << run.output;
  EXPECT_THAT(run.output, HasSubstr("[  PASSED  ] 4 tests."));
}

// Returns the text between the first line "```LANGUAGE" behind `heading` of a page and the next
// "```".
std::string Block(const std::string& page, const std::string& heading,
                  const std::string& language) {
  std::ifstream stream(std::string(OPENR_DOCS) + "/" + page);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string begin = "```" + language + "\n";
  const size_t at = text.find(begin, text.find("\n" + heading + "\n"));
  if (at == std::string::npos) return "";
  return text.substr(at + begin.size(), text.find("\n```", at) + 1 - at - begin.size());
}

TEST_F(PackageTest, TheClientOfThePageOnTheRemoteControlBuilds) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the installed library wants a program with sanitizers";
#endif
  std::string client = Block("remote-control.md", "## From C++", "cpp");
  const size_t port = client.find("54000");
  ASSERT_NE(port, std::string::npos);
  folder_.Write("client.cc", client.replace(port, 5, "1"));  // where no robot is
  folder_.Write("CMakeLists.txt", Block("remote-control.md", "## From C++", "cmake"));
  const std::string build = folder_.File("build");
  const ProcessResult configured = RunProcess(
      {"cmake", "-S", folder_.File(""), "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix_->path()},
      {{}, "", true, true});
  ASSERT_TRUE(configured.good()) << configured.output;
  const ProcessResult built = RunProcess({"cmake", "--build", build}, {{}, "", true, true});
  ASSERT_TRUE(built.good()) << built.output;
  const ProcessResult run = RunProcess({build + "/client"}, {{}, "", true, true});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, HasSubstr("127.0.0.1:1: no program listens there; is 'openr run'"));
}

TEST_F(PackageTest, AnInstallationHasDocumentsLicenceManualPagesAndCompletion) {
  for (const char* file : {"share/doc/openr-host/copyright", "share/doc/openr-host-dev/copyright",
                           "share/man/man1/openr.1.gz", "share/man/man1/openr-run.1.gz",
                           "share/bash-completion/completions/openr",
                           "share/pkgconfig/openr-host.pc", "lib/openr-host/libopenr_runtime.so"})
    EXPECT_TRUE(std::filesystem::is_regular_file(prefix_->File(file))) << file;
  const std::string documents = prefix_->File("share/doc/openr-host/");
  for (const char* file : {"README.md", "docs/cli.md", "examples/README.md"})
    EXPECT_TRUE(std::filesystem::is_regular_file(documents + file)) << file;
  // Nothing of the build stays in the examples.
  EXPECT_FALSE(std::filesystem::exists(documents + "examples/Hello/MS/OPEN-R/MW/OBJS/HELLO.BIN"));
}

// Returns the links of a Markdown document to files that are not there.
std::vector<std::string> LinksToNowhere(const std::filesystem::path& document) {
  static const std::regex link(R"(\[[^\]\[]+\]\(([^)#: ]+)[)#])");
  std::vector<std::string> found;
  std::ifstream stream(document);
  for (std::string line; std::getline(stream, line);) {
    for (std::sregex_iterator at(line.begin(), line.end(), link), end; at != end; ++at) {
      if (!std::filesystem::exists(document.parent_path() / (*at)[1].str()))
        found.push_back((*at)[1]);
    }
  }
  return found;
}

TEST_F(PackageTest, NoLinkOfADocumentLeadsOutOfTheInstallation) {
  const std::filesystem::path documents = prefix_->File("share/doc/openr-host");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(documents)) {
    if (entry.path().extension() != ".md") continue;
    EXPECT_THAT(LinksToNowhere(entry.path()), ::testing::IsEmpty()) << entry.path();
  }
  // A link to the sources has become its text; one to another document has stayed.
  std::ifstream stream(documents / "README.md");
  const std::string readme{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_THAT(readme, HasSubstr("**OVirtualRobotComm** is the robot: virtualrobot/, a body"));
  EXPECT_THAT(readme, HasSubstr("([docs/body.md](docs/body.md))"));
}

// A person who takes a part of it does not get the others.
TEST_F(PackageTest, AComponentIsInstalledAlone) {
  const ScratchFolder scratch;
  const ProcessResult installed = RunProcess(
      {"cmake", "--install", OPENR_BUILD, "--prefix", scratch.path(), "--component", "runtime"},
      {{}, "", true, true});
  ASSERT_TRUE(installed.good()) << installed.output;
  EXPECT_TRUE(std::filesystem::exists(scratch.File("bin/openr")));
  EXPECT_FALSE(std::filesystem::exists(scratch.File("bin/stubgen2")));
  EXPECT_FALSE(std::filesystem::exists(scratch.File("share/openr-host/sdk")));
  const ProcessResult build =
      RunProcess({scratch.File("bin/openr"), "build", folder_.File("")}, {{}, "", true, true});
  EXPECT_THAT(build.output, HasSubstr("openr-host-dev"));
}

// Whoever builds single targets and then installs is told what cannot be built.
TEST_F(PackageTest, WhatCannotBeBuiltIsNamedWithTheTargetThatBuildsIt) {
  const ScratchFolder scratch;
  const std::string script = scratch.File("cmake_install.cmake");
  // The script of the build, as if its folder were an empty one.
  std::ifstream stream(std::string(OPENR_BUILD) + "/cmake_install.cmake");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (size_t at = text.find(OPENR_BUILD); at != std::string::npos; at = text.find(OPENR_BUILD, at))
    text.replace(at, std::string(OPENR_BUILD).size(), scratch.path());
  scratch.Write("cmake_install.cmake", text);
  const ProcessResult installed =
      RunProcess({"cmake", "-DCMAKE_INSTALL_PREFIX=" + scratch.File("opt"), "-P", script},
                 {{}, "", true, true});
  EXPECT_FALSE(installed.good());
  EXPECT_THAT(installed.output, HasSubstr("bin/openr is not built yet"));
  EXPECT_THAT(installed.output, HasSubstr("--target"));
  EXPECT_THAT(installed.output, HasSubstr("install_parts"));
}

// A build of the program alone leaves the library out.
TEST_F(PackageTest, WithoutTheLibraryOfTheTestsItSaysWhatBuildsIt) {
  const ScratchFolder copy;
  namespace fs = std::filesystem;
  fs::copy(prefix_->path(), copy.File("opt"),
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  fs::remove(copy.File("opt/lib/openr-host/libopenr_testing.a"));
  folder_.Write("CMakeLists.txt",
                "cmake_minimum_required(VERSION 3.16)\nproject(chat LANGUAGES CXX)\n"
                "find_package(openr-host REQUIRED)\n");
  const auto configured = [&] {
    return RunProcess({"cmake", "-S", folder_.File(""), "-B", folder_.File("build"), "-G", "Ninja",
                       "-DCMAKE_PREFIX_PATH=" + copy.File("opt")},
                      {{}, "", true, true})
        .output;
  };
  EXPECT_THAT(configured(), HasSubstr("build openr-host with OPENR_TESTING=ON"));
  copy.Write("opt/CMakeCache.txt", "");  // a folder that something is built in
  EXPECT_THAT(configured(),
              HasSubstr("cmake --build " + copy.File("opt") + " --target openr_testing"));
}

TEST_F(PackageTest, AMakefileIncludesTheKitsRules) {
  folder_.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG",
                "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/SENDER.BIN\n"
                "/MS/OPEN-R/MW/OBJS/RECEIVER.BIN\n");
  for (const char* name : {"Sender", "Receiver"}) {
    std::string object = name;
    object[0] = static_cast<char>(object[0] - 'A' + 'a');
    folder_.Write(std::string(name) + "/Makefile",
                  "OBJECT = " + object + "\nSTUB = stub.cfg\nOCF = " + object + ".ocf\nSOURCES = " +
                      name + ".cc\nCOMMON = ../common/Greeting.cc\nCXXFLAGS = -I../common\n" +
                      "MS = ../MS\ninclude $(shell pkg-config --variable=makefile openr-host)\n");
    const ProcessResult made =
        RunProcess({"make", "-C", folder_.File(name), "install"},
                   {{{"PKG_CONFIG_PATH", prefix_->File("share/pkgconfig")}, {"MAKEFLAGS", ""}},
                    "",
                    true,
                    true});
    ASSERT_TRUE(made.good()) << made.output;
  }
  EXPECT_EQ(Say("MS"), kHeard);
}

TEST_F(PackageTest, AnInstalledProgramBuildsFolders) {
  const ProcessResult result =
      RunProcess({prefix_->File("bin/openr"), "build", folder_.File("")}, {{}, "", true, true});
  ASSERT_TRUE(result.good()) << result.output;
  EXPECT_EQ(Say("MS"), kHeard);
}

TEST_F(PackageTest, AnInstalledProgramHasProcessesForObjects) {
  const ProcessResult result =
      RunProcess({prefix_->File("bin/openr"), "build", folder_.File("")}, {{}, "", true, true});
  ASSERT_TRUE(result.good()) << result.output;
  EXPECT_EQ(Say("MS", {"--isolate", "sender", "--isolate", "receiver"}), kHeard);
}

}  // namespace
}  // namespace openr_host
