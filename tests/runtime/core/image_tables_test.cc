#include "runtime/core/image_tables.h"

#include <elf.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

std::string ProbeImage() { return ReadImageFile(std::string(OPENR_IMAGES) + "/PROBE.BIN").bytes; }

// Returns the offset in `image` of the first entry with `tag` in the dynamic section; 0: none.
uint64_t EntryOf(const std::string& image, int64_t tag) {
  Elf64_Ehdr header;
  std::memcpy(&header, image.data(), sizeof header);
  for (uint64_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment;
    std::memcpy(&segment, image.data() + header.e_phoff + i * sizeof segment, sizeof segment);
    if (segment.p_type != PT_DYNAMIC) continue;
    for (uint64_t at = 0; at < segment.p_filesz; at += sizeof(Elf64_Dyn)) {
      Elf64_Dyn entry;
      std::memcpy(&entry, image.data() + segment.p_offset + at, sizeof entry);
      if (entry.d_tag == tag) return segment.p_offset + at;
    }
  }
  return 0;
}

uint64_t ValueOf(const std::string& image, int64_t tag) {
  const uint64_t entry = EntryOf(image, tag);
  Elf64_Dyn value{};
  if (entry != 0) std::memcpy(&value, image.data() + entry, sizeof value);
  return value.d_un.d_val;
}

// Returns what is damaged after the value of `tag` was set to `value`; "none" without such a tag.
std::string DamageWith(int64_t tag, uint64_t value) {
  std::string image = ProbeImage();
  const uint64_t entry = EntryOf(image, tag);
  if (entry == 0) return "none";
  std::memcpy(image.data() + entry + sizeof tag, &value, sizeof value);
  return DamagedTableIn(image);
}

constexpr uint64_t kNowhere = uint64_t{1} << 40;

TEST(ImageTablesTest, AnImageAsTheLinkerWroteItIsSound) {
  EXPECT_EQ(DamagedTableIn(ProbeImage()), "");
}

// A transfer as text inserts such a byte.
TEST(ImageTablesTest, AnInsertedByteDamagesATable) {
  const std::string probe = ProbeImage();
  for (const size_t part : {3, 4, 5}) {
    std::string image = probe;
    image.insert(image.size() / part, 1, '\n');
    EXPECT_NE(DamagedTableIn(image), "") << part;
  }
}

TEST(ImageTablesTest, AnAddressOutsideOfTheImageIsFound) {
  EXPECT_EQ(DamageWith(DT_STRTAB, kNowhere), "the table of names");
  EXPECT_EQ(DamageWith(DT_NEEDED, kNowhere), "the table of names");
  EXPECT_EQ(DamageWith(DT_SYMTAB, kNowhere), "the table of symbols");
  EXPECT_EQ(DamageWith(DT_RELA, kNowhere), "the table of relocations");
  EXPECT_EQ(DamageWith(DT_JMPREL, kNowhere), "the table of relocations");
  EXPECT_EQ(DamageWith(DT_VERNEED, kNowhere), "the table of versions");
  EXPECT_EQ(DamageWith(DT_INIT, kNowhere), "the table of constructors");
  EXPECT_EQ(DamageWith(DT_INIT_ARRAY, kNowhere), "the table of constructors");
}

TEST(ImageTablesTest, ASizeBeyondTheEndIsFound) {
  EXPECT_EQ(DamageWith(DT_STRSZ, kNowhere), "the table of names");
  EXPECT_EQ(DamageWith(DT_RELASZ, 24 * 1'000'000), "the table of relocations");
  EXPECT_EQ(DamageWith(DT_INIT_ARRAYSZ, kNowhere), "the table of constructors");
  EXPECT_EQ(DamageWith(DT_VERNEEDNUM, 1'000), "the table of versions");
}

// The dynamic linker ends the process if fewer relocations have this type than the count says.
TEST(ImageTablesTest, ACountOfRelocationsThatIsTooLargeIsFound) {
  EXPECT_EQ(DamageWith(DT_RELACOUNT, 1'000'000), "the table of relocations");
}

TEST(ImageTablesTest, AnEntrySizeOfAnotherFormatIsFound) {
  EXPECT_EQ(DamageWith(DT_SYMENT, 16), "the dynamic section");
  EXPECT_EQ(DamageWith(DT_RELAENT, 16), "the dynamic section");
}

TEST(ImageTablesTest, ARelocationOfReadOnlyMemoryIsFound) {
  std::string image = ProbeImage();
  // Tables before the first page that is written to lie at their addresses in the file.
  const uint64_t relocation = ValueOf(image, DT_RELA);
  const uint64_t beginning = 0;
  std::memcpy(image.data() + relocation, &beginning, sizeof beginning);
  EXPECT_EQ(DamagedTableIn(image), "the table of relocations");
}

// Linkers leave such entries for code that was left out.
TEST(ImageTablesTest, ARelocationThatDoesNothingMayNameAnyPlace) {
  std::string image = ProbeImage();
  const uint64_t relocation = ValueOf(image, DT_JMPREL);
  std::memset(image.data() + relocation, 0, sizeof(Elf64_Rela));
  EXPECT_EQ(DamagedTableIn(image), "");
}

TEST(ImageTablesTest, WithTextRelocationsReadOnlyMemoryMayBeRelocated) {
  std::string image = ProbeImage();
  const uint64_t beginning = 0;
  std::memcpy(image.data() + ValueOf(image, DT_JMPREL), &beginning, sizeof beginning);
  ASSERT_EQ(DamagedTableIn(image), "the table of relocations");
  const int64_t text_relocations =
      DT_TEXTREL;  // in place of the count, which images can do without
  std::memcpy(image.data() + EntryOf(image, DT_RELACOUNT), &text_relocations,
              sizeof text_relocations);
  EXPECT_EQ(DamagedTableIn(image), "");
}

TEST(ImageTablesTest, AnImageWithADamagedTableIsRefusedWithTheReason) {
  std::string image = ProbeImage();
  image.insert(image.size() / 3, 1, '\n');
  EXPECT_TRUE(CheckImage(image).problem.starts_with("is damaged: the "))
      << CheckImage(image).problem;
}

TEST(ImageTablesTest, NoBytesOfAFileLeadOutOfIt) {
  const std::string probe = ProbeImage();
  const uint64_t dynamic = EntryOf(probe, DT_NEEDED);
  for (size_t i = 0; i < 4096; ++i) {
    std::string image = probe;
    const size_t at = i < 3072 ? i : dynamic + i - 3072;
    image[at] = static_cast<char>(~image[at]);
    static_cast<void>(CheckImage(image));  // AddressSanitizer is the judge
  }
}

}  // namespace
}  // namespace openr_host
