#include "kit/check_layouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <string>

#include "kit/source_text.h"
#include "kit/struct_layout.h"
#include "kit/text_files.h"
#include "runtime/config/service_name.h"
#include "runtime/config/stub_config.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The text of the sources and headers of an object without comments.
struct ObjectCode {
  std::string all;      // sources and headers
  std::string sources;  // sources only, because a header also names members that nobody uses
};

ObjectCode CodeOf(const ObjectFolder& object, const ObjectParts& parts) {
  ObjectCode code;
  for (const fs::path& file : parts.CodeOf(object)) {
    const std::string text = WithoutComments(parts.TextOf(file)) + "\n";
    code.all += text;
    if (IsSourceName(file)) code.sources += text;
  }
  return code;
}

bool Matches(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}

// Returns whether the object passes a whole struct `type` to SetData(), the function that sends
// data: a variable of this type, or a region of its size.
bool Sends(const ObjectCode& code, const std::string& type) {
  const std::string size_of_type = "sizeof\\s*\\(?\\s*" + type + "\\b";
  if (Matches(code.sources, "\\b(SetData|RCRegion)\\s*\\(" + kPartOfStatement + size_of_type))
    return true;
  static const std::regex kCall(
      "\\bSetData\\s*\\(\\s*&\\s*(\\w+)\\s*,\\s*sizeof\\s*\\(?\\s*\\1\\b");
  for (std::sregex_iterator it(code.sources.begin(), code.sources.end(), kCall), end; it != end;
       ++it) {
    if (Matches(code.all, "\\b" + type + "\\s+" + (*it)[1].str() + "\\s*[;=(,]")) return true;
  }
  return false;
}

// Returns whether the object uses received data as a struct `type`: (const Line*)event.Data(0).
bool Receives(const ObjectCode& code, const std::string& type) {
  return Matches(code.sources, "\\b" + type + "\\b\\s*(const\\s*)?\\*" + kPartOfStatement +
                                   "\\b(Data|Base)\\s*\\(");
}

bool AsksForSize(const ObjectCode& code) {
  return Matches(code.sources, "(->|\\.)\\s*Size\\s*\\(");
}

// An end of a connection: the object, its code, and the layout of the sent struct in the object's
// image.
struct End {
  std::string object;  // name of the object's folder
  const ObjectCode& code;
  const StructLayout& layout;
};

const StructLayout::Member* FindMember(const StructLayout& layout, const std::string& name) {
  const auto found =
      std::find_if(layout.members.begin(), layout.members.end(),
                   [&name](const StructLayout::Member& member) { return member.name == name; });
  return found == layout.members.end() ? nullptr : &*found;
}

// Compares how two objects lay out a struct.  Returns a text for the user about the first
// difference that makes `receiver` read other data than `sender` has sent; "" if there is none.
std::string DifferenceOf(const End& sender, const End& receiver) {
  for (const StructLayout::Member& received : receiver.layout.members) {
    // Skips a member that no source of the receiver names, because nothing reads it.
    if (!HasWord(receiver.code.sources, received.name)) continue;
    const StructLayout::Member* const sent = FindMember(sender.layout, received.name);
    if (sent == nullptr) {
      const bool is_behind = received.begin >= sender.layout.bytes;
      // Only the receiver's struct has this member.  The member is reported only if it begins
      // behind the end of the sent data.  It is not reported if the receiver asks for the size of
      // the data, because the receiver may then read the member only if it was sent.
      if (!is_behind || received.bytes == 0 || AsksForSize(receiver.code)) continue;
      return fmt::format("{} reads '{}' at byte {}, and {} sends {} bytes", receiver.object,
                         received.name, received.begin, sender.object, sender.layout.bytes);
    }
    // Skips a member that no source of the sender names, because nothing sets it.
    if (!HasWord(sender.code.sources, received.name)) continue;
    if (sent->begin != received.begin) {
      return fmt::format("'{}' begins at byte {} in {}, at byte {} in {}", received.name,
                         sent->begin, sender.object, received.begin, receiver.object);
    }
    const bool is_variable = sent->is_array && received.is_array &&
                             received == receiver.layout.members.back() &&
                             *sent == sender.layout.members.back();
    if (sent->bytes != received.bytes && !is_variable) {
      return fmt::format("'{}' has {} bytes in {}, {} in {}", received.name, sent->bytes,
                         sender.object, received.bytes, receiver.object);
    }
  }
  return "";
}

// The size from which a member that is an array gets a note.  The compiler of the first SDKs
// crashed at a member of 2 MB (field-notes.md, 3.9).
constexpr uint64_t kLargeMemberBytes = 2'000'000;

