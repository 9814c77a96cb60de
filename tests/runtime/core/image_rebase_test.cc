#include "runtime/core/image_rebase.h"

#include <dlfcn.h>
#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "runtime/base/temp_folder.h"
#include "runtime/core/address_plan.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

constexpr uint64_t kMost = ObjectAddresses::kImageBytes;

std::string Probe() { return ReadImageFile(std::string(OPENR_IMAGES) + "/PROBE.BIN").bytes; }

TEST(ImageRebaseTest, AMovedImageIsLoadedWhereItWasMovedTo) {
  const ObjectAddresses place(0);
  if (place.image() == nullptr) GTEST_SKIP() << "sanitizers need these addresses";
  std::string bytes = Probe();
  ASSERT_TRUE(RebaseImage(&bytes, reinterpret_cast<uint64_t>(place.image()), kMost));
  const TempFolder folder;
  const std::string file = folder.path() + "/moved.so";
  std::ofstream(file, std::ios::binary) << bytes;
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(handle, nullptr) << dlerror();
  const auto* const table = static_cast<const char*>(dlsym(handle, "ObjectEntryTable"));
  EXPECT_GE(table, place.image());
  EXPECT_LT(table, place.image() + kMost);
  dlclose(handle);
}

TEST(ImageRebaseTest, WhatCannotBeMovedStaysAsItWas) {
  const std::string probe = Probe();
  const auto stays = [](const std::string& before, uint64_t size_max) {
    std::string bytes = before;
    return !RebaseImage(&bytes, 1 << 20, size_max) && bytes == before;
  };
  EXPECT_TRUE(stays("", kMost));
  EXPECT_TRUE(stays("no image at all, but a text that is longer than the header of one", kMost));
  EXPECT_TRUE(stays(probe, 4096));                  // larger than its place
  EXPECT_TRUE(stays(probe.substr(0, 500), kMost));  // cut off in the table of segments
  EXPECT_TRUE(stays(probe.substr(0, probe.size() / 2), kMost));
  std::string moved = probe;
  ASSERT_TRUE(RebaseImage(&moved, 1 << 20, kMost));
  EXPECT_TRUE(stays(moved, kMost));  // linked for an address already
}

// Returns the entry of the dynamic section of the image `bytes` that has the tag DT_FINI_ARRAYSZ.
Elf64_Dyn* DestructorBytesIn(std::string* bytes) {
  const auto* const header = reinterpret_cast<const Elf64_Ehdr*>(bytes->data());
  const auto* segment = reinterpret_cast<const Elf64_Phdr*>(bytes->data() + header->e_phoff);
  while (segment->p_type != PT_DYNAMIC) ++segment;
  auto* entry = reinterpret_cast<Elf64_Dyn*>(bytes->data() + segment->p_offset);
  while (entry->d_tag != DT_FINI_ARRAYSZ) ++entry;
  return entry;
}

TEST(ImageRebaseTest, FunctionsForTheEndAreDroppedUnlessTheyWriteCounts) {
  std::string bytes = Probe();
  if (bytes.find(".gcda") != std::string::npos) GTEST_SKIP() << "the images are built to count";
#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer adds such a function
  const std::string probe = bytes;
  DropDestructors(&bytes);
  EXPECT_TRUE(bytes == probe);  // has only the function of the compiler's start code
#endif
  DestructorBytesIn(&bytes)->d_un.d_val = 16;
  std::string counting = bytes + "/tmp/Probe.gcda";
  DropDestructors(&bytes);
  EXPECT_EQ(DestructorBytesIn(&bytes)->d_un.d_val, 0u);
  DropDestructors(&counting);
  EXPECT_EQ(DestructorBytesIn(&counting)->d_un.d_val, 16u);
}

TEST(ImageRebaseTest, NoBytesOfAFileLeadOutOfIt) {
  const std::string probe = Probe();
  for (size_t at = 0; at < 2048; ++at) {
    std::string bytes = probe;
    bytes[at] = static_cast<char>(~bytes[at]);
    RebaseImage(&bytes, 1 << 20, kMost);  // AddressSanitizer is the judge
    DropDestructors(&bytes);
    EXPECT_EQ(bytes.size(), probe.size());
  }
}

}  // namespace
}  // namespace openr_host
