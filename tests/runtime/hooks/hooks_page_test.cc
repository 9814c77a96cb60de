// Tests that docs/hooks.md names every function of the C library that the runtime defines.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <stdio.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Returns the file of the runtime, a shared object.
std::string RuntimeFile() {
  Dl_info info{};
  return dladdr(dlsym(RTLD_DEFAULT, "openr_finding"), &info) == 0 ? "" : info.dli_fname;
}

// Returns the names of the functions that the shared object `file` exports.
std::vector<std::string> FunctionsOf(const std::string& file) {
  std::vector<std::string> names;
  const std::unique_ptr<FILE, int (*)(FILE*)> list(
      popen(("nm -D --defined-only '" + file + "'").c_str(), "r"), &pclose);
  char address[64], kind[8], name[512];
  while (fscanf(list.get(), "%63s %7s %511s", address, kind, name) == 3) {
    const std::string text = name;
    if (kind[0] == 'T' || kind[0] == 'W') names.push_back(text.substr(0, text.find('@')));
  }
  return names;
}

TEST(HooksPageTest, NamesEveryFunctionOfTheCLibraryThatIsDefinedHere) {
  const std::string page_file = std::string(OPENR_DOCS) + "/hooks.md";
  std::ifstream stream(page_file);
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  ASSERT_NE(page, "") << page_file;
  void* const c_library = dlopen("libc.so.6", RTLD_NOW | RTLD_NOLOAD);
  ASSERT_NE(c_library, nullptr);
  int count = 0;
  for (const std::string& name : FunctionsOf(RuntimeFile())) {
    if (dlsym(c_library, name.c_str()) == nullptr) continue;
    ++count;
    EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << name;
  }
  EXPECT_GT(count, 80);
  dlclose(c_library);
}

}  // namespace
}  // namespace openr_host
