// A program of tests/kit/fixtures in a folder of the test's own, built and run by the built openr.
#pragma once

#include <ctype.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/openr/program_run.h"

namespace openr_host {

// Sets a variable for the programs that a test starts, as a user may do.
class NamedVariable {
 public:
  NamedVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* const before = getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~NamedVariable() {
    if (before_.empty()) {
      unsetenv(name_);
    } else {
      setenv(name_, before_.c_str(), 1);
    }
  }
  NamedVariable(const NamedVariable&) = delete;
  NamedVariable& operator=(const NamedVariable&) = delete;

 private:
  const char* const name_;
  std::string before_;
};

// Names the host's compiler.
struct NamedCompiler : NamedVariable {
  explicit NamedCompiler(const char* name) : NamedVariable("OPENR_HOST_CXX", name) {}
};

class KitFolder {
 public:
  // Copies fixture `name`; "" makes an empty folder.
  explicit KitFolder(const std::string& name) : scratch_(Place()) {
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

  // A statement that prints a line.
  static std::string Printing(const std::string& words) {
    return "    OSYSPRINT((\"" + words + "\\n\"));";
  }

  // Writes an object to `folder`: class header, source, stub.cfg and .ocf file, as they were
  // written for the robot.  `head` stands before the class's functions, `start` is what DoStart()
  // does.
  void AddObject(const std::string& folder, const std::string& name, const std::string& head,
                 const std::string& start) const {
    Write(folder + "/stub.cfg", "ObjectName : " + name +
                                    "\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
                                    "Service : \"" +
                                    name +
                                    ".DummySubject.DoNotConnect.S\", null, null\n"
                                    "Service : \"" +
                                    name + ".DummyObserver.DoNotConnect.O\", null, null\n");
    Write(folder + "/" + name + ".ocf", "object " + name + " 3072 16384 128 cache tlb user\n");
    Write(
        folder + "/" + name + ".h",
        "#include <OPENR/OObject.h>\n#include <OPENR/OSubject.h>\n#include <OPENR/OObserver.h>\n"
        "#include \"def.h\"\n\nclass " +
            name +
            " : public OObject {\npublic:\n"
            "    OSubject*  subject[numOfSubject];\n    OObserver* observer[numOfObserver];\n\n"
            "    virtual OStatus DoInit(const OSystemEvent& event);\n"
            "    virtual OStatus DoStart(const OSystemEvent& event);\n"
            "    virtual OStatus DoStop(const OSystemEvent& event) { return oSUCCESS; }\n"
            "    virtual OStatus DoDestroy(const OSystemEvent& event) { return oSUCCESS; }\n};\n");
    Write(folder + "/" + name + ".cc",
          "#include <OPENR/OSyslog.h>\n#include <OPENR/core_macro.h>\n#include \"" + name +
              ".h\"\n" + head + "\nOStatus\n" + name +
              "::DoInit(const OSystemEvent& event)\n{\n"
              "    NEW_ALL_SUBJECT_AND_OBSERVER;\n    REGISTER_ALL_ENTRY;\n"
              "    SET_ALL_READY_AND_NOTIFY_ENTRY;\n    return oSUCCESS;\n}\n\nOStatus\n" +
              name + "::DoStart(const OSystemEvent& event)\n{\n" + start +
              "\n    return oSUCCESS;\n}\n");
  }

  // A Makefile for such an object.  `more`: lines before its rules, which set DEFS, LIBS or
  // INSTALL.
  void AddMakefile(const std::string& folder, const std::string& name, const std::string& more = "",
                   const std::string& objects = "") const {
    std::string image = name;
    for (char& c : image) c = static_cast<char>(toupper(c));
    Write(folder + "/Makefile",
          "PREFIX=/usr/local/OPEN_R_SDK\nINSTALLDIR=../MS\nINSTALL=" + image + ".BIN\n" + more +
              "\nCXX=$(PREFIX)/bin/mipsel-linux-g++\nMKBIN=$(PREFIX)/OPEN_R/bin/mkbin\n"
              "STUBGEN=$(PREFIX)/OPEN_R/bin/stubgen2\n"
              "CXXFLAGS=-O2 -g -I. $(DEFS) -I$(PREFIX)/OPEN_R/include/R4000 "
              "-I$(PREFIX)/OPEN_R/include/MCOOP -I$(PREFIX)/OPEN_R/include\n\n"
              ".PHONY: all install clean\nall: " +
              name +
              ".bin\n\n"
              "%.o: %.cc\n\t$(CXX) $(CXXFLAGS) -o $@ -c $<\n\n" +
              name + "Stub.cc: stub.cfg\n\t$(STUBGEN) stub.cfg\n\n" + name + ".bin: " + name +
              "Stub.o " + name + ".o " + objects + " " + name +
              ".ocf\n"
              "\t$(MKBIN) -p $(PREFIX) -o $@ $^ $(LIBS) -lObjectComm -lOPENR\n\n"
              "install: " +
              name +
              ".bin\n"
              "\tgzip -c " +
              name +
              ".bin > $(INSTALLDIR)/OPEN-R/MW/OBJS/$(INSTALL)\n\n"
              "clean:\n\trm -f *.o *.bin *Stub.* def.h entry.h\n");
  }

  // A stick whose OBJECT.CFG names `images`, with no connections.
  void AddStick(const std::string& folder, const std::vector<std::string>& images) const {
    std::string lines;
    for (const std::string& image : images) lines += "/MS/OPEN-R/MW/OBJS/" + image + "\n";
    Write(folder + "/OPEN-R/MW/CONF/OBJECT.CFG", lines);
    Write(folder + "/OPEN-R/MW/CONF/CONNECT.CFG", "");
  }

  ProgramResult Build(std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"build", File("")});
    return RunProgram(flags);
  }

  // Returns what the objects of `stick` print in a second of virtual time; "" if they cannot run.
  std::string Say(const std::string& stick = "MS", std::vector<std::string> flags = {}) const {
    return SayOf(File(stick), std::move(flags));
  }
  static std::string SayOf(const std::string& stick, std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {"run", "--stick", stick, "--for", "1s", "--rate", "max",
                                 "--no-panel", "--rc-port", "0"});
    const ProgramResult result = RunProgram(flags);
    if (result.status != 0) return "status " + std::to_string(result.status) + ": " + result.err;
    return WordsOfObjects(result.err);
  }

  // Returns the part of `said`, the output of a run, that objects have printed.
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
  // Returns the place of the folder: the same in every run of tools/run_tests.py, because ccache
  // compiles again what is in a folder of another name.  Returns "" without tools/run_tests.py.
  static std::filesystem::path Place() {
    const char* const scratch = getenv("OPENR_TEST_SCRATCH");
    if (scratch == nullptr) return {};
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        test == nullptr ? "shared" : std::string(test->test_suite_name()) + "." + test->name();
    std::replace(name.begin(), name.end(), '/', '_');
    static int count = 0;
    static std::string last;
    count = name == last ? count + 1 : 0;
    last = name;
    return std::filesystem::path(scratch) / (name + "." + std::to_string(count));
  }

  const ScratchFolder scratch_;
};

}  // namespace openr_host