// Adds a note about each member of the object's class that is an array of kLargeMemberBytes or
// more.
void NoteLargeMembers(const BuiltObject& object, Remarks* remarks) {
  const std::string& name = object.folder->class_name;
  const auto layout = name.empty() ? std::nullopt : LayoutIn(object.image, name);
  if (!layout) return;
  for (const StructLayout::Member& member : layout->members) {
    if (!member.is_array || member.bytes < kLargeMemberBytes) continue;
    remarks->Note(object.folder->folder,
                  fmt::format("'{}' in class {} has {} bytes: the compiler of the first SDKs "
                              "crashed at such a member (field-notes.md 3.9); make the array with "
                              "new",
                              member.name, name, member.bytes));
  }
}

class LayoutCheck {
 public:
  LayoutCheck(const StickImages& images, const ObjectParts& parts, Remarks* remarks)
      : parts_(parts), remarks_(remarks) {
    for (const BuiltObject& object : images.built) {
      const fs::path& file = object.folder->stub;
      const StubConfig stub = ParseStubConfig(file, ReadText(file).value_or("")).config;
      for (const auto* side : {&stub.subjects, &stub.observers}) {
        for (const StubService& service : *side) owners_.emplace(Compose(service.name), &object);
      }
    }
  }

  void Check(const ConnectRecord& record) {
    const std::string& type = record.subject.data;
    const bool is_identifier = std::all_of(type.begin(), type.end(), &IsWordCharacter);
    if (record.observer.data != type || !is_identifier) return;
    const BuiltObject* const subject = OwnerOf(record.subject);
    const BuiltObject* const observer = OwnerOf(record.observer);
    if (subject == nullptr || observer == nullptr || subject == observer) return;
    const ObjectCode& sending = CodeOfObject(*subject->folder);
    const ObjectCode& receiving = CodeOfObject(*observer->folder);
    // Looks first for the name of the struct as a word, because that is fast and the regular
    // expressions of Sends() and Receives() are slow.
    if (!HasWord(sending.all, type) || !HasWord(receiving.sources, type)) return;
    if (!Sends(sending, type) || !Receives(receiving, type)) return;
    const auto sent = LayoutIn(subject->image, type), received = LayoutIn(observer->image, type);
    if (!sent || !received) return;
    NoteWideMember(record, *sent);
    if (*sent == *received) return;
    const std::string difference =
        DifferenceOf({subject->folder->folder.filename(), sending, *sent},
                     {observer->folder->folder.filename(), receiving, *received});
    if (difference.empty()) return;
    remarks_->AddConsequence(
        Remark::Kind::kWarning, record.observer_place, "layout " + type,
        fmt::format("'{}' is not the same struct in both images: {}; include one header in both "
                    "objects, and build both",
                    type, difference));
  }

 private:
  // Adds a note about the first member of the struct that has different sizes on the host and on
  // the robot.
  void NoteWideMember(const ConnectRecord& record, const StructLayout& layout) const {
    const auto wide =
        std::find_if(layout.members.begin(), layout.members.end(),
                     [](const StructLayout::Member& member) { return !member.wide_type.empty(); });
    if (wide == layout.members.end()) return;
    const std::string& type = record.subject.data;
    const bool is_pointer = wide->wide_type == kWidePointer;
    remarks_->AddConsequence(
        Remark::Kind::kNote, record.subject_place, "width " + type,
        fmt::format("'{}' has another size here than on the robot: in '{}', {} has 8 bytes instead "
                    "of 4; sizes written as numbers do not fit{}",
                    type, wide->name, wide->wide_type,
                    is_pointer ? "" : ", and longword has 4 bytes on both"));
  }

  // Returns the built object that declares the service `name`; null if no built object declares the
  // service, or if several do.
  const BuiltObject* OwnerOf(const ServiceName& name) const {
    const auto [begin, end] = owners_.equal_range(Compose(name));
    return begin != end && std::next(begin) == end ? begin->second : nullptr;
  }

  const ObjectCode& CodeOfObject(const ObjectFolder& object) {
    const auto known = codes_.find(&object);
    return known != codes_.end() ? known->second
                                 : codes_.emplace(&object, CodeOf(object, parts_)).first->second;
  }

  std::multimap<std::string, const BuiltObject*> owners_;  // key: full name of a service
  std::map<const ObjectFolder*, ObjectCode> codes_;
  const ObjectParts& parts_;
  Remarks* const remarks_;
};

}  // namespace

void CheckLayouts(const ConnectConfig& wires, const StickImages& images, const ObjectParts& parts,
                  Remarks* remarks) {
  LayoutCheck check(images, parts, remarks);
  for (const ConnectRecord& record : wires.connections) check.Check(record);
  for (const BuiltObject& object : images.built) NoteLargeMembers(object, remarks);
}

}  // namespace openr_host
