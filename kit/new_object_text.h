// The texts of the files that `openr new` writes for a new object.  @Name@ stands for the name of
// the object's class, @name@ for its name in the .ocf file, @NAME@ for the file name of its image
// without ".BIN".
#pragma once

namespace openr_host::new_object {

inline constexpr char kStub[] =
    R"(// What the object offers and takes; `stubgen2 stub.cfg` makes its stub of it.
ObjectName : @Name@
NumOfOSubject : 1
NumOfOObserver : 1
Service : "@Name@.DummySubject.DoNotConnect.S", null, null
Service : "@Name@.Sensor.OSensorFrameVectorData.O", null, NotifySensor()
)";

inline constexpr char kOcf[] = R"(# name, stack, step of the heap, priority, cache, tlb, mode
object @name@ 3072 16384 128 cache tlb user
)";

inline constexpr char kHeader[] = R"(#ifndef @Name@_h_DEFINED
#define @Name@_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include "def.h"

class @Name@ : public OObject {
public:
    @Name@();
    virtual ~@Name@() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifySensor(const ONotifyEvent& event);

private:
    int vectors;  // sensor vectors so far; each has the values of 32 ms
};

#endif // @Name@_h_DEFINED
)";

inline constexpr char kSource[] = R"(#include "@Name@.h"

#include <OPENR/ODataFormats.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

@Name@::@Name@() : vectors(0)
{
}

OStatus
@Name@::DoInit(const OSystemEvent& event)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
@Name@::DoStart(const OSystemEvent& event)
{
    OSYSPRINT(("@Name@ has started\n"));
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
@Name@::DoStop(const OSystemEvent& event)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
@Name@::DoDestroy(const OSystemEvent& event)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// The robot sends a sensor vector every 32 ms, as long as we assert ready.
void
@Name@::NotifySensor(const ONotifyEvent& event)
{
    const OSensorFrameVectorData* vector = (const OSensorFrameVectorData*)event.Data(0);
    if (vectors++ == 0) {
        OSYSPRINT(("@Name@ hears %d sensors\n", (int)vector->vectorInfo.numData));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
)";

// A source that is compiled to find out whether a class can have the name @Name@.
inline constexpr char kNameCheck[] = R"(#include <OPENR/ODataFormats.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>
#include <OPENR/OSyslog.h>

class @Name@ : public OObject {
public:
    @Name@() {}
    void NotifySensor(const ONotifyEvent&) {}
};

void
UseTheClass(const OSystemEvent& event, const ONotifyEvent& notification)
{
    @Name@* const object = new @Name@;
    object->Init(event);
    object->Start(event);
    object->Stop(event);
    object->Destroy(event);
    object->DoInit(event);
    object->DoStart(event);
    object->DoStop(event);
    object->DoDestroy(event);
    object->NotifySensor(notification);
}
)";

inline constexpr char kObjectConfig[] = R"(/MS/OPEN-R/MW/OBJS/POWERMON.BIN
/MS/OPEN-R/MW/OBJS/@NAME@.BIN
)";

inline constexpr char kConnectConfig[] = R"(# subject observer
OVirtualRobotComm.Sensor.OSensorFrameVectorData.S @Name@.Sensor.OSensorFrameVectorData.O
)";

