#include "runtime/config/stub_generator.h"

#include <gtest/gtest.h>

namespace openr_host::stub_generator_test {
namespace {

// A stub.cfg with two subjects and two observers in mixed order, of which one each have the same
// name, and two extras.
constexpr const char* kMover =
    "ObjectName : Mover\n"
    "NumOfOSubject : 2\n"
    "NumOfOObserver : 2\n"
    "Service : \"M.In.Data.O\", null, NotifyIn()\n"
    "Service : \"M.Out.Data.S\", ControlOut(), ReadyOut()\n"
    "Service : \"M.In.Echo.S\", null, null\n"
    "Service : \"M.Late.Data.O\", ConnectLate(), null\n"
    "Extra : Tick()\n"
    "Extra : UpdatePowerStatus()\n";

constexpr const char* kPlain =
    "ObjectName : Plain\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
    "Service : \"Plain.A.T.S\", null, null\nService : \"Plain.B.T.O\", null, null\n";

std::vector<GeneratedFile> Generate(const char* text) {
  const StubConfigResult parsed = ParseStubConfig("stub.cfg", text);
  EXPECT_EQ(Render(parsed.diagnostics), "");
  return GenerateStub(parsed.config, "stub.cfg");
}

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StubGeneratorTest, FourFilesHaveSonysNames) {
  const std::vector<GeneratedFile> files = Generate(kMover);
  ASSERT_EQ(files.size(), 4u);
  EXPECT_EQ(files[0].name, "def.h");
  EXPECT_EQ(files[1].name, "entry.h");
  EXPECT_EQ(files[2].name, "MoverStub.h");
  EXPECT_EQ(files[3].name, "MoverStub.cc");
}

TEST(StubGeneratorTest, DefHeaderNamesServicesAndIndices) {
  EXPECT_EQ(Generate(kMover)[0].text,
            R"(// Services of the object, and their indices.
// Made from stub.cfg by openr stubgen: edit that file, not this one.
#ifndef _def_h_DEFINED
#define _def_h_DEFINED

const char* const objectName = "Mover";

const int numOfSubject = 2;
const int numOfObserver = 2;

const char* const subjectService[numOfSubject] = {
    "M.Out.Data.S",
    "M.In.Echo.S"
};
const char* const observerService[numOfObserver] = {
    "M.In.Data.O",
    "M.Late.Data.O"
};

const int sbjOut = 0;
const int sbjIn = 1;
const int obsIn = 0;
const int obsLate = 1;

#endif // _def_h_DEFINED
)");
}

TEST(StubGeneratorTest, EntryHeaderNumbersControlsReadysConnectsNotifysAndExtras) {
  EXPECT_EQ(Generate(kMover)[1].text,
            R"(// Selectors of the object's entries.
// Made from stub.cfg by openr stubgen: edit that file, not this one.
#ifndef _entry_h_DEFINED
#define _entry_h_DEFINED

#include <Types.h>
#include "def.h"

const int numOfHook = 4;

const Selector Entry_Hook[numOfHook] = { 0, 1, 2, 3 };
const Selector Entry_Control[numOfSubject] = { 4, 5 };
const Selector Entry_Ready[numOfSubject] = { 6, 7 };
const Selector Entry_Connect[numOfObserver] = { 8, 9 };
const Selector Entry_Notify[numOfObserver] = { 10, 11 };

const longword numOfBasicEntries = 12;

// The selector of an extra entry is Extra_Entry[entryName].
const Selector Extra_Entry[] = { 12, 13 };
const int entryTick = 0;
const int entryUpdatePowerStatus = 1;

#endif // _entry_h_DEFINED
)");
}

TEST(StubGeneratorTest, EntryHeaderWithoutExtrasHasNoTableOfThem) {
  EXPECT_FALSE(Contains(Generate(kPlain)[1].text, "Extra_Entry"));
}

TEST(StubGeneratorTest, StubHeaderDeclaresEveryEntry) {
  EXPECT_EQ(Generate(kMover)[2].text,
            R"(// C functions behind the object's entries.
// Made from stub.cfg by openr stubgen: edit that file, not this one.
#ifndef _stub_h_DEFINED
#define _stub_h_DEFINED

#define OPENR_STUBGEN

#include <OPENR/OPENR.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/stub_macro.h>
#include "def.h"

extern "C" {

StubFuncDeclare_Basic(Init);
StubFuncDeclare_Basic(Start);
StubFuncDeclare_Basic(Stop);
StubFuncDeclare_Basic(Destroy);
StubFuncDeclare_Subject(0);
StubFuncDeclare_Subject(1);
StubFuncDeclare_Observer(0);
StubFuncDeclare_Observer(1);
void _Tick(void* msg);
void _UpdatePowerStatus(void* msg);

}

#endif // _stub_h_DEFINED
)");
}

TEST(StubGeneratorTest, StubSourceDefinesSelfEntriesAndTable) {
  EXPECT_EQ(Generate(kMover)[3].text,
            R"(// Entries of the object, and the object itself.
// Made from stub.cfg by openr stubgen: edit that file, not this one.
#include <apsys.h>
#include <MCOOP.h>
#include <ObjectEntryTable.h>
#include <OPENR/stub_macro.h>
#include "def.h"
#include "entry.h"
#include "MoverStub.h"
#include "Mover.h"

Mover Self;

StubFuncDefine_Basic(Init)
StubFuncDefine_Basic(Start)
StubFuncDefine_Basic(Stop)
StubFuncDefine_Basic(Destroy)
StubFuncDefine_Control(0, ControlOut)
StubFuncDefine_Control_nofunc(1)
StubFuncDefine_Ready(0, ReadyOut)
StubFuncDefine_Ready_nofunc(1)
StubFuncDefine_Connect_nofunc(0)
StubFuncDefine_Connect(1, ConnectLate)
StubFuncDefine_Notify(0, NotifyIn)
StubFuncDefine_Notify_nofunc(1)

extern "C" void
_Tick(void* msg)
{
    Self.Tick(msg);
    Return();
}

extern "C" void
_UpdatePowerStatus(void* msg)
{
    Self.UpdatePowerStatus(msg);
    Return();
}

GEN_ENTRY(PrologueEntry, Prologue);
GEN_ENTRY(Initstub, _Init);
GEN_ENTRY(Startstub, _Start);
GEN_ENTRY(Stopstub, _Stop);
GEN_ENTRY(Destroystub, _Destroy);
GEN_ENTRY(Control0stub, _Control0);
GEN_ENTRY(Control1stub, _Control1);
GEN_ENTRY(Ready0stub, _Ready0);
GEN_ENTRY(Ready1stub, _Ready1);
GEN_ENTRY(Connect0stub, _Connect0);
GEN_ENTRY(Connect1stub, _Connect1);
GEN_ENTRY(Notify0stub, _Notify0);
GEN_ENTRY(Notify1stub, _Notify1);
GEN_ENTRY(Tickstub, _Tick);
GEN_ENTRY(UpdatePowerStatusstub, _UpdatePowerStatus);

ObjectEntry ObjectEntryTable[] = {
    { 0, (Entry)Initstub },
    { 1, (Entry)Startstub },
    { 2, (Entry)Stopstub },
    { 3, (Entry)Destroystub },
    { 4, (Entry)Control0stub },
    { 5, (Entry)Control1stub },
    { 6, (Entry)Ready0stub },
    { 7, (Entry)Ready1stub },
    { 8, (Entry)Connect0stub },
    { 9, (Entry)Connect1stub },
    { 10, (Entry)Notify0stub },
    { 11, (Entry)Notify1stub },
    { 12, (Entry)Tickstub },
    { 13, (Entry)UpdatePowerStatusstub },
    { UNDEF, (Entry)ENTRY_UNDEF }
};

// The extra entries by name, for the traces of a host.
#ifndef OPENR_HOST_EXPORT
#define OPENR_HOST_EXPORT
#endif
extern "C" {
extern OPENR_HOST_EXPORT const char* const openr_extra_names[];
const char* const openr_extra_names[] = { "Tick", "UpdatePowerStatus", 0 };
}
)");
}

TEST(StubGeneratorTest, ListOfExtraNamesIsThereEvenWhenEmpty) {
  EXPECT_TRUE(Contains(Generate(kPlain)[3].text, "const openr_extra_names[] = { 0 };\n"));
}

TEST(StubGeneratorTest, OutputDependsOnNothingButTheInput) {
  const std::vector<GeneratedFile> first = Generate(kMover);
  const std::vector<GeneratedFile> second = Generate(kMover);
  for (size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].text, second[i].text);
}

}  // namespace
}  // namespace openr_host::stub_generator_test
