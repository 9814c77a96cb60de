// LiveContext: the parts of a run that requests of other programs can read and change.
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
  Rewind* rewind;  // goes back to earlier moments of this run
  // The replay, if this run repeats a recording or another known run; null: clients can change this
  // run.
  KnownRun* known = nullptr;
};

}  // namespace openr_host
