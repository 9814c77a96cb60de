#include <fmt/format.h>
#include <zlib.h>

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/json_text.h"
#include "openr/data/mcap_writer.h"
#include "openr/data/table.h"

namespace openr_host {
namespace {

// Largest depth of nested JSON objects in a message of an MCAP file; messages of openr have depth
// 1.
constexpr int kLevelMax = 32;

// Thrown when a field of a record goes beyond the end of the MCAP file, because the file was cut
// off.
struct FileIsCut {};

// Reads the fields of a record of an MCAP file, one after the other.
class RecordFields {
 public:
  explicit RecordFields(std::string_view bytes) : bytes_(bytes) {}
  bool AtEnd() const { return at_ == bytes_.size(); }
  size_t at() const { return at_; }
  uint8_t U8() { return static_cast<uint8_t>(Number(1)); }
  uint16_t U16() { return static_cast<uint16_t>(Number(2)); }
  uint32_t U32() { return static_cast<uint32_t>(Number(4)); }
  uint64_t U64() { return Number(8); }
  std::string_view Text() { return ReadBytes(U32()); }
  std::string_view ReadBytes(uint64_t size) {
    if (bytes_.size() - at_ < size) throw FileIsCut();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::string_view Rest() { return ReadBytes(bytes_.size() - at_); }

 private:
  uint64_t Number(int size) {
    const std::string_view bytes = ReadBytes(static_cast<uint64_t>(size));
    uint64_t number = 0;
    for (int i = size - 1; i >= 0; --i)
      number = number << 8 | static_cast<uint8_t>(bytes[static_cast<size_t>(i)]);
    return number;
  }
  std::string_view bytes_;
  size_t at_ = 0;
};

// Returns the first part of the names of the quantities in a topic; the name of a member follows
// this part.  The part is "joint." for the topic "/aibo/joint", "robots[1].joint." for
// "/aibo1/joint", and "" for "/aibo/base".  For a topic of another program, it is the name of the
// topic and a dot.
std::string QuantityOfTopic(const std::string& topic) {
  const size_t slash = topic.find('/', 1);
  if (!topic.starts_with("/aibo") || slash == std::string::npos) return topic + ".";
  const std::string number = topic.substr(5, slash - 5), group = topic.substr(slash + 1);
  std::string name = number.empty() || number == "0" ? "" : "robots[" + number + "].";
  return group == "base" ? name : name + group + ".";
}

class McapReader {
 public:
  McapReader(const std::string& file, const OnBytesRead& on_read)
      : file_(file), on_read_(on_read) {}

  Table Read(std::string_view bytes) {
    if (!bytes.starts_with(kMcapMagic)) throw std::runtime_error(file_ + ": is no MCAP file");
    RecordFields fields(bytes.substr(kMcapMagic.size()));
    try {
      while (!is_over_) {
        ReadRecord(&fields);
        if (on_read_) on_read_(kMcapMagic.size() + fields.at());
      }
    } catch (const FileIsCut&) {
      table_.note = fmt::format(
          "{}: ends without a summary, because the program that wrote it was killed or still "
          "writes it; read up to byte {}",
          file_, good_ + kMcapMagic.size());
    }
    return std::move(table_);
  }

 private:
  void ReadRecord(RecordFields* fields) {
    good_ = depth_ == 0 ? fields->at() : good_;
    const auto op = static_cast<McapOp>(fields->U8());
    RecordFields record(fields->ReadBytes(fields->U64()));
    switch (op) {
      case McapOp::kSchema:
        return ReadSchema(&record);
      case McapOp::kChannel:
        return ReadChannel(&record);
      case McapOp::kMessage:
        return ReadMessage(&record);
      case McapOp::kChunk:
        return ReadChunk(&record);
      case McapOp::kDataEnd:
      case McapOp::kFooter:
        is_over_ = true;
        return;
      default:
        return;
    }
  }

