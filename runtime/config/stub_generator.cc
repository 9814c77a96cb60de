#include "runtime/config/stub_generator.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr const char* kHooks[] = {"Init", "Start", "Stop", "Destroy"};
constexpr int kHookCount = static_cast<int>(std::size(kHooks));

// An entry of an object, for one row of the table of entries in the generated stub.  The index of
// the row is the selector of the entry.
struct EntryPoint {
  std::string name;        // "Ready0" for the C function _Ready0
  std::string definition;  // source text that defines the function
};

void Append(std::string* text, const std::string& line) {
  *text += line;
  *text += '\n';
}

std::string Opening(const std::string& source, const char* purpose) {
  return fmt::format("// {}\n// Made from {} by openr stubgen: edit that file, not this one.\n",
                     purpose, source);
}

std::string Guarded(const std::string& opening, const char* guard, const std::string& body) {
  return fmt::format("{0}#ifndef {1}\n#define {1}\n\n{2}\n#endif // {1}\n", opening, guard, body);
}

// ---- Generates def.h, which numbers the services

void AppendServiceNames(const char* array, const char* count,
                        const std::vector<StubService>& services, std::string* text) {
  Append(text, fmt::format("const char* const {}[{}] = {{", array, count));
  for (const StubService& service : services) {
    Append(text, fmt::format("    \"{}\",", Compose(service.name)));
  }
  text->erase(text->size() - 2, 1);  // removes the comma behind the last name
  Append(text, "};");
}

void AppendIndices(const char* prefix, const std::vector<StubService>& services,
                   std::string* text) {
  for (size_t i = 0; i < services.size(); ++i) {
    Append(text, fmt::format("const int {}{} = {};", prefix, services[i].name.short_name, i));
  }
}

std::string MakeDefHeader(const StubConfig& config, const std::string& source) {
  std::string body;
  Append(&body, fmt::format("const char* const objectName = \"{}\";", config.object_name));
  Append(&body, fmt::format("\nconst int numOfSubject = {};", config.subjects.size()));
  Append(&body, fmt::format("const int numOfObserver = {};\n", config.observers.size()));
  AppendServiceNames("subjectService", "numOfSubject", config.subjects, &body);
  AppendServiceNames("observerService", "numOfObserver", config.observers, &body);
  Append(&body, "");
  AppendIndices("sbj", config.subjects, &body);
  AppendIndices("obs", config.observers, &body);
  return Guarded(Opening(source, "Services of the object, and their indices."), "_def_h_DEFINED",
                 body);
}

// ---- Generates entry.h, which has the selectors of the entries

// Returns a list such as "{ 4, 5, 6 }": `count` numbers from `first` on.
std::string NumberList(int first, size_t count) {
  std::string list = "{";
  for (size_t i = 0; i < count; ++i) {
    list += fmt::format("{} {}", i == 0 ? "" : ",", first + static_cast<int>(i));
  }
  return list + " }";
}

std::string MakeEntryHeader(const StubConfig& config, const std::string& source) {
  const size_t subject_count = config.subjects.size();
  const size_t observer_count = config.observers.size();
  int next = 0;
  const auto selectors = [&next](const char* array, const char* size, size_t count) {
    const std::string line =
        fmt::format("const Selector {}[{}] = {};\n", array, size, NumberList(next, count));
    next += static_cast<int>(count);
    return line;
  };
  std::string body = "#include <Types.h>\n#include \"def.h\"\n\n";
  body += fmt::format("const int numOfHook = {};\n\n", kHookCount);
  body += selectors("Entry_Hook", "numOfHook", kHookCount);
  body += selectors("Entry_Control", "numOfSubject", subject_count);
  body += selectors("Entry_Ready", "numOfSubject", subject_count);
  body += selectors("Entry_Connect", "numOfObserver", observer_count);
  body += selectors("Entry_Notify", "numOfObserver", observer_count);
  body += fmt::format("\nconst longword numOfBasicEntries = {};\n", next);
  if (!config.extras.empty()) {
    body += "\n// The selector of an extra entry is Extra_Entry[entryName].\n";
    body += selectors("Extra_Entry", "", config.extras.size());
    for (size_t i = 0; i < config.extras.size(); ++i) {
      body += fmt::format("const int entry{} = {};\n", config.extras[i].function, i);
    }
  }
  return Guarded(Opening(source, "Selectors of the object's entries."), "_entry_h_DEFINED", body);
}

// ---- Generates <ObjectName>Stub.h, which declares a C function for each entry

std::string MakeStubHeader(const StubConfig& config, const std::string& source) {
  std::string body =
      "#define OPENR_STUBGEN\n\n"
      "#include <OPENR/OPENR.h>\n"
      "#include <OPENR/OPENRMessages.h>\n"
      "#include <OPENR/ObjcommMessages.h>\n"
      "#include <OPENR/stub_macro.h>\n"
      "#include \"def.h\"\n\n"
      "extern \"C\" {\n\n";
  for (const char* hook : kHooks) Append(&body, fmt::format("StubFuncDeclare_Basic({});", hook));
  for (size_t i = 0; i < config.subjects.size(); ++i) {
    Append(&body, fmt::format("StubFuncDeclare_Subject({});", i));
  }
  for (size_t i = 0; i < config.observers.size(); ++i) {
    Append(&body, fmt::format("StubFuncDeclare_Observer({});", i));
  }
  for (const StubExtra& extra : config.extras) {
    Append(&body, fmt::format("void _{}(void* msg);", extra.function));
  }
  Append(&body, "\n}");
  return Guarded(Opening(source, "C functions behind the object's entries."), "_stub_h_DEFINED",
                 body);
}

