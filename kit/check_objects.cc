#include "kit/check_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <regex>

#include "kit/check_calls.h"
#include "kit/source_place.h"
#include "kit/source_text.h"
#include "kit/text_files.h"
#include "runtime/config/line_file.h"
#include "runtime/config/ocf.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The smallest stack in an .ocf file that gets no warning.  The SDK's samples have 3072 bytes, and
// no program with less than 1024 is known to work.
constexpr int64_t kStackBytesMin = 1024;
// The largest step by which a heap may grow without a warning.  The limit is half of the robot's
// memory of 32 MB, because a second step of this size would not fit.
constexpr int64_t kHeapBytesMax = 16 << 20;

// Returns the text of all `files` in one string, without comments.
std::string CodeIn(const std::vector<fs::path>& files, const ObjectParts& parts) {
  std::string code;
  for (const fs::path& file : files) code += WithoutComments(parts.TextOf(file)) + "\n";
  return code;
}

bool HasAnyWord(const std::string& code, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return HasWord(code, word); });
}

class ObjectCheck {
 public:
  ObjectCheck(const ObjectFolder& object, const ObjectParts& parts, Remarks* remarks)
      : object_(object),
        parts_(parts),
        remarks_(remarks),
        files_(parts.CodeOf(object)),
        code_(CodeIn(files_, parts)) {}

  void Run() {
    if (!object_.stub.empty()) CheckStub();
    if (!parts_.IsForRemoteProcessing(object_)) CheckCalls(CompiledSources(), code_, remarks_);
    for (const fs::path& file : object_.sources) {
      const std::string text = ReadText(file).value_or("");
      CheckStickPaths(file, text, remarks_);
      if (!parts_.IsForRemoteProcessing(object_)) CheckThreads(file, text);
    }
    CheckOcfs();
  }

 private:
  void CheckStub() {
    const StubConfigResult stub =
        ParseStubConfig(object_.stub, ReadText(object_.stub).value_or(""));
    remarks_->AddAll(stub.diagnostics);
    if (HasErrors(stub.diagnostics)) return;
    const std::string header = LowerCase(stub.config.object_name + ".h");
    const bool has_header = std::any_of(files_.begin(), files_.end(), [&](const fs::path& file) {
      return LowerCase(file.filename()) == header;
    });
    if (!has_header) {
      remarks_->Add(Remark::Kind::kError, stub.config.object_name_place,
                    fmt::format("the stub includes \"{0}.h\", which is neither beside stub.cfg nor "
                                "where a Makefile leads; write the class {0} there",
                                stub.config.object_name));
    }
    CheckFunctions(stub.config);
    CheckRegistration(stub.config);
    const std::vector<SourceOfObject> sources = CompiledSources();
    const std::string code = code_ + OtherDefinitions();
    CheckServiceIndices(stub.config, sources, code, remarks_);
    CheckExtraEntries(stub.config, sources, code, remarks_);
  }

  // Returns the sources in the object's folder that are compiled.  If Makefiles name some of the
  // sources, leaves out the other sources, because they may be old copies that nobody compiles.
  std::vector<SourceOfObject> CompiledSources() const {
    const auto is_named = [&](const fs::path& file) {
      return parts_.MakefilesName(file.filename()) ||
             parts_.MakefilesName(file.stem().string() + ".o");
    };
    const bool has_list = std::any_of(object_.sources.begin(), object_.sources.end(), is_named);
    std::vector<SourceOfObject> sources;
    for (const fs::path& file : object_.sources)
      if (!has_list || is_named(file)) sources.push_back({file, parts_.TextOf(file)});
    return sources;
  }

  // Returns the text of definitions of sbjX, obsX or entryX that do not come from stub.cfg.  These
  // are the def.h and entry.h that somebody wrote by hand, and a definition for each service in
  // another .cfg file of the folder, because a Makefile may make the stub from such a file.
  std::string OtherDefinitions() const {
    static const std::regex kService(
        "Service[ \t]*:[ \t]*\"[ \t]*\\w+\\.(\\w+)\\.[^\"]*\\.([SO])\"");
    std::string text;
    for (const fs::path& file : FilesBelow(object_.folder)) {
      const std::string name = file.filename();
      if (name == "def.h" && !IsGeneratedDefinitions(parts_.TextOf(file)))
        text += WithoutComments(parts_.TextOf(file)) + "\n";
      if (name == "entry.h" && !HasWord(parts_.TextOf(file), "Extra_Entry"))
        text += WithoutComments(parts_.TextOf(file)) + "\n";
      if (LowerCase(file.extension()) != ".cfg" || file == object_.stub) continue;
      const std::string& config = parts_.TextOf(file);
      for (std::sregex_iterator it(config.begin(), config.end(), kService), end; it != end; ++it)
        text +=
            fmt::format("const int {}{} = 0;\n", (*it)[2] == "S" ? "sbj" : "obs", (*it)[1].str());
    }
    return text;
  }

