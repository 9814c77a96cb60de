#include "openr/timeline/ctf_writer.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "cli/output_file.h"

namespace openr_host {
namespace {

constexpr size_t kCtfFlushBytes = 64 << 10;
constexpr uint32_t kCtfMagic = 0xc1fc1fc1;

// The description of a timeline's events in the language of the Common Trace Format (CTF).
// Integers are little-endian and not aligned.
constexpr char kCtfMetadata[] = R"(/* CTF 1.8 */
typealias integer { size = 8; align = 8; signed = false; } := uint8_t;
typealias integer { size = 32; align = 8; signed = false; } := uint32_t;
typealias integer { size = 64; align = 8; signed = false; } := uint64_t;
trace {
  major = 1;
  minor = 8;
  byte_order = le;
  packet.header := struct { uint32_t magic; uint32_t stream_id; };
};
env { tracer_name = "openr-host"; };
clock {
  name = virtual_time;
  description = "Virtual time since the boot";
  freq = 1000000000;
  offset = 0;
  absolute = false;
};
typealias integer {
  size = 64; align = 8; signed = false; map = clock.virtual_time.value;
} := time_t;
stream {
  id = 0;
  event.header := struct { uint8_t id; time_t timestamp; };
};
event {
  name = "handler_begin"; id = 0; stream_id = 0;
  fields := struct {
    uint64_t message; uint64_t cause; uint32_t robot; uint32_t bytes;
    string object; string entry; string from; string said;
  };
};
event {
  name = "handler_end"; id = 1; stream_id = 0;
  fields := struct {
    uint64_t message; uint64_t cost_ns; uint64_t wall_ns; uint32_t robot; string object;
  };
};
)";

class CtfFields {
 public:
  CtfFields& U8(uint64_t value) { return Number(value, 1); }
  CtfFields& U32(uint64_t value) { return Number(value, 4); }
  CtfFields& U64(uint64_t value) { return Number(value, 8); }
  // Appends a text to the fields of an event, and a byte 0, which ends the text.
  CtfFields& Text(const std::string& text) {
    // Leaves out what follows the first byte 0 of `text`, because a byte 0 ends a text in the file.
    bytes_ += text.c_str();
    bytes_ += '\0';
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  CtfFields& Number(uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
    return *this;
  }
  std::string bytes_;
};

uint64_t CtfTimeOf(double time_us) { return static_cast<uint64_t>(std::llround(time_us * 1e3)); }

}  // namespace

CtfWriter::CtfWriter(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(WriteErrorText(folder, error.value()));
  const std::string problem = WriteFile(folder + "/metadata", kCtfMetadata);
  if (!problem.empty()) throw std::runtime_error(problem);
  events_ = std::make_unique<GrowingFile>(folder + "/handlers");
  events_->Append(CtfFields().U32(kCtfMagic).U32(0).bytes());
}

void CtfWriter::AddSlice(const HandlerSlice& slice) {
  const uint64_t begin_ns = CtfTimeOf(slice.at_us), length_ns = CtfTimeOf(slice.length_us);
  WriteEndsUntil(begin_ns);
  const TraceRecord& record = slice.record;
  Add(CtfFields()
          .U8(0)
          .U64(begin_ns)
          .U64(record.number)
          .U64(record.cause)
          .U32(static_cast<uint64_t>(slice.robot))
          .U32(record.size)
          .Text(slice.object)
          .Text(slice.entry)
          .Text(slice.sender)
          .Text(slice.said)
          .bytes());
  const bool is_cost = slice.length == HandlerSlice::Length::kCost;
  const bool is_wall = slice.length == HandlerSlice::Length::kWall;
  ends_.push({begin_ns + length_ns, record.number,
              CtfFields()
                  .U8(1)
                  .U64(begin_ns + length_ns)
                  .U64(record.number)
                  .U64(is_cost ? length_ns : 0)
                  .U64(is_wall ? length_ns : 0)
                  .U32(static_cast<uint64_t>(slice.robot))
                  .Text(slice.object)
                  .bytes()});
}

// Writes to the file of the timeline the events "handler_end" of all handlers that ended at or
// before `time_ns`.  Called before an event "handler_begin" is written, because the events in the
// file are in order of time.
void CtfWriter::WriteEndsUntil(uint64_t time_ns) {
  for (; !ends_.empty() && ends_.top().time_ns <= time_ns; ends_.pop()) Add(ends_.top().bytes);
}

void CtfWriter::Add(const std::string& event) {
  bytes_ += event;
  if (bytes_.size() >= kCtfFlushBytes) Flush();
}

void CtfWriter::Flush() {
  events_->Append(bytes_);
  bytes_.clear();
}

void CtfWriter::Finish() {
  WriteEndsUntil(UINT64_MAX);
  Flush();
}

}  // namespace openr_host
