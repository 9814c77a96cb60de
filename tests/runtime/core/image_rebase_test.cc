#include "runtime/core/image_rebase.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

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

TEST(ImageRebaseTest, NoBytesOfAFileLeadOutOfIt) {
  const std::string probe = Probe();
  for (size_t at = 0; at < 2048; ++at) {
    std::string bytes = probe;
    bytes[at] = static_cast<char>(~bytes[at]);
    RebaseImage(&bytes, 1 << 20, kMost);  // AddressSanitizer is the judge
    EXPECT_EQ(bytes.size(), probe.size());
  }
}

}  // namespace
}  // namespace openr_host