inline constexpr char kMakefile[] = R"(# For the robot, with its SDK: make install
# For the host: openr build .
# or, with P where openr-host is installed: make install OPENRSDK_ROOT=P/share/openr-host/sdk
OPENRSDK_ROOT ?= /usr/local/OPEN_R_SDK
INSTALLDIR = MS
OBJS = $(INSTALLDIR)/OPEN-R/MW/OBJS
CXX = $(OPENRSDK_ROOT)/bin/mipsel-linux-g++
STRIP = $(OPENRSDK_ROOT)/bin/mipsel-linux-strip
MKBIN = $(OPENRSDK_ROOT)/OPEN_R/bin/mkbin
STUBGEN = $(OPENRSDK_ROOT)/OPEN_R/bin/stubgen2
LIBS = -lObjectComm -lOPENR
# Every .cc file of the folder @Name@ belongs to the object; stubgen2 makes @Name@Stub.cc.
SOURCES = $(filter-out @Name@/@Name@Stub.cc,$(wildcard @Name@/*.cc))
OBJECTS = @Name@/@Name@Stub.o $(SOURCES:.cc=.o)
CXXFLAGS = -O2 -g -I@Name@ -I$(OPENRSDK_ROOT)/OPEN_R/include/R4000 \
  -I$(OPENRSDK_ROOT)/OPEN_R/include

.PHONY: all install clean
all: @Name@/@name@.bin

@Name@/@Name@Stub.cc: @Name@/stub.cfg
	cd @Name@ && $(STUBGEN) stub.cfg

@Name@/def.h: @Name@/@Name@Stub.cc

@Name@/%.o: @Name@/%.cc @Name@/def.h $(wildcard @Name@/*.h)
	$(CXX) $(CXXFLAGS) -o $@ -c $<

@Name@/@name@.bin: $(OBJECTS) @Name@/@name@.ocf
	$(MKBIN) -p $(OPENRSDK_ROOT) -o $@ $^ $(LIBS)
	$(STRIP) $@

# POWERMON.BIN handles the pause button.  The host's SDK brings one.
install: @Name@/@name@.bin
	mkdir -p $(OBJS) $(INSTALLDIR)/OPEN-R/MW/DATA/P
	gzip -c $< > $(OBJS)/@NAME@.BIN
	if [ -f $(OPENRSDK_ROOT)/images/POWERMON.BIN ] && [ ! -f $(OBJS)/POWERMON.BIN ]; then \
	  cp $(OPENRSDK_ROOT)/images/POWERMON.BIN $(OBJS); fi

clean:
	rm -f @Name@/*.o @Name@/*.bin @Name@/*.elf @Name@/@Name@Stub.* @Name@/def.h @Name@/entry.h
)";

// The file .gitignore: lists what builds and runs leave behind, so that nobody commits it.
inline constexpr char kIgnore[] = R"(# What openr build, make, CMake and runs leave here.
/build/
/compile_commands.json
/MS/OPEN-R/MW/OBJS/
/MS/OPEN-R/EMON.LOG
/@Name@/*.o
/@Name@/*.bin
/@Name@/*.elf
/@Name@/@Name@Stub.*
/@Name@/def.h
/@Name@/entry.h
)";

inline constexpr char kCMake[] =
    R"(# For the host, with P where openr-host is installed, or the folder it was built in:
#   cmake -S . -B build -DCMAKE_PREFIX_PATH=P
#   cmake --build build
#   ctest --test-dir build
#   openr run --stick build/stick
cmake_minimum_required(VERSION 3.16)
project(@Name@ LANGUAGES CXX)
find_package(openr-host REQUIRED)

# Every .cc file of the folder @Name@ belongs to the object.  The robot's make leaves
# @Name@Stub.cc there, which openr_add_object() makes anew.
file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/@Name@/*.cc")
list(REMOVE_ITEM sources "${CMAKE_CURRENT_SOURCE_DIR}/@Name@/@Name@Stub.cc")
openr_add_object(NAME @name@ BIN @NAME@.BIN
  STUB @Name@/stub.cfg
  OCF @Name@/@name@.ocf
  SOURCES ${sources}
  INCLUDES @Name@)
openr_add_stick(NAME stick FOLDER MS OBJECTS @name@)

# GoogleTest with openr::testing; what is missing for it is said above.
if(TARGET openr::testing)
  enable_testing()
  add_executable(@name@_test test/@Name@Test.cc)
  set_target_properties(@name@_test PROPERTIES CXX_STANDARD 20)
  target_compile_definitions(@name@_test PRIVATE STICK="${CMAKE_CURRENT_BINARY_DIR}/stick")
  target_link_libraries(@name@_test PRIVATE openr::testing GTest::gmock_main)
  add_dependencies(@name@_test stick)
  add_test(NAME @Name@ COMMAND @name@_test)
endif()
)";

inline constexpr char kTest[] = R"(// What @Name@ does on its stick, with openr::testing.
#include <openr/testing.h>

using namespace openr::testing;

class @Name@Test : public ::testing::Test {
 protected:
  @Name@Test() { bench.Boot(); }

  Bench bench{{.stick = STICK, .body = "ideal"}};
};

TEST_F(@Name@Test, HearsTheSensorsOfTheRobot) {
  bench.RunFor(100ms);
  EXPECT_THAT(bench.console(), ::testing::HasSubstr("@Name@ hears 31 sensors"));
}

// The robot sends the next vector only after the object has asserted ready.
TEST_F(@Name@Test, SaysReadyAfterEveryVector) {
  for (int i = 0; i < 3; i++) {
    bench.Expect(Notify("OVirtualRobotComm.Sensor", "@Name@.Sensor"));
    bench.Expect(Ready("@Name@.Sensor"));
  }
  bench.RunFor(200ms);
}
)";

}  // namespace openr_host::new_object
