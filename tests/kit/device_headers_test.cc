// The headers of controllers: C of 1989 and C++ of 1998, each alone and twice.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

TEST(DeviceHeadersTest, EachCompilesAloneInOldCAndOldCxxWithoutAWarning) {
  namespace fs = std::filesystem;
  const KitFolder folder("");
  const std::string include = OPENR_BUILD "/share/openr-host/sdk/controller/include";
  int count = 0;
  for (const auto& entry : fs::directory_iterator(include + "/device")) {
    const std::string name = entry.path().filename();
    const std::string lines = "#include <device/" + name + ">\n#include <" + name + ">\n";
    folder.Write("one.c", lines);
    folder.Write("one.cc", lines);
    const std::string flags = " -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I" + include +
                              " -I" + include + "/device ";
    EXPECT_EQ(std::system(("gcc -std=c89" + flags + folder.File("one.c")).c_str()), 0) << name;
    EXPECT_EQ(std::system(("g++ -std=c++98" + flags + folder.File("one.cc")).c_str()), 0) << name;
    ++count;
  }
  EXPECT_GE(count, 9);
}

}  // namespace
}  // namespace openr_host