// ---- Generates <ObjectName>Stub.cc, which defines the C functions and the table of entries

// Returns the line of the stub that defines the entry number `index` of the kind `kind`, such as
// "StubFuncDefine_Ready(0, Resend)".  If `function` is "", the entry does nothing: the line is
// "StubFuncDefine_Ready_nofunc(0)".
std::string ServiceDefinition(const char* kind, size_t index, const std::string& function) {
  return function.empty() ? fmt::format("StubFuncDefine_{}_nofunc({})\n", kind, index)
                          : fmt::format("StubFuncDefine_{}({}, {})\n", kind, index, function);
}

void AppendServiceEntries(const char* kind, const std::vector<StubService>& services,
                          std::string StubService::*function, std::vector<EntryPoint>* entries) {
  for (size_t i = 0; i < services.size(); ++i) {
    entries->push_back(
        {fmt::format("{}{}", kind, i), ServiceDefinition(kind, i, services[i].*function)});
  }
}

// Returns all entries of the object whose stub.cfg is `config`, in the order of their selectors.
std::vector<EntryPoint> ListEntries(const StubConfig& config) {
  std::vector<EntryPoint> entries;
  for (const char* hook : kHooks) {
    entries.push_back({hook, fmt::format("StubFuncDefine_Basic({})\n", hook)});
  }
  AppendServiceEntries("Control", config.subjects, &StubService::connect_function, &entries);
  AppendServiceEntries("Ready", config.subjects, &StubService::data_function, &entries);
  AppendServiceEntries("Connect", config.observers, &StubService::connect_function, &entries);
  AppendServiceEntries("Notify", config.observers, &StubService::data_function, &entries);
  for (const StubExtra& extra : config.extras) {
    entries.push_back({extra.function, fmt::format("\nextern \"C\" void\n_{0}(void* msg)\n{{\n"
                                                   "    Self.{0}(msg);\n    Return();\n}}\n",
                                                   extra.function)});
  }
  return entries;
}

// Returns the definition of openr_extra_names, the array with the names of the extra entries, which
// the host reads from the image.  The generated text first declares the array with `extern`,
// because other files cannot see a const array without such a declaration, even in extern "C".  The
// declaration has OPENR_HOST_EXPORT, because g++ makes the array visible outside of the image only
// if the first declaration has it.
std::string MakeExtraNames(const StubConfig& config) {
  std::string names;
  for (const StubExtra& extra : config.extras) names += fmt::format("\"{}\", ", extra.function);
  return fmt::format(
      "// The extra entries by name, for the traces of a host.\n"
      "#ifndef OPENR_HOST_EXPORT\n#define OPENR_HOST_EXPORT\n#endif\n"
      "extern \"C\" {{\n"
      "extern OPENR_HOST_EXPORT const char* const openr_extra_names[];\n"
      "const char* const openr_extra_names[] = {{ {}0 }};\n"
      "}}\n",
      names);
}

std::string MakeStubSource(const StubConfig& config, const std::string& source) {
  const std::vector<EntryPoint> entries = ListEntries(config);
  std::string text = Opening(source, "Entries of the object, and the object itself.");
  text += fmt::format(
      "#include <apsys.h>\n"
      "#include <MCOOP.h>\n"
      "#include <ObjectEntryTable.h>\n"
      "#include <OPENR/stub_macro.h>\n"
      "#include \"def.h\"\n"
      "#include \"entry.h\"\n"
      "#include \"{0}Stub.h\"\n"
      "#include \"{0}.h\"\n\n"
      "{0} Self;\n\n",
      config.object_name);
  for (const EntryPoint& entry : entries) text += entry.definition;
  text += "\nGEN_ENTRY(PrologueEntry, Prologue);\n";
  for (const EntryPoint& entry : entries) {
    text += fmt::format("GEN_ENTRY({0}stub, _{0});\n", entry.name);
  }
  text += "\nObjectEntry ObjectEntryTable[] = {\n";
  for (size_t selector = 0; selector < entries.size(); ++selector) {
    text += fmt::format("    {{ {}, (Entry){}stub }},\n", selector, entries[selector].name);
  }
  text += "    { UNDEF, (Entry)ENTRY_UNDEF }\n};\n\n";
  return text + MakeExtraNames(config);
}

}  // namespace

std::vector<GeneratedFile> GenerateStub(const StubConfig& config, const std::string& source) {
  ASSERT(!config.object_name.empty());
  ASSERT(!config.subjects.empty() && !config.observers.empty(), "{}", config.object_name);
  return {{"def.h", MakeDefHeader(config, source)},
          {"entry.h", MakeEntryHeader(config, source)},
          {config.object_name + "Stub.h", MakeStubHeader(config, source)},
          {config.object_name + "Stub.cc", MakeStubSource(config, source)}};
}

}  // namespace openr_host