  void ReadChunk(RecordFields* record) {
    if (depth_ > 0) Refuse("has a chunk within a chunk, which the format forbids");
    record->ReadBytes(8 + 8 + 8);  // skips the start time, end time and size of the chunk
    const uint32_t crc = record->U32();
    const std::string_view compression = record->Text();
    if (!compression.empty()) {
      throw std::runtime_error(fmt::format(
          "{}: is compressed with {}; decompress it first: mcap compress --compression none", file_,
          compression));
    }
    const std::string_view bytes = record->ReadBytes(record->U64());
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
    // Does not check a chunk with the checksum 0, which means that the chunk has no checksum (MCAP
    // specification).
    if (crc != 0 && crc32_z(0, data, bytes.size()) != crc) {
      throw std::runtime_error(
          fmt::format("{}: the chunk at byte {} is damaged: its checksum is wrong", file_,
                      good_ + kMcapMagic.size()));
    }
    RecordFields records(bytes);
    ++depth_;
    while (!records.AtEnd()) ReadRecord(&records);
    --depth_;
  }

  // Throws std::runtime_error with the name of the file, the position of the present MCAP record in
  // this file, and the text `why`.
  [[noreturn]] void Refuse(const std::string& why) const {
    throw std::runtime_error(
        fmt::format("{}: the record at byte {} {}", file_, good_ + kMcapMagic.size(), why));
  }

  [[noreturn]] void RefuseDepth() const {
    Refuse(fmt::format("has objects within objects, more than {} deep", kLevelMax));
  }

  void ReadSchema(RecordFields* record) {
    const uint16_t number = record->U16();
    schemas_[number] = record->Text();
  }

  void ReadChannel(RecordFields* record) {
    const uint16_t number = record->U16();
    const std::string schema = schemas_[record->U16()];
    const std::string topic(record->Text());
    // Skips the topics of texts, poses and pictures, because they have no numbers to draw.
    const bool is_skipped = record->Text() != "json" || schema.starts_with("foxglove.");
    topics_[number] = is_skipped ? "" : topic;
  }

  void ReadMessage(RecordFields* record) {
    const std::string& topic = topics_[record->U16()];
    record->ReadBytes(4);
    const double time_s = static_cast<double>(record->U64()) / 1e9;
    record->ReadBytes(8);
    if (topic.empty()) return;
    const std::string_view text = record->Rest();
    auto json = TryParseJson<nlohmann::json>(text);
    // Text that cannot be read may be JSON that is nested too deeply, so it is read again without
    // its JSON arrays.  The arrays are not needed, because AddMembers() takes numbers only from
    // JSON objects.  If JSON objects are nested too deeply, AddMembers() refuses the file.
    if (json.is_discarded()) json = ParseWithoutLists(text);
    if (json.is_object()) AddMembers(QuantityOfTopic(topic), time_s, json, 1);
  }

  // Adds the numbers of a JSON object, and of the objects inside it, to the table.  `level` is the
  // depth of the object in its message; a whole message has depth 1.
  void AddMembers(const std::string& name, double time_s, const nlohmann::json& json, int level) {
    if (level > kLevelMax) RefuseDepth();
    for (const auto& [key, value] : json.items()) {
      if (key == "timestamp") continue;
      if (value.is_object()) AddMembers(name + key + ".", time_s, value, level + 1);
      if (!value.is_number()) continue;
      const auto [found, is_new] = places_.emplace(name + key, table_.series.size());
      if (is_new) table_.series.push_back({name + key, {}, {}});
      table_.series[found->second].time_s.push_back(time_s);
      table_.series[found->second].values.push_back(value.get<double>());
    }
  }

  const std::string& file_;
  const OnBytesRead& on_read_;
  Table table_;
  std::map<std::string, size_t> places_;  // key: name of a quantity; value: index in table_.series
  std::map<uint16_t, std::string> schemas_, topics_;
  // Position in the file of the present MCAP record, counted from the end of kMcapMagic; error
  // messages need it.  For a record in a chunk, this is the position of the chunk.
  size_t good_ = 0;
  int depth_ = 0;  // 1 while the records of a chunk are read, else 0
  bool is_over_ = false;
};

}  // namespace

Table ReadMcapTable(const std::string& file, std::string_view bytes, const OnBytesRead& on_read) {
  return McapReader(file, on_read).Read(bytes);
}

}  // namespace openr_host
