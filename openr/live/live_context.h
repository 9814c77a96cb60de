// LiveContext: what the requests of other programs to a run can read and change.
#pragma once

namespace openr_host {

class ConsoleLog;
class LiveEvents;
class MessageHistory;
class RunClock;
class Simulation;

struct LiveContext {
  Simulation* simulation;
  RunClock* clock;
  ConsoleLog* console;
  MessageHistory* history;
  LiveEvents* events;
};

}  // namespace openr_host