  void CheckFunction(const std::string& function, const FilePosition& place, const char* event) {
    if (function.empty() || HasWord(code_, function)) return;
    remarks_->Add(Remark::Kind::kError, place,
                  fmt::format("no {}() in the sources of {}; declare: void {}({})", function,
                              object_.folder.filename().string(), function, event));
  }

  void CheckFunctions(const StubConfig& config) {
    for (const StubService& service : config.subjects) {
      CheckFunction(service.connect_function, service.place, "const OControlEvent&");
      CheckFunction(service.data_function, service.place, "const OReadyEvent&");
    }
    for (const StubService& service : config.observers) {
      CheckFunction(service.connect_function, service.place, "const OConnectEvent&");
      CheckFunction(service.data_function, service.place, "const ONotifyEvent&");
    }
    for (const StubExtra& extra : config.extras)
      CheckFunction(extra.function, extra.place, "void*");
  }

  // Finds calls that an object must make in DoInit and DoStart but that are not in its sources.
  // The program compiles without these calls, so the compiler does not find this mistake.
  void CheckRegistration(const StubConfig& config) {
    const auto real = [](const StubService& service) { return !IsDummy(service); };
    const auto first = std::find_if(config.subjects.begin(), config.subjects.end(), real);
    const auto heard = std::find_if(config.observers.begin(), config.observers.end(), real);
    const StubService* const service = first != config.subjects.end()    ? &*first
                                       : heard != config.observers.end() ? &*heard
                                                                         : nullptr;
    if (service == nullptr) return;
    // Accepts, in place of the SDK's macros that register entries, subjects and observers, also the
    // functions that these macros call.  A program may call these functions itself, or make its
    // subjects and observers with `new`.
    if (!HasAnyWord(code_, {"REGISTER_ALL_ENTRY", "SetComData", "RegisterServiceEntry"})) {
      remarks_->Add(Remark::Kind::kWarning, service->place,
                    "no REGISTER_ALL_ENTRY in DoInit: nothing can be connected to this object, the "
                    "robot says NOT FOUND");
    } else if (!HasAnyWord(code_, {"NEW_ALL_SUBJECT_AND_OBSERVER", "NewComData", "OSubject",
                                   "OObserver"}) ||
               !HasAnyWord(code_, {"NEW_ALL_SUBJECT_AND_OBSERVER", "NewComData", "new"})) {
      remarks_->Add(Remark::Kind::kWarning, service->place,
                    "no NEW_ALL_SUBJECT_AND_OBSERVER in DoInit: subject[] and observer[] point "
                    "nowhere");
    }
    if (heard != config.observers.end() && !heard->data_function.empty() &&
        !HasAnyWord(code_,
                    {"ASSERT_READY_TO_ALL_OBSERVER", "ASSERT_TO_ALL_OBSERVER", "AssertReady"})) {
      remarks_->Add(Remark::Kind::kWarning, heard->place,
                    fmt::format("AssertReady is never called: {}() will not be either",
                                heard->data_function));
    }
  }

  void CheckThreads(const fs::path& file, const std::string& text) {
    // Leaves out std::thread::, because names such as std::thread::id start no thread.
    static const std::regex kThread(
        "\\b(pthread_create|thrd_create)[ \t]*\\(|\\b(std[ \t]*::[ \t]*(thread|async))\\b(?![ "
        "\t]*::)");
    const std::string code = WithoutConditionalCode(WithoutComments(text));
    for (std::sregex_iterator it(code.begin(), code.end(), kThread), end; it != end; ++it) {
      const std::string name = (*it)[1].matched ? (*it)[1].str() : "std::" + (*it)[3].str();
      remarks_->Add(Remark::Kind::kWarning,
                    PlaceAt(file, text, static_cast<size_t>(it->position(0))),
                    fmt::format("{}(): the robot has no threads: an object is one, and does one "
                                "thing at a time; do a piece of the work for each message",
                                name));
    }
  }

