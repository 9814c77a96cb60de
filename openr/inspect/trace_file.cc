#include "openr/inspect/trace_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cli/growing_file.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "openr/decode/decode_message.h"
#include "openr/simulation/assemble_robot.h"
#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/base/read_file.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "OPENRTRC";
constexpr size_t kBlockBytes = 64 << 10;
// Number of bytes before the content of a block of a recording: those of its size and of its
// checksum.
constexpr size_t kBlockHead = 4 + 8;

std::string HeaderText(const TraceHeader& h) {
  Json json = {{"program", h.program},
               {"stick", h.stick},
               {"stick_hash", h.stick_hash},
               {"robot", h.robot},
               {"body", h.body},
               {"world", h.world},
               {"cost", h.cost},
               {"robots", h.robots},
               {"seed", h.seed},
               {"microphone", h.microphone},
               {"images", h.images},
               {"strict", h.strict},
               {"battery", h.battery},
               {"payloads", h.payloads}};
  if (!h.schedule.empty()) json["schedule"] = ParseJson<Json>(h.schedule);
  if (h.write_protected) json["write_protected"] = true;
  if (h.is_free) json["free_running"] = true;
  if (!h.addresses.empty()) json["ip"] = h.addresses;
  if (h.together) json["together"] = true;
  if (!h.more_sticks.empty()) {
    json["more_sticks"] = h.more_sticks;
    json["more_stick_hashes"] = h.more_stick_hashes;
  }
  return JsonText(json);
}

TraceHeader HeaderOf(std::string_view text) {
  const auto json = ParseJson<Json>(text);
  CheckFractions(json, Fractions::kNone);
  TraceHeader h;
  json.at("program").get_to(h.program);
  json.at("stick").get_to(h.stick);
  json.at("stick_hash").get_to(h.stick_hash);
  json.at("robot").get_to(h.robot);
  json.at("body").get_to(h.body);
  json.at("world").get_to(h.world);
  json.at("cost").get_to(h.cost);
  json.at("robots").get_to(h.robots);
  json.at("seed").get_to(h.seed);
  json.at("microphone").get_to(h.microphone);
  // Uses the test pattern if the field "images" is "", because recordings with "" are older and
  // their cameras saw only the test pattern.
  json.at("images").get_to(h.images);
  if (h.images.empty()) h.images = kImagesOfPattern;
  json.at("strict").get_to(h.strict);
  json.at("payloads").get_to(h.payloads);
  // Uses "drain" if the field "battery" is missing, because older recordings do not have the field
  // and their runs had a battery that drains.
  h.battery = json.value("battery", "drain");
  if (json.contains("schedule")) h.schedule = JsonText(json["schedule"]);
  h.write_protected = json.value("write_protected", false);
  h.is_free = json.value("free_running", false);
  h.addresses = json.value("ip", h.addresses);
  h.together = json.value("together", false);
  h.more_sticks = json.value("more_sticks", h.more_sticks);
  h.more_stick_hashes = json.value("more_stick_hashes", h.more_stick_hashes);
  return h;
}

}  // namespace

TraceWriter::TraceWriter(const std::string& file, const TraceHeader& header)
    : file_(file), payloads_(header.payloads), coder_(header.payloads) {
  std::string problem;
  // Puts a new file in the place of an old recording, so that a process which is replaying the old
  // recording can go on reading it.
  descriptor_ = OpenNewGrowingFile(file, &problem);
  if (descriptor_ < 0) throw std::runtime_error(problem);
  ByteWriter head;
  head.U32(kTraceVersion);
  head.Text(HeaderText(header));
  WriteOut(kMagic);
  WriteOut(head.bytes());
}

TraceWriter::~TraceWriter() {
  Flush();
  if (descriptor_ >= 0) close(descriptor_);
}

void TraceWriter::WriteOut(std::string_view bytes) {
  // Writes nothing after an error, because a recording with a gap could not be read behind the gap.
  if (error_ == 0) error_ = WriteAll(descriptor_, bytes);
}

void TraceWriter::Flush() {
  if (block_.bytes().empty()) return;
  ByteWriter head;
  head.U32(static_cast<uint32_t>(block_.bytes().size()));
  head.U64(HashBytes(block_.bytes().data(), block_.bytes().size()));
  WriteOut(head.bytes());
  WriteOut(block_.bytes());
  block_.Clear();
}

void TraceWriter::Add(const TraceEntry& entry) {
  coder_.Write(entry, &block_);
  FlushIfFull();
}

void TraceWriter::FlushIfFull() {
  if (block_.bytes().size() >= kBlockBytes) Flush();
}

