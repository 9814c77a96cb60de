// LiveContext: what the requests of other programs to a run can read and change.
#pragma once

namespace openr_host {

class ConsoleLog;
class KnownRun;
class LiveEvents;
class MessageHistory;
class Rewind;
class RunClock;
class Simulation;

struct LiveContext {
  Simulation* simulation;
  RunClock* clock;
  ConsoleLog* console;
  MessageHistory* history;
  LiveEvents* events;
  Rewind* rewind;             // goes back to earlier moments
  KnownRun* known = nullptr;  // the run, if it repeats what is known; null: people can change it
};

}  // namespace openr_host
