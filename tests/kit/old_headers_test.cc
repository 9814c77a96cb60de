// Headers of C++ before the standard, through the compiler that Makefiles find.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cli/process.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

ProcessResult Compile(const std::string& source) {
  const std::string compiler =
      std::string(OPENR_BUILD) + "/share/openr-host/sdk/bin/mipsel-linux-g++";
  return RunProcess({compiler, "-Wall", "-c", source, "-o", source + ".o"}, {{}, "", true, true});
}

TEST(OldHeadersTest, AllOfThemGoTogetherInAnyOrderAndWithTheSdks) {
  std::vector<std::string> lines;
  const std::string folder = std::string(OPENR_BUILD) + "/share/openr-host/sdk/compat";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    lines.push_back("#include <" + entry.path().filename().string() + ">\n");
  std::sort(lines.begin(), lines.end());
  ASSERT_GT(lines.size(), 30u);
  const ScratchFolder scratch;
  for (const char* name : {"forwards.cc", "backwards.cc"}) {
    std::string text;
    for (const std::string& line : lines) text += line;
    scratch.Write(name, text + "#include <OPENR/OObject.h>\n#include <ant.h>\n");
    const ProcessResult result = Compile(scratch.File(name));
    EXPECT_TRUE(result.good()) << result.output;
    EXPECT_EQ(result.output, "");
    std::reverse(lines.begin(), lines.end());
  }
}

TEST(OldHeadersTest, NamesNeedNoNamespace) {
  const ScratchFolder scratch;
  scratch.Write(
      "a.cc",
      "#include <iostream.h>\n#include <fstream.h>\n#include <list.h>\n#include <map.h>\n"
      "#include <set.h>\n#include <stack.h>\n#include <hash_map.h>\n#include <pair.h>\n"
      "void f() {\n"
      "  ifstream in(\"x\"); ofstream out(\"y\"); int n; in >> n >> ws; out << n << endl;\n"
      "  list<int> l; map<int, int> m; set<int> s; stack<int> t; hash_map<int, int> h;\n"
      "  pair<int, int> p = make_pair(1, 2); cerr << p.first << hex << flush;\n"
      "  ios::openmode mode = ios::in | ios::binary; (void)mode;\n"
      "}\n");
  const ProcessResult result = Compile(scratch.File("a.cc"));
  EXPECT_TRUE(result.good()) << result.output;
}

// <string> brought strlen() along, <iostream> exit().
TEST(OldHeadersTest, HeadersNobodyIncludedAreThere) {
  const ScratchFolder scratch;
  scratch.Write("a.cc",
                "#include <string>\nint f(const char* s) { if (!s) exit(1); return strlen(s); }\n");
  const ProcessResult result = Compile(scratch.File("a.cc"));
  EXPECT_TRUE(result.good()) << result.output;
}

TEST(OldHeadersTest, TheRobotsWordsAreOfItsWidth) {
  const ScratchFolder scratch;
  scratch.Write(
      "a.cc",
      "#include <OPENR/OObject.h>\n"
      "char a[sizeof(longword) == 4 && sizeof(int32) == 4 && sizeof(word) == 2 ? 1 : -1];\n"
      "double pi = M_PI;\nchar* b(char* line) { return gets(line); }\n"
      "int c = stricmp(\"a\", \"A\") + strnicmp(\"ab\", \"AC\", 1);\n");
  const ProcessResult result = Compile(scratch.File("a.cc"));
  EXPECT_TRUE(result.good()) << result.output;
}

}  // namespace
}  // namespace openr_host
