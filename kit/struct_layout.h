// Reads from the debug information of an image how its compiler has laid out a struct.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

// The value of StructLayout::Member::wide_type for a pointer.
inline constexpr char kWidePointer[] = "a pointer";

// The layout of a struct or class of a program.  Bit fields, static members and members without a
// name are left out.
struct StructLayout {
  struct Member {
    std::string name;
    uint64_t begin = 0;  // first byte of the member, counted from the beginning of the struct
    uint64_t bytes = 0;  // size of the member; 0 for an array without a length
    bool is_array = false;
    // A type in this member that has 8 bytes on the host and 4 on the robot (field-notes.md, 12.4),
    // such as "long int", "size_t" or "a pointer"; "" if the member has no such type.
    std::string wide_type;
    bool operator==(const Member&) const = default;
  };
  uint64_t bytes = 0;
  std::vector<Member> members;  // in the order of the declaration
  bool operator==(const StructLayout&) const = default;
};

// Returns the layout of the type `name` in the host image `image`, which may be compressed; its
// debug information may be in a .DBG file beside it.  The type is a struct, a class or a typedef
// for one of them, outside of namespaces and other types.  Returns nullopt if the debug information
// has no such type, or several with different layouts.
std::optional<StructLayout> LayoutIn(const std::filesystem::path& image, const std::string& name);

}  // namespace openr_host
