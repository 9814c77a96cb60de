// The script that assembles the SDK tree of a build folder.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/process.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

class SdkTreeTest : public testing::Test {
 protected:
  SdkTreeTest() {
    for (const char* const file :
         {"source/runtime/include/OPENR/OSubject.h", "source/runtime/include/ant.h",
          "source/runtime/compat/vector.h", "source/objects/Controller/include/device/led.h",
          "source/objects/Controller/Controller.ocf", "source/kit/controller/Makefile.openr",
          "source/cmake/compile-flags.txt", "images/POWERMON.BIN", "controller.o"})
      folder_.Write(file, file);
  }

  void Make() const {
    const ProcessResult made = RunProcess(
        {"cmake", "-DSDK=" + folder_.File("sdk"), "-DSOURCE=" + folder_.File("source"),
         "-DIMAGES=" + folder_.File("images"), "-DCONTROLLER=" + folder_.File("controller.o"), "-P",
         OPENR_DOCS "/../cmake/MakeSdkTree.cmake"},
        {{}, "", true, true});
    ASSERT_TRUE(made.good()) << made.output;
  }

  bool Has(const std::string& file) const { return fs::exists(folder_.File("sdk/" + file)); }

  const ScratchFolder folder_;
};

TEST_F(SdkTreeTest, AHeaderThatIsGoneFromTheSourceIsRemoved) {
  Make();
  for (const char* const file :
       {"OPEN_R/include/OPENR/OSubject.h", "OPEN_R/include/ant.h", "OPEN_R/include/R4000/ant.h",
        "compat/vector.h", "controller/include/device/led.h", "controller/controller.o"})
    EXPECT_TRUE(Has(file)) << file;
  for (const char* const file : {"runtime/include/ant.h", "runtime/compat/vector.h",
                                 "objects/Controller/include/device/led.h"})
    fs::remove(folder_.File(std::string("source/") + file));
  folder_.Write("source/runtime/include/Types.h", "new");
  Make();
  for (const char* const file :
       {"OPEN_R/include/ant.h", "compat/vector.h", "controller/include/device/led.h"})
    EXPECT_FALSE(Has(file)) << file;
  for (const char* const file : {"OPEN_R/include/OPENR/OSubject.h", "OPEN_R/include/Types.h",
                                 "OPEN_R/include/MCOOP/Types.h", "controller/Controller.ocf"})
    EXPECT_TRUE(Has(file)) << file;
}

}  // namespace
}  // namespace openr_host
