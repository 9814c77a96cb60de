#include "Probe.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <MCOOP.h>
#include <dirent.h>
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "Early.h"
#include "HostState.h"
#include "Imports.h"

static int callCount = 0;  // a static of the image, so each loaded copy has its own

static int earlyCount = 0;  // messages to the entry DoEarly

// If the stick has the file OWN.TXT, does for its own object what constructors seldom do.
Probe::Probe() : oidWasKnown(myOID_.IsValid()) {
  if (!SendEarly(myOID_)) return;
  RegisterServiceEntry(OServiceEntry(myOID_, earlyEntry), "Probe.Early.Text.S");
}

void Probe::DoEarly(void*) { ++earlyCount; }

OStatus Probe::DoInit(const OSystemEvent& event) {
  NEW_ALL_SUBJECT_AND_OBSERVER;
  REGISTER_ALL_ENTRY;
  SET_ALL_READY_AND_NOTIFY_ENTRY;
  return event.Reason() == oreasonBOOT ? oSUCCESS : oFAIL;
}

OStatus Probe::DoStart(const OSystemEvent&) {
  OSYSLOG1((osyslogINFO, "state: %s", "probing"));
  ENABLE_ALL_SUBJECT;
  ASSERT_READY_TO_ALL_OBSERVER;
  AskAgain(myOID_);
  return oSUCCESS;
}

OStatus Probe::DoStop(const OSystemEvent&) {
  OSYSPRINT(("stopped\n"));
  DISABLE_ALL_SUBJECT;
  DEASSERT_READY_TO_ALL_OBSERVER;
  return oSUCCESS;
}

OStatus Probe::DoDestroy(const OSystemEvent&) {
  OSYSPRINT(("destroyed\n"));
  DELETE_ALL_SUBJECT_AND_OBSERVER;
  return oSUCCESS;
}

void Probe::Say(const std::string& text) {
  subject[sbjOut]->SetData(text.c_str(), text.size() + 1);
  subject[sbjOut]->NotifyObservers();
}

void Probe::ReadyOut(const OReadyEvent&) {}

static std::string ReadAll(const char* path) {
  std::ifstream file(path);
  if (!file) return "no file";
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

static std::string WriteWithStdio(const char* path, const char* text) {
  FILE* file = fopen(path, "w");
  if (file == 0) return "cannot write";
  fputs(text, file);
  fclose(file);
  return "written";
}

static std::string ListFolder(const char* path) {
  DIR* folder = opendir(path);
  if (folder == 0) return "no folder";
  int count = 0;
  while (readdir(folder) != 0) ++count;
  closedir(folder);
  return count > 2 ? "listed" : "empty";
}

// As many MiB as it gets, up to `most`; given back before it returns.
static std::string Hoard(int most) {
  std::vector<void*> pieces;
  while ((int)pieces.size() < most) {
    void* const piece = malloc(1 << 20);
    if (piece == 0) break;
    pieces.push_back(piece);
  }
  std::ostringstream out;
  if ((int)pieces.size() < most) out << "refused after ";
  out << pieces.size() << " MiB";
  for (size_t i = 0; i < pieces.size(); i++) free(pieces[i]);
  return out.str();
}

static int __attribute__((noinline)) Deep(const char* text) {
  volatile char frame[12000];
  frame[0] = text[0];
  return frame[0];
}

// Rounds up for the rest of the handler.  Returns how this handler has begun, and how it rounds
// after calls of the SDK.
static std::string AnswerRounding(const std::string& command) {
  if (command.compare(0, 5, "round") != 0) return "";
  volatile double one = 1, three = 3;
  volatile double nearest = one / three;
  std::string said = fegetround() == FE_TONEAREST ? "began nearest" : "began otherwise";
  fesetround(FE_UPWARD);
  OSYSPRINT(("0.4 is printed as %.0f\n", 0.4));
  if (command == "round exit") exit(0);
  if (command == "round throw") throw std::runtime_error("thrown while rounding up");
  if (command == "round wait") {
    OID talker;
    char question[] = "who?", reply[16] = "";
    Find("talker", &talker);
    Call(talker, oentryBASE + 6, question, sizeof(question), reply, sizeof(reply));
  }
  volatile double upward = one / three;
  said += upward > nearest ? ", goes on up" : ", goes on otherwise";
  return said;
}

std::string Probe::Answer(const std::string& command) {
  std::ostringstream out;
    out << AnswerRounding(command);
    out << AnswerImports(command) << AnswerHostState(command);
  if (command == "count") out << ++callCount;
  if (command == "early") out << earlyCount << " early, " << AnswerEarly();
  if (command == "oid") out << (oidWasKnown ? "known" : "unknown");
  if (command == "stream") out << 3.25 << " " << true << " " << std::hex << 255;
  if (command == "read") out << ReadAll("/MS/OPEN-R/mw/data/p/hello.txt");
  if (command == "read outside") out << ReadAll("/etc/passwd");
  if (command == "read relative") out << ReadAll("HELLO.TXT");
  if (command == "read dotdot") out << ReadAll("/MS/../../etc/passwd");
  if (command == "write") out << WriteWithStdio("/MS/OPEN-R/MW/DATA/P/out.txt", "from the probe");
  if (command == "list") out << ListFolder("/MS/OPEN-R/MW/CONF");
  if (command == "random") out << rand() << " " << rand();
  if (command == "size") {
    struct stat status;
    out << (stat("/MS/OPEN-R/MW/DATA/P/HELLO.TXT", &status) == 0 ? static_cast<int>(status.st_size)
                                                                 : -1);
  }
  if (command == "heap") {
    std::vector<std::string> many;
    for (int i = 0; i < 1000; i++) many.push_back(std::string(static_cast<size_t>(i), 'x'));
    heard.push_back(many.back());
    out << many.back().size();
  }
  if (command == "hoard") out << Hoard(64);
  if (command == "deep") out << Deep(command.c_str());
  if (command == "keep") {
    heard.push_back(std::string(100000, 'k'));
    out << heard.size();
  }
  if (command == "remove") out << remove("/MS/OPEN-R/MW/DATA/P/GONE.TXT");
  if (command == "long") {
    slongword value = -5;
    OSYSPRINT(("%ld %5ld|\n", value, static_cast<slongword>(42)));
    out << "printed";
  }
  return out.str();
}

void Probe::NotifyIn(const ONotifyEvent& event) {
  const std::string command = static_cast<const char*>(event.Data(0));
  Say(Answer(command));
  observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void Probe::DoExit(void*) {
  OSYSPRINT(("before exit\n"));
  exit(0);
}

void Probe::DoAbort(void*) { abort(); }

void Probe::DoThrow(void*) { throw std::runtime_error("thrown by the probe"); }
