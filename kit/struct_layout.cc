#include "kit/struct_layout.h"

#include <dwarf.h>
#include <elfutils/libdw.h>

#include <memory>

#include "kit/text_files.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

using OpenElf = std::unique_ptr<Elf, decltype(&elf_end)>;
using OpenDwarf = std::unique_ptr<Dwarf, decltype(&dwarf_end)>;

// Returns the entry of the type of `die`, an entry of the debug information (DWARF); nullopt if
// `die` has no type.
std::optional<Dwarf_Die> DeclaredTypeOf(Dwarf_Die* die) {
  Dwarf_Attribute attribute;
  Dwarf_Die type;
  if (dwarf_formref_die(dwarf_attr(die, DW_AT_type, &attribute), &type) == nullptr)
    return std::nullopt;
  return type;
}

// Returns the entry of the type of `die`, without typedefs, const and volatile; nullopt if `die`,
// an entry of the debug information, has no type.
std::optional<Dwarf_Die> TypeOf(Dwarf_Die* die) {
  std::optional<Dwarf_Die> type = DeclaredTypeOf(die);
  Dwarf_Die peeled;
  if (!type || dwarf_peel_type(&*type, &peeled) != 0) return std::nullopt;
  return peeled;
}

std::optional<uint64_t> NumberOf(Dwarf_Die* die, unsigned attribute_name) {
  Dwarf_Attribute attribute;
  Dwarf_Word value = 0;
  if (dwarf_formudata(dwarf_attr(die, attribute_name, &attribute), &value) != 0)
    return std::nullopt;
  return value;
}

bool IsStruct(Dwarf_Die* die) {
  return dwarf_tag(die) == DW_TAG_structure_type || dwarf_tag(die) == DW_TAG_class_type;
}

std::string NameOf(Dwarf_Die* die) {
  const char* const name = dwarf_diename(die);
  return name == nullptr ? "" : name;
}

std::string WideTypeIn(Dwarf_Die* structure);

// Returns the name of the type in `member` that has 8 bytes on the host and 4 on the robot
// (StructLayout::Member::wide_type); "" if the member has no such type.
std::string WideTypeOf(Dwarf_Die* member) {
  std::string shown;  // the outermost typedef, by which the user knows the type
  Dwarf_Die die = *member;
  while (const std::optional<Dwarf_Die> next = DeclaredTypeOf(&die)) {
    die = *next;
    const std::string name = NameOf(&die);
    switch (dwarf_tag(&die)) {
      case DW_TAG_pointer_type:
        return NumberOf(&die, DW_AT_byte_size) == uint64_t{8} ? kWidePointer : "";
      case DW_TAG_structure_type:
      case DW_TAG_class_type:
        return WideTypeIn(&die);
      case DW_TAG_base_type:
        if (name != "long int" && name != "long unsigned int") return "";
        if (NumberOf(&die, DW_AT_byte_size) != uint64_t{8}) return "";
        return shown.empty() ? name : shown;
      case DW_TAG_typedef:
        // Does not count a type such as int64_t, which is `long` on the host, because such a type
        // has 8 bytes on the robot, too.
        if (name.find("64") != std::string::npos) return "";
        if (shown.empty()) shown = name;
        break;
      default:  // goes on with the type after const or volatile, or of the array's elements
        break;
    }
  }
  return "";
}

// Returns the name of the first type in a struct that has 8 bytes on the host and 4 on the robot;
// "" if the struct has no such type.  Leaves out the hidden pointer to the table of virtual
// functions, because no source names this pointer.
std::string WideTypeIn(Dwarf_Die* structure) {
  Dwarf_Die child;
  for (int end = dwarf_child(structure, &child); end == 0; end = dwarf_siblingof(&child, &child)) {
    if (dwarf_tag(&child) != DW_TAG_member || dwarf_hasattr(&child, DW_AT_artificial) != 0 ||
        dwarf_hasattr(&child, DW_AT_data_member_location) == 0)
      continue;
    if (std::string type = WideTypeOf(&child); !type.empty()) return type;
  }
  return "";
}

