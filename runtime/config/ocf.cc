#include "runtime/config/ocf.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "runtime/base/assert.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// Number of fields after the word "object" in the short form of an .ocf file.
constexpr size_t kShortFieldCount = 7;
constexpr size_t kLongFieldCount = 14;
// The largest size of a stack or heap in bytes, because the robot has 32 bits.
constexpr int64_t kSizeBytesMax = std::numeric_limits<int32_t>::max();
constexpr int kPriorityMax = 255;
// A heap size in Sony's samples, where it is a typing error for 16384.  Programs that were made
// from those samples may have this size too, so it gets a warning.
constexpr int64_t kMistypedHeapBytes = 16386;

struct Field {
  std::string text;
  FilePosition place;
};

// Returns all words of an .ocf file, without comments.
std::vector<Field> ReadFields(const std::string& file, std::string_view text,
                              std::vector<Diagnostic>* diagnostics) {
  std::vector<Field> fields;
  for (const FilePosition& line : SplitLines(file, text, diagnostics)) {
    const std::string_view content = std::string_view(line.text).substr(0, line.text.find('#'));
    for (const Word& word : SplitWords(content)) {
      fields.push_back({word.text, AtColumn(line, word.column)});
    }
  }
  return fields;
}

// Reads the words of an .ocf file one after the other and reports words that are wrong.
class FieldReader {
 public:
  FieldReader(const std::vector<Field>& fields, std::vector<Diagnostic>* diagnostics)
      : fields_(fields), diagnostics_(diagnostics) {}

  // Returns the next word of the .ocf file; a later ReadField() returns it again.  REQUIRES: not
  // all words are taken.
  const Field& Peek() const {
    ASSERT(next_ < fields_.size(), "field {} of {}", next_, fields_.size());
    return fields_[next_];
  }
  const Field& ReadField() {
    const Field& field = Peek();
    next_ += 1;
    return field;
  }

  void Error(const Field& field, std::string message) {
    diagnostics_->push_back(ErrorAt(field.place, std::move(message)));
  }
  void Warning(const Field& field, std::string message) {
    diagnostics_->push_back(WarningAt(field.place, std::move(message)));
  }

  bool is_at_end() const { return next_ == fields_.size(); }

  std::string ReadName();
  int64_t ReadSize(const char* what);
  int ReadPriority();
  // Reads the next field of the .ocf file.  Returns true if it is `yes`, false if it is `no`.  Any
  // other word is an error, whose message names the field `what`.
  bool ReadChoice(const char* what, const char* yes, const char* no);
  bool ReadCache();

 private:
  const std::vector<Field>& fields_;
  std::vector<Diagnostic>* const diagnostics_;
  size_t next_ = 1;  // index of the next field; field 0 is the word "object"
};

std::string FieldReader::ReadName() {
  const Field& field = ReadField();
  if (field.text.size() > static_cast<size_t>(kObjectNameBytesMax)) {
    Error(field, fmt::format("object name of {} characters, the limit is {}", field.text.size(),
                             kObjectNameBytesMax));
  }
  for (const char c : field.text) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f) continue;
    Error(field, "object name with a character that is not plain ASCII");
    break;
  }
  return field.text;
}

int64_t FieldReader::ReadSize(const char* what) {
  const Field& field = ReadField();
  std::string_view digits = field.text;
  int64_t unit = 1;
  if (digits.size() > 1 && (digits.back() == 'k' || digits.back() == 'K')) {
    digits.remove_suffix(1);
    unit = 1024;
  }
  int64_t value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_number = status == std::errc() && end == digits.data() + digits.size();
  if (!is_number || value <= 0 || value > kSizeBytesMax / unit) {
    Error(field, fmt::format("{} size '{}' is not a number of bytes above 0, such as 3072 or 16K",
                             what, field.text));
    return 0;
  }
  return value * unit;
}

int FieldReader::ReadPriority() {
  const Field& field = ReadField();
  int value = 0;
  const char* const last = field.text.data() + field.text.size();
  const auto [end, status] = std::from_chars(field.text.data(), last, value);
  if (status != std::errc() || end != last || value < 0 || value > kPriorityMax) {
    Error(field, fmt::format("priority '{}' is not a number from 0 to {}; 128 is the usual one",
                             field.text, kPriorityMax));
    return 0;
  }
  return value;
}

