// A program of tests/kit/fixtures in a folder of the test's own, built and run by the built openr.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/openr/program_run.h"

namespace openr_host {

class KitFolder {
 public:
  // Copies fixture `name`; "" makes an empty folder.
  explicit KitFolder(const std::string& name) {
    namespace fs = std::filesystem;
    if (!name.empty()) {
      fs::copy(std::string(OPENR_KIT_FIXTURES) + "/" + name, File(""),
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    }
    fs::create_directories(File(""));
    setenv("XDG_CACHE_HOME", scratch_.File("cache").c_str(), 1);
  }

  // Where `name` of the program is.
  std::string File(const std::string& name) const {
    return scratch_.File(name.empty() ? "program" : "program/" + name);
  }
  void Write(const std::string& name, const std::string& text) const {
    scratch_.Write("program/" + name, text);
  }
  std::string Read(const std::string& name) const { return scratch_.Read("program/" + name); }

  ProgramResult Build(std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"build", File("")});
    return RunProgram(flags);
  }

  // What the objects of `stick` said in a second of virtual time; "" when they could not run.
  std::string Say(const std::string& stick = "MS", std::vector<std::string> flags = {}) const {
    return SayOf(File(stick), std::move(flags));
  }
  static std::string SayOf(const std::string& stick, std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(),
                 {"run", "--stick", stick, "--for", "1s", "--rate", "max", "--no-panel"});
    const ProgramResult result = RunProgram(flags);
    if (result.status != 0) return "status " + std::to_string(result.status) + ": " + result.err;
    return WordsOfObjects(result.err);
  }

  // Of what a run said: neither what the system says at boot nor the summary at the end.
  static std::string WordsOfObjects(const std::string& said) {
    std::istringstream lines(said.substr(0, said.find("1.000 s of virtual time")));
    std::string words;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("[oid:0x") && !line.starts_with("[RobotDesign")) words += line + "\n";
    }
    return words;
  }

  // Names of all files, sorted.
  std::vector<std::string> Files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(File(""))) {
      if (entry.is_regular_file())
        names.push_back(entry.path().lexically_relative(File("")).string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  const ScratchFolder& scratch() const { return scratch_; }

 private:
  const ScratchFolder scratch_;
};

}  // namespace openr_host