std::optional<StructLayout::Member> MemberOf(Dwarf_Die* die) {
  const char* const name = dwarf_diename(die);
  const std::optional<uint64_t> begin = NumberOf(die, DW_AT_data_member_location);
  // Leaves out bit fields, because they have no size in whole bytes.
  const bool is_bit_field = dwarf_hasattr(die, DW_AT_bit_size) != 0;
  if (dwarf_tag(die) != DW_TAG_member || name == nullptr || !begin || is_bit_field)
    return std::nullopt;
  std::optional<Dwarf_Die> type = TypeOf(die);
  if (!type) return std::nullopt;
  Dwarf_Word bytes = 0;
  if (dwarf_aggregate_size(&*type, &bytes) != 0) bytes = 0;
  const bool is_array = dwarf_tag(&*type) == DW_TAG_array_type;
  const bool is_hidden = dwarf_hasattr(die, DW_AT_artificial) != 0;
  return StructLayout::Member{name, *begin, bytes, is_array, is_hidden ? "" : WideTypeOf(die)};
}

// Returns the layout of the struct whose entry in the debug information is `die`.  Returns nullopt
// if the entry only declares the struct.
std::optional<StructLayout> LayoutOf(Dwarf_Die* die) {
  const std::optional<uint64_t> bytes = NumberOf(die, DW_AT_byte_size);
  if (!bytes || dwarf_hasattr(die, DW_AT_declaration) != 0) return std::nullopt;
  StructLayout layout{*bytes, {}};
  Dwarf_Die child;
  for (int end = dwarf_child(die, &child); end == 0; end = dwarf_siblingof(&child, &child)) {
    if (const auto member = MemberOf(&child)) layout.members.push_back(*member);
  }
  return layout;
}

// Adds to `layouts` each layout of the type `name` in the debug information `dwarf`.  There can be
// several layouts, because each source of the image may have another definition of the type.
void Collect(Dwarf* dwarf, const std::string& name, std::vector<StructLayout>* layouts) {
  Dwarf_CU* unit = nullptr;
  Dwarf_Die root, child;
  while (dwarf_get_units(dwarf, unit, &unit, nullptr, nullptr, &root, nullptr) == 0) {
    for (int end = dwarf_child(&root, &child); end == 0; end = dwarf_siblingof(&child, &child)) {
      const char* const child_name = dwarf_diename(&child);
      if (child_name == nullptr || child_name != name) continue;
      std::optional<Dwarf_Die> type;
      if (IsStruct(&child)) type = child;
      if (dwarf_tag(&child) == DW_TAG_typedef) type = TypeOf(&child);
      if (!type || !IsStruct(&*type)) continue;
      if (const auto layout = LayoutOf(&*type)) layouts->push_back(*layout);
    }
  }
}

// Returns all layouts of the type `name` in `bytes`, an ELF file; none if the file has no debug
// information.
std::vector<StructLayout> LayoutsIn(std::string bytes, const std::string& name) {
  std::vector<StructLayout> layouts;
  elf_version(EV_CURRENT);
  const OpenElf elf(elf_memory(bytes.data(), bytes.size()), &elf_end);
  if (elf == nullptr) return layouts;
  const OpenDwarf dwarf(dwarf_begin_elf(elf.get(), DWARF_C_READ, nullptr), &dwarf_end);
  if (dwarf != nullptr) Collect(dwarf.get(), name, &layouts);
  return layouts;
}

}  // namespace

std::optional<StructLayout> LayoutIn(const fs::path& image, const std::string& name) {
  const ImageFile file = ReadImageFile(image);
  if (!file.problem.empty()) return std::nullopt;
  std::vector<StructLayout> layouts = LayoutsIn(file.bytes, name);
  const fs::path beside = FindEntry(image.parent_path(), image.stem().string() + ".DBG");
  if (layouts.empty() && !beside.empty()) layouts = LayoutsIn(ReadText(beside).value_or(""), name);
  for (const StructLayout& layout : layouts) {
    // Returns nullopt if sources of the image define the type with different layouts, because
    // nothing shows which layout is meant.
    if (layout != layouts.front()) return std::nullopt;
  }
  if (layouts.empty()) return std::nullopt;
  return layouts.front();
}

}  // namespace openr_host
