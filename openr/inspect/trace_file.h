// The file of a recorded run: the options of the run, all input from outside, and every message.
//
// docs/trace-format.md describes the layout.  A file is a header and blocks; each block has a
// checksum.  So the file of a run that was killed can be used up to its last whole block.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "openr/inspect/byte_stream.h"
#include "openr/inspect/payload_coder.h"
#include "openr/inspect/recording_bytes.h"
#include "runtime/core/trace.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

class System;
struct RunEnd;

constexpr uint32_t kTraceVersion = 5;
// The oldest version of the format of recordings that can be read.  Version 2 has no kEnded.
// Versions 2 and 3 have kOldPause, kOldShutdown and kOldConsole in place of kInput.  Versions 2 to
// 4 have kOldMessage in place of kMessage.  An old kind is converted to the new kind when the file
// is read.
constexpr uint32_t kOldestTraceVersion = 2;

// The options that, together with the recorded input, determine everything in a run.
struct TraceHeader {
  std::string program;  // version of openr that has made the recording
  std::string stick;    // folder of the Memory Stick, as the user wrote it
  uint64_t stick_hash = 0;
  std::string robot, body, world;
  std::string cost;                    // the cost file; "": handlers take no time
  std::string battery;                 // value of --battery, see ParseBattery()
  std::string microphone;              // sound file that the robot hears; "": none
  std::string images;                  // value of --images, see OpenImages()
  std::vector<std::string> addresses;  // arguments of --ip, such as "10.0.1.2=127.0.0.1"
  int robots = 1;
  bool together = false;                 // true: all robots are in one world
  std::vector<std::string> more_sticks;  // further sticks, see SimulationOptions::more_sticks
  std::vector<uint64_t> more_stick_hashes;
  uint64_t seed = 1;
  bool strict = false;
  bool is_free = false;          // true: the run was free-running and cannot be replayed
  bool write_protected = false;  // true: the stick of the run's only robot was write-protected
  // The order of messages of a failing run of openr explore, as JSON with some fields of the
  // schedule file (docs/exploring.md).  "" if the seed chooses the order.
  std::string schedule;
  bool payloads = true;  // true: the bytes of messages are recorded; false: only their hashes
};

struct TraceEntry {
  // The kind of a TraceEntry, such as a message or an input.  The comment of each kind names the
  // fields of TraceEntry that belong to the kind.
  enum class Kind : uint8_t {
    kObject = 1,  // an object, before its first message; fields: id, robot, name
    // The name of an entry (handler) of the object `id`, before the first message to this handler;
    // fields: id, selector, name.
    kEntry = 2,
    kOldMessage = 3,  // a message in a file of version 2 to 4; converted to kMessage
    // Network events that Poll() returned while the message before them in the recording was
    // handled; fields: robot, events.
    kNetwork = 4,
    kOldPause = 5,     // an input in a file of version 2 or 3; converted to kInput
    kOldShutdown = 6,  // an input in a file of version 2 or 3; converted to kInput
    kEnd = 7,          // the end of the recording; fields: time_us, trace_hash, state_hash
    kOldConsole = 8,   // an input in a file of version 2 or 3; converted to kInput
    // The content of a file or folder of the stick, before the run changed it; fields: what
    // (whether it was a file, a folder or missing), name, payload.
    kStick = 9,
    kLoss = 10,  // loss of a worker process; what follows cannot be replayed; fields: time_us, name
    // The end of the run.  The field `name` says how the run ended, as a word of EndName(), and
    // `payload` is the reason as text.  A recording whose process was killed has no kEnded.
    kEnded = 11,
    // A recorded input; fields: time_us, robot (-1: every robot), name, which is the text of the
    // input.
    kInput = 12,
    kMessage = 13,  // a delivered message; fields: record, payload
    // The last payloads of all senders count as zeros from here on (TraceCoder).  A reader of
    // entries does not see this kind.
    kForget = 14,
  };
  enum class PathKind : uint8_t { kNothing = 0, kFile = 1, kFolder = 2 };
  Kind kind = Kind::kEnd;
  int32_t id = 0;
  int32_t robot = 0;
  uint32_t selector = 0;
  std::string name;
  TraceRecord record{};
  std::string payload;
  PathKind what = PathKind::kNothing;
  std::vector<NetworkEvent> events;
  int64_t time_us = 0;
  uint64_t trace_hash = 0;
  uint64_t state_hash = 0;
};

