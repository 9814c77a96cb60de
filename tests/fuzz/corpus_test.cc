// Replays the corpora of all fuzz targets, without libFuzzer: the seeds, and the inputs that once
// crashed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz_targets.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

std::string BytesOfSeed(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

nlohmann::json DescribedTargets() {
  return nlohmann::json::parse(BytesOfSeed(fs::path(OPENR_FUZZ_FOLDER) / "targets.json"));
}

// Returns the files of the repository that `pattern` names; '*' is any name of a file or folder,
// or a part of it.
std::vector<fs::path> FilesNamed(const std::string& pattern) {
  std::vector<fs::path> found{OPENR_SOURCE_DIR};
  for (const fs::path& part : fs::path(pattern)) {
    const std::string name = part.string();
    const size_t star = name.find('*');
    std::vector<fs::path> next;
    for (const fs::path& folder : found) {
      if (star == std::string::npos) {
        if (fs::exists(folder / part)) next.push_back(folder / part);
        continue;
      }
      if (!fs::is_directory(folder)) continue;
      for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string other = entry.path().filename().string();
        if (other.starts_with(name.substr(0, star)) && other.ends_with(name.substr(star + 1))) {
          next.push_back(entry.path());
        }
      }
    }
    found = next;
  }
  return found;
}

std::vector<fs::path> SeedsOf(const std::string& name, const nlohmann::json& described) {
  std::vector<fs::path> seeds;
  for (const std::string pattern : described.at("seeds")) {
    const std::vector<fs::path> files = FilesNamed(pattern);
    EXPECT_FALSE(files.empty()) << "no file is " << pattern;
    seeds.insert(seeds.end(), files.begin(), files.end());
  }
  const fs::path own = fs::path(OPENR_FUZZ_FOLDER) / "corpus" / name;
  if (fs::exists(own)) {
    for (const auto& entry : fs::directory_iterator(own)) seeds.push_back(entry.path());
  }
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

class CorpusTest : public testing::TestWithParam<std::string> {};

TEST_P(CorpusTest, SeedsAndFormerCrashesAreRead) {
  const FuzzTarget* const target = FindFuzzTarget(GetParam());
  ASSERT_NE(target, nullptr);
  const std::vector<fs::path> seeds = SeedsOf(GetParam(), DescribedTargets().at(GetParam()));
  EXPECT_FALSE(seeds.empty());
  for (const fs::path& seed : seeds) {
    SCOPED_TRACE(seed.string());
    EXPECT_FALSE(target->run(BytesOfSeed(seed))) << "the planted bug is found without a search";
  }
  EXPECT_FALSE(target->run(""));
}

std::vector<std::string> AllNames() {
  std::vector<std::string> names;
  for (const FuzzTarget& target : FuzzTargets()) names.push_back(target.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, CorpusTest, testing::ValuesIn(AllNames()),
                         [](const auto& test) { return test.param; });

// fuzz.py takes no notice of a misspelt key.
TEST(FuzzTargetsTest, DescriptionsHaveOnlyKeysThatTheScriptReads) {
  const std::set<std::string> known = {"reads", "seeds", "words", "numbers", "max_bytes", "counts"};
  const nlohmann::json targets = DescribedTargets();
  for (const auto& [name, target] : targets.items()) {
    for (const auto& [key, value] : target.items()) {
      EXPECT_TRUE(known.contains(key)) << name << ": " << key;
    }
  }
}

TEST(FuzzTargetsTest, EachTargetIsDescribedAndHasAFolderOfItsOwnName) {
  std::set<std::string> described, known;
  const nlohmann::json targets = DescribedTargets();
  for (const auto& [name, target] : targets.items()) described.insert(name);
  for (const std::string& name : AllNames()) {
    known.insert(name);
    EXPECT_TRUE(fs::exists(fs::path(OPENR_FUZZ_FOLDER) / "targets" / (name + ".cc"))) << name;
  }
  EXPECT_EQ(described, known);
  for (const auto& entry : fs::directory_iterator(fs::path(OPENR_FUZZ_FOLDER) / "corpus")) {
    EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path();
  }
  EXPECT_EQ(FindFuzzTarget("no_such_target"), nullptr);
}

}  // namespace
}  // namespace openr_host