void TraceWriter::AddNames(const System& system, const TraceRecord& record) {
  for (const int32_t id : {record.sender, record.target}) {
    const Object* const object = system.object(id);
    if (object == nullptr) continue;
    const auto [known, is_new] = objects_.emplace(id, object->predecessors());
    if (!is_new && known->second == object->predecessors()) continue;
    known->second = object->predecessors();
    // Removes the entries of this object from `entries_`, which has the entries whose names are in
    // the file already.  An object that was loaded again may have other entries, so the names of
    // its entries must be written again.
    std::erase_if(entries_, [id](const auto& entry) { return entry.first == id; });
    TraceEntry entry;
    entry.kind = TraceEntry::Kind::kObject;
    entry.id = id;
    entry.robot = object->robot;
    entry.name = object->name;
    Add(entry);
  }
  if (!entries_.insert({record.target, record.selector}).second) return;
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kEntry;
  entry.id = record.target;
  entry.selector = record.selector;
  entry.name = system.object(record.target)->EntryName(record.selector);
  Add(entry);
}

void TraceWriter::AddMessage(const System& system, const TraceRecord& record,
                             const Message& message) {
  const auto count_of = [&system](int32_t id) {
    const Object* const object = system.object(id);
    return object == nullptr ? -1 : object->predecessors();
  };
  const uint32_t link = coder_.LinkOf(record);
  if (link >= named_.size()) named_.resize(link + 1);
  const ReplacementCounts counts{count_of(record.sender), count_of(record.target)};
  if (named_[link] != counts) {
    AddNames(system, record);
    named_[link] = counts;
  }
  coder_.WriteMessage(record, payloads_ ? ContentView(message, &payload_copy_) : std::string_view(),
                      link, &block_);
  FlushIfFull();
}

void TraceWriter::AddNetwork(int robot, std::vector<NetworkEvent> events) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kNetwork;
  entry.robot = robot;
  entry.events = std::move(events);
  Add(entry);
}

void TraceWriter::AddInput(int robot, std::string_view line, int64_t time_us) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kInput;
  entry.robot = robot;
  entry.name = line;
  entry.time_us = time_us;
  Add(entry);
}

void TraceWriter::AddLoss(const std::string& process, int64_t time_us) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kLoss;
  entry.name = process;
  entry.time_us = time_us;
  Add(entry);
}

void TraceWriter::AddStick(const std::string& name, const std::string& path) {
  namespace fs = std::filesystem;
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kStick;
  entry.name = name;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    entry.what = TraceEntry::PathKind::kFolder;
  } else if (fs::exists(path, error)) {
    entry.what = TraceEntry::PathKind::kFile;
    entry.payload = ReadFile(path).value_or("");
  }
  Add(entry);
}

void TraceWriter::AddEnded(const RunEnd& end) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kEnded;
  entry.name = EndName(end.kind);
  entry.payload = end.why;
  Add(entry);
}

std::string TraceWriter::Finish(System* system) {
  if (system->end()) AddEnded(*system->end());
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kEnd;
  entry.time_us = system->now_us();
  entry.trace_hash = system->trace_hash();
  entry.state_hash = system->state_hash();
  Add(entry);
  Flush();
  if (error_ == 0) return "";
  return fmt::format("{}: could not be written whole: {}", file_, std::strerror(error_));
}

TraceReader::TraceReader(const std::string& file) : file_(file), bytes_(file) {
  if (bytes_.size() == 0) throw std::runtime_error(fmt::format("{}: is empty", file));
  if (bytes_.Read(0, kMagic.size()) != kMagic)
    throw std::runtime_error(
        fmt::format("{}: is no recording (openr run --record makes them)", file));
  try {
    ReadHeader();
  } catch (const std::exception& e) {
    throw std::runtime_error(fmt::format("{}: header: {}", file, e.what()));
  }
  coder_.emplace(header_.payloads);
}

void TraceReader::ReadHeader() {
  // The largest number of bytes that the two fields after the file's magic bytes can take: the
  // version of the format, and the length of the header's text.
  constexpr uint64_t kLengthsMax = 4 + ByteWriter::kVarintBytesMax;
  ByteReader lengths(bytes_.Read(kMagic.size(), kLengthsMax));
  const uint32_t version = lengths.U32();
  if (version < kOldestTraceVersion || version > kTraceVersion) {
    throw std::runtime_error(
        fmt::format("has version {} of the format, this program reads {} to {}", version,
                    kOldestTraceVersion, kTraceVersion));
  }
  const uint64_t text_size = lengths.Varint();
  at_ = kMagic.size() + lengths.at();
  ByteReader text(bytes_.Read(at_, text_size));
  header_ = HeaderOf(text.Bytes(text_size));
  at_ += text_size;
}

