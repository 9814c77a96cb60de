// A recorded run in a file: what it was made of, what came from outside, every message.
//
// The layout is docs/trace-format.md.  A file is a header and blocks with a checksum each, so
// that a run that was killed leaves a file that can be used up to its last block.
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
constexpr uint32_t kOldestTraceVersion = 2;  // that can be read: it has no kEnded

// What a run is a function of, besides the recorded input.
struct TraceHeader {
  std::string program;  // version of openr
  std::string stick;    // folder, as it was given
  uint64_t stick_hash = 0;
  std::string robot, body, world;
  std::string cost;                    // file; "": zero
  std::string battery;                 // see ParseBattery()
  std::string microphone, images;      // files and folders; "": none
  std::vector<std::string> addresses;  // of --ip, "10.0.1.2=127.0.0.1"
  int robots = 1;
  uint64_t seed = 1;
  bool strict = false;
  bool is_free = false;  // --free-running: cannot be replayed
  bool payloads = true;  // messages carry their bytes
};

struct TraceEntry {
  enum class Kind : uint8_t {
    kObject = 1,    // id, robot, name: before its first message
    kEntry = 2,     // id (of the object), selector, name
    kMessage = 3,   // record, payload
    kNetwork = 4,   // robot, events: what one Poll() returned, during the message before
    kPause = 5,     // time_us: the pause button was pressed
    kShutdown = 6,  // time_us: nobody handled it, the program asked for the shutdown
    kEnd = 7,       // time_us, trace_hash, state_hash
    kConsole = 8,   // time_us, robot, name: what was typed
    kStick = 9,     // what, name, payload: a file or folder before objects change it
    kLoss = 10,     // time_us, name: of a process that was lost; what follows cannot be replayed
    kEnded = 11,    // name, payload: EndName() and why, before kEnd; none when the run was killed
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

// Numbers that follow from the entry before need few bytes.
class TraceCoder {
 public:
  explicit TraceCoder(bool payloads) : payloads_(payloads) {}
  void Write(const TraceEntry& entry, ByteWriter* out);
  TraceEntry Read(ByteReader* in);

 private:
  void WriteMessage(const TraceEntry& entry, ByteWriter* out);
  void ReadMessage(ByteReader* in, TraceEntry* entry);
  // As what differs from the last payload of the same sender and size.
  void WritePayload(const TraceEntry& entry, ByteWriter* out);
  void ReadPayload(ByteReader* in, TraceEntry* entry);

  const bool payloads_;
  uint64_t number_ = 0;
  int64_t time_us_ = 0;
  std::map<std::pair<int32_t, size_t>, std::string> last_;  // by sender and size
};

class TraceWriter {
 public:
  // Throws std::runtime_error when the file cannot be made, or another process writes it.
  TraceWriter(const std::string& file, const TraceHeader& header);
  ~TraceWriter();
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  // From the trace's sink.
  void AddMessage(const System& system, const TraceRecord& record, const Message& message);
  void AddNetwork(int robot, std::vector<NetworkEvent> events);
  void AddAt(TraceEntry::Kind kind, int64_t time_us);
  void AddLoss(const std::string& process, int64_t time_us);
  void AddEnded(const RunEnd& end);
  void AddConsole(int robot, std::string_view text, int64_t time_us);
  // `path` on the host is about to change; `name` is what it is below the stick's folder.
  void AddStick(const std::string& name, const std::string& path);

  // Writes what has been added.  Fit for a signal handler that ends the process.
  void Flush();

  // The last entry.  Returns what went wrong with the file, or "".
  std::string Finish(System* system);

 private:
  void AddNames(const System& system, const TraceRecord& record);
  void Add(const TraceEntry& entry);
  void WriteOut(const std::string& bytes);

  const std::string file_;
  const bool payloads_;
  TraceCoder coder_;
  int descriptor_ = -1;
  int error_ = 0;  // the first of writing
  ByteWriter block_;
  std::set<int32_t> objects_;
  std::set<std::pair<int32_t, uint32_t>> entries_;
};

class TraceReader {
 public:
  // Throws std::runtime_error when it is no trace file or one of another version.
  explicit TraceReader(const std::string& file);

  const TraceHeader& header() const { return header_; }

  // The next entry without taking it; null at the end of what can be read.
  const TraceEntry* Peek();
  // REQUIRES: Peek() is not null.
  TraceEntry Take();

  // "FILE: block 3 at offset 4711: ..." of what is damaged or missing, as far as it was met.
  const std::vector<std::string>& problems() const { return problems_; }

  // "FILE: the recording does not say how the run ended: ..." when it has a whole last block but no
  // end; "" otherwise, and as long as the end of the file was not met.
  const std::string& note() const { return note_; }

  // Names seen so far.
  std::string ObjectName(int32_t id) const;
  std::string EntryName(int32_t id, uint32_t selector) const;
  int RobotOf(int32_t id) const;
  // Why the run ended: EndName() and a sentence; empty when it was not recorded, or not met yet.
  const std::pair<std::string, std::string>& ended() const { return why_ended_; }
  // At the end: "there is no object 'JointMvoer'; did you mean ...", or "".  Empty names are there.
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
  size_t block_size_ = 0;  // of the last one
  TraceHeader header_;
  std::optional<TraceCoder> coder_;
  std::optional<ByteReader> block_;
  std::optional<TraceEntry> next_;
  bool ended_ = false;
  TraceRecord last_{};  // the message before
  std::pair<std::string, std::string> why_ended_;
  std::vector<std::string> problems_;
  std::string note_;
  std::map<int32_t, std::pair<int, std::string>> objects_;  // robot, name
  std::map<std::pair<int32_t, uint32_t>, std::string> entries_;
};

}  // namespace openr_host