// Encodes and decodes the parts of a recording, such as messages and inputs; each part is a
// TraceEntry.  Stores most numbers as the difference from the number before, because small numbers
// take fewer bytes.
class TraceCoder {
 public:
  explicit TraceCoder(bool payloads) : payloads_(payloads) {}
  void Write(const TraceEntry& entry, ByteWriter* out);
  TraceEntry Read(ByteReader* in);

  // Returns the number of a message's link.  A link is the path of all messages from one sender to
  // one entry of one receiver.  Links are numbered from 0 in the order in which this function is
  // first called for them.
  uint32_t LinkOf(const TraceRecord& record);

  // Writes a message as a TraceEntry of the kind kMessage.  `number_of_link` is the number of the
  // message's link.  REQUIRES: `number_of_link` is LinkOf(record); each link with a smaller number
  // is the link of a message that was written before.
  void WriteMessage(const TraceRecord& record, std::string_view payload, uint32_t number_of_link,
                    ByteWriter* out);

 private:
  struct Link {
    int32_t sender = 0;
    int32_t target = 0;
    uint32_t selector = 0;
    // The last payload (content of a message) of this size from the same sender (an element of
    // last_); set only when writing.
    LastPayload* last = nullptr;
  };
  struct LinkKey {
    int32_t sender, target;
    uint32_t selector;
    bool operator==(const LinkKey&) const = default;
  };
  struct LinkHash {
    size_t operator()(const LinkKey& key) const {
      return (static_cast<uint64_t>(static_cast<uint32_t>(key.sender)) << 40 ^
              static_cast<uint64_t>(static_cast<uint32_t>(key.target)) << 20 ^ key.selector) *
             0x9e3779b97f4a7c15u;
    }
  };

  // Returns whether the last payload of the sender `sender` with the size `size` is kept already,
  // or whether it can be kept below the limit kKeptMax for the bytes of all kept payloads.
  bool HasRoomFor(int32_t sender, size_t size) const;
  // Forgets the last payloads of all senders.
  void Forget();
  // Returns the last payload of the sender `sender` with the size `size`.  Only bytes that differ
  // from the last payload are written.  This makes the file small, because an object's messages
  // often resemble each other.
  LastPayload& LastOf(int32_t sender, size_t size);
  void ReadMessage(bool is_old, ByteReader* in, TraceEntry* entry);
  void ReadLink(ByteReader* in, TraceRecord* record);
  void ReadPayload(bool in_pieces, ByteReader* in, TraceEntry* entry);

  const bool payloads_;
  uint64_t number_ = 0;
  int64_t time_us_ = 0;
  std::map<std::pair<int32_t, size_t>, LastPayload> last_;  // last payloads; key: sender and size
  uint64_t kept_ = 0;  // number of bytes of all payloads in last_
  std::vector<Link> links_;
  // The numbers of the links (paths from one sender to one entry of one receiver); used only for
  // writing.  Nothing depends on the order of the links in this map, so it is not sorted.
  std::unordered_map<LinkKey, uint32_t, LinkHash> link_numbers_;
  uint32_t defined_links_ = 0;  // number of links whose first message was written
};

class TraceWriter {
 public:
  // Creates the file `file` for a recording.  Throws std::runtime_error when the file cannot be
  // created, or when another process is writing to it.
  TraceWriter(const std::string& file, const TraceHeader& header);
  ~TraceWriter();
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  // Adds a delivered message.  Called for every message by a sink (callback) of the System's trace.
  void AddMessage(const System& system, const TraceRecord& record, const Message& message);
  void AddNetwork(int robot, std::vector<NetworkEvent> events);
  void AddLoss(const std::string& process, int64_t time_us);
  void AddEnded(const RunEnd& end);
  void AddInput(int robot, std::string_view line, int64_t time_us);
  // Adds the present content of a file or folder of the Memory Stick, which an object is about to
  // change.  A replay needs it to undo the change.  `path` is the path on the host, `name` the path
  // below the stick's folder.
  void AddStick(const std::string& name, const std::string& path);

  // Adds a part of another recording, such as the content that a file of the Memory Stick had
  // before a change.  REQUIRES: this recording also has the names of the objects and handlers in
  // `entry`.
  void AddEntry(const TraceEntry& entry) { Add(entry); }

  // Writes to the file what was added so far.  May be called in a signal handler that ends the
  // process.
  void Flush();