  void CheckOcfs() {
    const std::vector<fs::path> ocfs = parts_.OcfsOf(object_);
    if (ocfs.empty() && parts_.IsForRemoteProcessing(object_)) {
      remarks_->Note(object_.folder,
                     "is for the PC side of Remote Processing, which is not built here");
    } else if (ocfs.empty()) {
      remarks_->Error(object_.folder,
                      "no .ocf file; write one line: object NAME 3072 16384 128 cache tlb user");
    }
    for (const fs::path& file : ocfs) {
      const OcfResult ocf = ParseOcf(file, ReadText(file).value_or(""));
      remarks_->AddAll(ocf.diagnostics);
      if (!ocf.ocf) continue;
      if (ocf.ocf->stack_bytes < kStackBytesMin) {
        remarks_->Add(
            Remark::Kind::kWarning, ocf.ocf->place,
            fmt::format("a stack of {} bytes; 3072 is usual, and too little is not noticed "
                        "but by what it destroys",
                        ocf.ocf->stack_bytes));
      }
      if (ocf.ocf->heap_bytes > kHeapBytesMax) {
        remarks_->Add(
            Remark::Kind::kWarning, ocf.ocf->place,
            fmt::format("the heap grows by {} bytes at a time, the robot has 32 MB in all",
                        ocf.ocf->heap_bytes));
      }
    }
  }

  const ObjectFolder& object_;
  const ObjectParts& parts_;
  Remarks* const remarks_;
  const std::vector<fs::path> files_;
  const std::string code_;
};

// Warns if an object of the program commands joints and no object does what joints need before they
// move, such as switching motor power on.
void CheckMotors(const Project& project, const ObjectParts& parts, Remarks* remarks) {
  std::string code;
  const ObjectFolder* mover = nullptr;
  for (const auto* objects : {&project.objects, &project.neighbours}) {
    for (const ObjectFolder& object : *objects) {
      const std::string own = CodeIn(parts.CodeOf(object), parts);
      const bool moves = HasAnyWord(own, {"odataJOINT_COMMAND2", "OJointCommandValue2"});
      if (moves && objects == &project.objects) mover = &object;
      code += own;
    }
  }
  code += CodeIn(project.shared_sources, parts);
  if (mover == nullptr) return;
  const std::string file = mover->folder;
  if (!HasWord(code, "SetMotorPower"))
    remarks->Warning(
        file, "commands joints, but no object calls SetMotorPower(opowerON): they stay limp");
  if (!HasAnyWord(code, {"EnableJointGain", "SetDefaultJointGain"}))
    remarks->Warning(file,
                     "commands joints, but no object calls EnableJointGain(): they stay limp");
}

}  // namespace

bool IsDummy(const StubService& service) {
  const std::string data = LowerCase(service.name.data);
  return data == "donotconnect" || data == "dontconnect" || data == "notconnect";
}

void CheckStickPaths(const std::string& file, const std::string& text, Remarks* remarks) {
  // Leaves out strings with '%' or a backslash, because such a string is a format or has an escape,
  // so its text is not the name of a file.
  static const std::regex kPath("\"(/[mM][sS]/[^\"%\\\\]*)\"");
  std::vector<Diagnostic> ignored;
  for (const FilePosition& line : SplitLines(file, text, &ignored)) {
    std::smatch match;
    if (!std::regex_search(line.text, match, kPath)) continue;
    for (const fs::path& part : fs::path(match[1].str())) {
      const std::string name = part;
      if (name == "/" || name.empty() || IsShortName(name)) continue;
      remarks->AddConsequence(
          Remark::Kind::kWarning, line, "not 8.3: " + name,
          fmt::format("'{}' is not an 8.3 name; the robot cannot open it", name));
    }
  }
}

void CheckObjects(const Project& project, const ObjectParts& parts, Remarks* remarks) {
  for (const ObjectFolder& object : project.objects) ObjectCheck(object, parts, remarks).Run();
  if (project.sticks.empty()) {
    std::vector<PlacedObject> all;
    for (const ObjectFolder& object : project.objects) all.push_back({&object, ""});
    CheckObjectNames(all, parts, remarks);
  }
  CheckMotors(project, parts, remarks);
}

void CheckObjectNames(const std::vector<PlacedObject>& placed, const ObjectParts& parts,
                      Remarks* remarks) {
  struct NamedObject {
    const PlacedObject* object;
    Ocf ocf;
  };
  std::vector<NamedObject> seen;
  for (const PlacedObject& object : placed) {
    std::vector<NamedObject> own;
    for (const fs::path& file : parts.OcfsOf(*object.folder)) {
      const OcfResult ocf = ParseOcf(file, ReadText(file).value_or(""));
      if (ocf.ocf) own.push_back({&object, *ocf.ocf});
    }
    for (const NamedObject& mine : own) {
      const auto first = std::find_if(seen.begin(), seen.end(), [&](const NamedObject& other) {
        return other.ocf.name == mine.ocf.name && other.object->folder != object.folder &&
               MayBothApply(other.object->section, object.section);
      });
      if (first == seen.end()) continue;
      remarks->Add(
          Remark::Kind::kWarning, mine.ocf.place,
          fmt::format("an object is named '{}' in {} already; on one stick names must differ",
                      mine.ocf.name, first->ocf.place.file));
    }
    seen.insert(seen.end(), own.begin(), own.end());
  }
}

}  // namespace openr_host
