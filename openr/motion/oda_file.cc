#include "openr/motion/oda_file.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "runtime/stick/gzip.h"

namespace openr_host {
namespace {

constexpr size_t kOdaHead = 64;    // number of bytes before the directory of the ODA container
constexpr size_t kOdaEntry = 144;  // number of bytes of a directory entry
constexpr size_t kOdaName = 128;   // number of bytes of the name in a directory entry
constexpr size_t kStemMax = 8;     // largest length of a file name without its extension

uint32_t U32At(std::string_view bytes, size_t at) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i)
    value |= static_cast<uint32_t>(static_cast<uint8_t>(bytes[at + i])) << 8 * i;
  return value;
}

[[noreturn]] void RefuseOda(size_t at, const std::string& why) {
  throw std::runtime_error(fmt::format("offset {}: {}", at, why));
}

// Returns the text in `padded` up to the first zero byte.
std::string TextOf(std::string_view padded) {
  return std::string(padded.substr(0, padded.find('\0')));
}

std::string ExtensionOf(const OdaMember& member) {
  if (IsGzip(std::string(member.bytes.substr(0, 16)))) return "GZ";
  const struct {
    const char* type;
    const char* extension;
  } known[] = {{"OMTN", "MTN"}, {"WAVE", "WAV"}, {"MIDI", "MID"},
               {"LED", "LED"},  {"SYN", "SYN"},  {"OSND", "SND"}};
  for (const auto& kind : known) {
    if (member.type == kind.type) return kind.extension;
  }
  return "BIN";
}

// Returns `name` with only its letters, digits and underscores.  So it is valid on a Memory Stick,
// and cannot lead to another folder.
std::string StemOf(const std::string& name) {
  std::string stem;
  for (const char c : name.substr(0, kStemMax)) {
    const bool is_lower = c >= 'a' && c <= 'z';
    const bool is_good = is_lower || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    stem += is_lower ? static_cast<char>(c - 'a' + 'A') : is_good ? c : '_';
  }
  return stem.empty() ? "_" : stem;
}

// Returns a file name for a member of an ODA container, a name that is not in `taken`, and adds it
// to `taken`.  Puts a number at the end of the name if necessary.
std::string NewName(const OdaMember& member, std::set<std::string>* taken) {
  const std::string stem = StemOf(member.name), extension = ExtensionOf(member);
  std::string file = stem + "." + extension;
  for (int i = 2; !taken->insert(file).second; ++i) {
    const std::string number = fmt::format("{}", i);
    file = stem.substr(0, kStemMax - number.size()) + number + "." + extension;
  }
  return file;
}

OdaMember ReadEntry(std::string_view bytes, size_t at) {
  OdaMember member;
  member.type = TextOf(bytes.substr(at, 4));
  member.name = TextOf(bytes.substr(at + 4, kOdaName));
  const size_t begin = U32At(bytes, at + 4 + kOdaName), size = U32At(bytes, at + 8 + kOdaName);
  if (begin > bytes.size() || size > bytes.size() - begin) {
    RefuseOda(at + 4 + kOdaName, fmt::format("a member of {} bytes begins at {}, the file has {}",
                                             size, begin, bytes.size()));
  }
  member.bytes = bytes.substr(begin, size);
  return member;
}

}  // namespace

std::vector<OdaMember> ReadOda(std::string_view bytes) {
  if (IsGzip(std::string(bytes.substr(0, 16))))
    RefuseOda(0, "the file is compressed; unpack it with gunzip first");
  if (bytes.substr(0, 4) != "ODAR")
    RefuseOda(0, "a container begins with 'ODAR', this one does not");
  if (bytes.size() < kOdaHead)
    RefuseOda(0, fmt::format("the file has {} bytes, its head needs {}", bytes.size(), kOdaHead));
  const size_t count = U32At(bytes, 8), entry = U32At(bytes, 12);
  if (entry != kOdaEntry)
    RefuseOda(12, fmt::format("a directory entry has {} bytes, must be {}", entry, kOdaEntry));
  if (count > kOdaMembersMax)
    RefuseOda(8, fmt::format("{} members, at most {} are read", count, kOdaMembersMax));
  if (bytes.size() - kOdaHead < count * kOdaEntry) {
    RefuseOda(8, fmt::format("{} members need a directory of {} bytes, the file has {} left", count,
                             count * kOdaEntry, bytes.size() - kOdaHead));
  }
  std::vector<OdaMember> members;
  std::set<std::string> taken;
  size_t total = 0;
  for (size_t i = 0; i < count; ++i) {
    members.push_back(ReadEntry(bytes, kOdaHead + i * kOdaEntry));
    // Limits the sum of the sizes, because members whose bytes overlap in the file could make a
    // small ODA container fill a disk when they are saved.
    total += members.back().bytes.size();
    if (total > bytes.size()) {
      RefuseOda(kOdaHead + i * kOdaEntry,
                fmt::format("the members overlap: together they have more than the {} bytes of "
                            "the file",
                            bytes.size()));
    }
    members.back().file = NewName(members.back(), &taken);
  }
  return members;
}

}  // namespace openr_host