// Returns the part of an error text that says where in the run the problem is.  This part names the
// last message read: "after message 500 (t=1.248000 s, Controller -> JointMover "...")".
std::string TraceReader::PlaceText() const {
  if (last_.number == 0) return "before the first message";
  return fmt::format("after message {} (t={:.6f} s, {} -> {} \"{}\")", last_.number,
                     static_cast<double>(last_.time_us) / 1e6, ObjectName(last_.sender),
                     ObjectName(last_.target), EntryName(last_.target, last_.selector));
}

void TraceReader::Damaged(const std::string& what) {
  problems_.push_back(fmt::format("{}: block {}, byte {} of the file, {}: {}", file_,
                                  block_count_ - 1, at_ - block_size_ + block_->at(), PlaceText(),
                                  what));
}

bool TraceReader::NextBlock() {
  if (at_ == bytes_.size()) {
    if (why_ended_.first.empty()) {
      note_ = fmt::format(
          "{}: the recording does not say how the run ended: its process was killed, or it still "
          "runs",
          file_);
    }
    return false;
  }
  const auto where = [&] {
    return fmt::format("{}: block {} at offset {}", file_, block_count_, at_);
  };
  const auto cut_off = [&] {
    problems_.push_back(where() +
                        (bytes_.error() == 0
                             ? ": is cut off"
                             : fmt::format(": cannot be read: {}", std::strerror(bytes_.error()))));
    return false;
  };
  const std::string_view head_bytes = bytes_.Read(at_, kBlockHead);
  if (head_bytes.size() < kBlockHead) return cut_off();
  ByteReader head(head_bytes);
  const size_t size = head.U32();
  const uint64_t checksum = head.U64();
  // Compares the size with the rest of the file before the block is read, because the size of a
  // damaged block may be any number.
  if (size > bytes_.size() - at_ - kBlockHead) return cut_off();
  const std::string_view block = bytes_.Read(at_ + kBlockHead, size);
  if (block.size() < size) return cut_off();
  if (HashBytes(block.data(), block.size()) != checksum)
    problems_.push_back(where() + fmt::format(": checksum of its {} bytes is wrong", size));
  block_.emplace(block);
  at_ += kBlockHead + size;
  block_size_ = size;
  ++block_count_;
  return true;
}

const TraceEntry* TraceReader::Peek() {
  if (next_) return &*next_;
  if (ended_) return nullptr;
  while (!block_ || block_->AtEnd()) {
    if (!NextBlock()) {
      ended_ = true;
      return nullptr;
    }
  }
  try {
    next_ = coder_->Read(&*block_);
  } catch (const std::exception& e) {
    Damaged(fmt::format("{}; what follows cannot be read", e.what()));
    ended_ = true;
    return nullptr;
  }
  StoreEntry(*next_);
  if (next_->kind == TraceEntry::Kind::kEnd) {
    ended_ = true;
    if (!block_->AtEnd() || at_ < bytes_.size()) Damaged("there are bytes after the end");
  }
  return &*next_;
}

TraceEntry TraceReader::Take() {
  ASSERT(Peek() != nullptr);
  TraceEntry entry = std::move(next_.value());
  next_.reset();
  return entry;
}

void TraceReader::StoreEntry(const TraceEntry& entry) {
  if (entry.kind == TraceEntry::Kind::kMessage) last_ = entry.record;
  if (entry.kind == TraceEntry::Kind::kEnded) why_ended_ = {entry.name, entry.payload};
  if (entry.kind == TraceEntry::Kind::kObject) objects_[entry.id] = {entry.robot, entry.name};
  if (entry.kind == TraceEntry::Kind::kEntry) entries_[{entry.id, entry.selector}] = entry.name;
}

std::string TraceReader::ObjectName(int32_t id) const {
  if (id == kNoObject) return "(system)";
  const auto found = objects_.find(id);
  return found == objects_.end() ? fmt::format("object {}", id) : found->second.second;
}

int TraceReader::RobotOf(int32_t id) const {
  const auto found = objects_.find(id);
  return found == objects_.end() ? 0 : found->second.first;
}

std::string TraceReader::NoMatchText(const std::string& object, const std::string& service) const {
  std::vector<std::string> known;
  bool has_service = service.empty();
  for (const auto& [id, named] : objects_) known.push_back(named.second);
  for (const auto& [id, name] : entries_)
    has_service = has_service || name.find(service) != std::string::npos;
  if (!object.empty() && std::find(known.begin(), known.end(), object) == known.end())
    return fmt::format("there is no object '{}'{}; there are: {}", object,
                       DidYouMean(object, known), fmt::join(known, ", "));
  return has_service ? "" : fmt::format("no entry has '{}' in its name", service);
}

std::string TraceReader::EntryName(int32_t id, uint32_t selector) const {
  const auto found = entries_.find({id, selector});
  return found == entries_.end() ? fmt::format("selector {}", selector) : found->second;
}

}  // namespace openr_host