bool FieldReader::ReadChoice(const char* what, const char* yes, const char* no) {
  const Field& field = ReadField();
  if (field.text != yes && field.text != no) {
    Error(field, fmt::format("{} is '{}', must be '{}' or '{}'{}", what, field.text, yes, no,
                             DidYouMean(field.text, {yes, no})));
  }
  return field.text == yes;
}

// Reads the field of the .ocf file that must be "cache" or "nocache".  Any other word is taken for
// "nocache" and gets a warning, but no error, because gensnap, a tool of the SDK, silently takes it
// for "nocache", too.
bool FieldReader::ReadCache() {
  const Field& field = ReadField();
  if (field.text != "cache" && field.text != "nocache") {
    Warning(field, fmt::format("'{}' counts as 'nocache'{}", field.text,
                               DidYouMean(field.text, {"cache", "nocache"})));
  }
  return field.text == "cache";
}

// Reads the description of an object from `fields`, the words of an .ocf file.  REQUIRES: `fields`
// is the word "object" and the fields of the short or of the long form.
Ocf ReadOcf(const std::vector<Field>& fields, std::vector<Diagnostic>* diagnostics) {
  const bool is_long = fields.size() == kLongFieldCount + 1;
  FieldReader reader(fields, diagnostics);
  Ocf ocf;
  ocf.place = fields[1].place;
  ocf.name = reader.ReadName();
  ocf.module = ocf.name;
  if (is_long) {
    for (std::string* field :
         {&ocf.module, &ocf.metaspace, &ocf.pic, &ocf.pid, &ocf.heap_library}) {
      *field = reader.ReadField().text;
    }
  }
  ocf.stack_bytes = reader.ReadSize("stack");
  const Field& heap = reader.Peek();
  ocf.heap_bytes = reader.ReadSize("heap");
  if (ocf.heap_bytes == kMistypedHeapBytes) {
    reader.Warning(heap, "heap step of 16386 bytes; did you mean 16384?");
  }
  if (is_long) {
    ocf.same_space = reader.ReadField().text;
    ocf.install_selector = reader.ReadField().text;
  }
  ocf.priority = reader.ReadPriority();
  ocf.is_cached = reader.ReadCache();
  const Field& tlb = reader.Peek();
  ocf.is_translated = reader.ReadChoice("virtual memory", "tlb", "notlb");
  ocf.is_user_mode = reader.ReadChoice("mode", "user", "kernel");
  if (ocf.is_user_mode && tlb.text == "notlb") {
    reader.Warning(tlb, "'user' mode needs 'tlb' on a robot with memory protection");
  }
  ASSERT(reader.is_at_end());
  return ocf;
}

}  // namespace

OcfResult ParseOcf(const std::string& file, std::string_view text) {
  OcfResult result;
  const std::vector<Field> fields = ReadFields(file, text, &result.diagnostics);
  if (fields.empty()) {
    result.diagnostics.push_back(
        ErrorAt(FilePosition{file, 0, 0, ""},
                "no description; write: object NAME 3072 16384 128 cache tlb user"));
  } else if (fields[0].text != "object") {
    result.diagnostics.push_back(ErrorAt(
        fields[0].place, fmt::format("the first word is '{}', must be 'object'{}", fields[0].text,
                                     DidYouMean(fields[0].text, {"object"}))));
  } else if (fields.size() != kShortFieldCount + 1 && fields.size() != kLongFieldCount + 1) {
    result.diagnostics.push_back(ErrorAt(
        fields[0].place,
        fmt::format(
            "{} fields after 'object', must be {} (NAME STACK HEAP PRIORITY CACHE TLB MODE) "
            "or {} (long form)",
            fields.size() - 1, kShortFieldCount, kLongFieldCount)));
  } else {
    Ocf ocf = ReadOcf(fields, &result.diagnostics);
    if (!HasErrors(result.diagnostics)) result.ocf = std::move(ocf);
  }
  return result;
}

}  // namespace openr_host
