// A recorded run in a file: what it was made of, all input from outside, and every message.
//
// docs/trace-format.md describes the layout.  A file is a header and blocks with a checksum each,
// so the file of a run that was killed can be used up to its last whole block.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "openr/inspect/byte_stream.h"
#include "runtime/core/trace.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

class System;
struct RunEnd;

constexpr uint32_t kTraceVersion = 3;
constexpr uint32_t kOldestTraceVersion = 2;  // oldest version that can be read; it has no kEnded

// Everything besides the recorded input that determines a run.
struct TraceHeader {
  std::string program;  // version of openr
  std::string stick;    // folder, as the user wrote it
  uint64_t stick_hash = 0;
  std::string robot, body, world;
  std::string cost;                    // cost file; "": zero cost
  std::string battery;                 // see ParseBattery()
  std::string microphone, images;      // file, folder; "": none
  std::vector<std::string> addresses;  // arguments of --ip, "10.0.1.2=127.0.0.1"
  int robots = 1;
  uint64_t seed = 1;
  bool strict = false;
  bool is_free = false;  // free-running runs cannot be replayed
  bool payloads = true;  // messages carry their bytes
};

struct TraceEntry {
  enum class Kind : uint8_t {
    kObject = 1,    // id, robot, name; comes before the first message of the object
    kEntry = 2,     // id (of the object), selector, name
    kMessage = 3,   // record, payload
    kNetwork = 4,   // robot, events: result of one Poll(), during the message before
    kPause = 5,     // time_us: the pause button was pressed
    kShutdown = 6,  // time_us: no object handled the pause button, so the program shut down
    kEnd = 7,       // time_us, trace_hash, state_hash
    kConsole = 8,   // time_us, robot, name: what was typed
    kStick = 9,     // what, name, payload: a file or folder before an object changed it
    kLoss = 10,     // time_us, name: a process was lost; the rest cannot be replayed
    // Name, payload: EndName() and the reason, before kEnd; missing if the run was killed.
    kEnded = 11,
  };
  enum class OnStick : uint8_t { kNothing = 0, kFile = 1, kFolder = 2 };
  Kind kind = Kind::kEnd;
  int32_t id = 0;
  int32_t robot = 0;
  uint32_t selector = 0;
  std::string name;
  TraceRecord record{};
  std::string payload;
  OnStick what = OnStick::kNothing;
  std::vector<NetworkEvent> events;
  int64_t time_us = 0;
  uint64_t trace_hash = 0;
  uint64_t state_hash = 0;
};

// Encodes and decodes entries.  A number that can be predicted from the entry before takes few
// bytes.
class TraceCoder {
 public:
  explicit TraceCoder(bool payloads) : payloads_(payloads) {}
  void Write(const TraceEntry& entry, ByteWriter* out);
  TraceEntry Read(ByteReader* in);

 private:
  void WriteMessage(const TraceEntry& entry, ByteWriter* out);
  void ReadMessage(ByteReader* in, TraceEntry* entry);
  // Writes the difference to the last payload of the same sender and size.
  void WritePayload(const TraceEntry& entry, ByteWriter* out);
  void ReadPayload(ByteReader* in, TraceEntry* entry);

  const bool payloads_;
  uint64_t number_ = 0;
  int64_t time_us_ = 0;
  std::map<std::pair<int32_t, size_t>, std::string> last_;  // by sender and size
};

class TraceWriter {
 public:
  // Creates `file`.  Throws std::runtime_error when it cannot be created, or another process writes
  // to it.
  TraceWriter(const std::string& file, const TraceHeader& header);
  ~TraceWriter();
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  // Adds a message.  Called by a sink of the System's trace.
  void AddMessage(const System& system, const TraceRecord& record, const Message& message);
  void AddNetwork(int robot, std::vector<NetworkEvent> events);
  void AddAt(TraceEntry::Kind kind, int64_t time_us);
  void AddLoss(const std::string& process, int64_t time_us);
  void AddEnded(const RunEnd& end);
  void AddConsole(int robot, std::string_view text, int64_t time_us);
  // Adds the file or folder `path` of the host, which is about to change.  `name` is its path below
  // the stick's folder.
  void AddStick(const std::string& name, const std::string& path);

  // Writes out what has been added.  May be called in a signal handler that ends the process.
  void Flush();

  // Adds the last entry.  Returns "" or the error in writing the file.
  std::string Finish(System* system);

 private:
  void AddNames(const System& system, const TraceRecord& record);
  void Add(const TraceEntry& entry);
  void WriteOut(const std::string& bytes);

  const std::string file_;
  const bool payloads_;
  TraceCoder coder_;
  int descriptor_ = -1;
  int error_ = 0;  // errno of the first failed write
  ByteWriter block_;
  std::set<int32_t> objects_;
  std::set<std::pair<int32_t, uint32_t>> entries_;
};

class TraceReader {
 public:
  // Opens `file`.  Throws std::runtime_error when it is no trace file or has a version that cannot
  // be read.
  explicit TraceReader(const std::string& file);

  const TraceHeader& header() const { return header_; }

  // Returns the next entry without taking it; null at the end of the readable part.
  const TraceEntry* Peek();
  // Takes the next entry.  REQUIRES: Peek() is not null.
  TraceEntry Take();

  // Returns what is damaged or missing so far: "FILE: block 3 at offset 4711: ...".
  const std::vector<std::string>& problems() const { return problems_; }

  // Returns "FILE: the recording does not say how the run ended: ..." when the last block is whole
  // but no end was recorded; otherwise, and before the end of the file, "".
  const std::string& note() const { return note_; }

  // Returns the name of an object, or a text with its id if no entry has named it yet.
  std::string ObjectName(int32_t id) const;
  std::string EntryName(int32_t id, uint32_t selector) const;
  int RobotOf(int32_t id) const;
  // Returns EndName() and the reason of the run's end; empty when not recorded or not reached yet.
  const std::pair<std::string, std::string>& ended() const { return why_ended_; }
  // At the end of the file, returns "" or an error such as "there is no object 'JointMvoer'; did
  // you mean ...".  An empty name is never an error.
  std::string WhyNothing(const std::string& object, const std::string& service) const;

 private:
  bool NextBlock();
  void Damaged(const std::string& what);
  std::string AfterWhat() const;
  void Learn(const TraceEntry& entry);

  const std::string file_;
  std::string bytes_;
  size_t at_ = 0;
  int block_count_ = 0;
  size_t block_size_ = 0;  // size of the last block
  TraceHeader header_;
  std::optional<TraceCoder> coder_;
  std::optional<ByteReader> block_;
  std::optional<TraceEntry> next_;
  bool ended_ = false;
  TraceRecord last_{};  // record of the message before
  std::pair<std::string, std::string> why_ended_;
  std::vector<std::string> problems_;
  std::string note_;
  std::map<int32_t, std::pair<int, std::string>> objects_;  // by id: robot and name
  std::map<std::pair<int32_t, uint32_t>, std::string> entries_;
};

}  // namespace openr_host