  // Adds the reason why the run ended and, as the end of the file, the hashes of the run's messages
  // and state, with which a replay compares its own hashes.  Then writes everything to the file.
  // Returns "", or the error that happened while the file was written.
  std::string Finish(System* system);

 private:
  // For one link, which is the path from one sender to one entry of one receiver: how often the
  // sender and the receiver had been replaced (Object::predecessors) when their names were last
  // written to the trace file; -1: there is no such object.  If a number has changed since then, an
  // object was replaced, and its names may have to be written again.
  struct ReplacementCounts {
    int sender = -2;
    int target = -2;
    bool operator==(const ReplacementCounts&) const = default;
  };

  void AddNames(const System& system, const TraceRecord& record);
  void Add(const TraceEntry& entry);
  void FlushIfFull();
  void WriteOut(std::string_view bytes);

  const std::string file_;
  const bool payloads_;
  TraceCoder coder_;
  int descriptor_ = -1;
  int error_ = 0;  // errno of the first write to the recording that failed
  ByteWriter block_;
  // For each object, by its id: how often it had been replaced (Object::predecessors) when its name
  // was written to the recording.  If it has been replaced again since then, its name is written
  // again.
  std::map<int32_t, int> objects_;
  std::set<std::pair<int32_t, uint32_t>> entries_;
  // For each link (the path from one sender to one entry of one receiver), by its number: how often
  // the objects at its two ends had been replaced when their names were last written.  AddMessage()
  // looks up names only when these numbers have changed: for the first message of the link, and
  // after an object was replaced.
  std::vector<ReplacementCounts> named_;
  std::string payload_copy_;
};

class TraceReader {
 public:
  // Opens the recording `file`, which is read block by block.  Throws std::runtime_error when the
  // file is no trace file or has a version that cannot be read.
  explicit TraceReader(const std::string& file);

  const TraceHeader& header() const { return header_; }

  // Returns what comes next in the recording, such as a message or an input, without taking it;
  // null at the end of the readable part of the file.
  const TraceEntry* Peek();
  // Takes what comes next in the recording and returns it.  Peek() then returns what comes after
  // that.  REQUIRES: Peek() is not null.
  TraceEntry Take();

  // Returns texts about damaged or missing parts of the file that have been found so far, such as
  // "FILE: block 3 at offset 4711: ...".
  const std::vector<std::string>& problems() const { return problems_; }

  // Returns "FILE: the recording does not say how the run ended: ..." if the file is not damaged
  // but does not have the end of the run, because the recorded process was killed or still runs.
  // Otherwise, and before the end of the file is reached, returns "".
  const std::string& note() const { return note_; }

  // Returns the name of the object `id`, or a text with the id if the name has not been read so
  // far.
  std::string ObjectName(int32_t id) const;
  std::string EntryName(int32_t id, uint32_t selector) const;
  int RobotOf(int32_t id) const;
  // Returns how the run ended, as a word of EndName() and a text with the reason.  Both are empty
  // if the recording does not say how the run ended, or if its end has not been read so far.
  const std::pair<std::string, std::string>& why_ended() const { return why_ended_; }
  // Returns an error that explains why no message matches a filter, such as "there is no object
  // 'JointMvoer'; did you mean ...".  Returns "" if the recording has the object and the service.
  // An empty name is no filter.  Called at the end of the file, when all names have been read.
  std::string NoMatchText(const std::string& object, const std::string& service) const;

 private:
  void ReadHeader();
  bool NextBlock();
  void Damaged(const std::string& what);
  std::string PlaceText() const;
  void StoreEntry(const TraceEntry& entry);

  const std::string file_;
  RecordingBytes bytes_;
  uint64_t at_ = 0;  // place of the next block in the file
  int block_count_ = 0;
  size_t block_size_ = 0;  // number of bytes in the last block that was read
  TraceHeader header_;
  std::optional<TraceCoder> coder_;
  std::optional<ByteReader> block_;
  std::optional<TraceEntry> next_;
  bool ended_ = false;
  TraceRecord last_{};  // record of the last message that was read
  std::pair<std::string, std::string> why_ended_;
  std::vector<std::string> problems_;
  std::string note_;
  // Robot and name of each object; the key is the id of the object.
  std::map<int32_t, std::pair<int, std::string>> objects_;
  std::map<std::pair<int32_t, uint32_t>, std::string> entries_;
};

}  // namespace openr_host
