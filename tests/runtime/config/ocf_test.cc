#include "runtime/config/ocf.h"

#include <gtest/gtest.h>

namespace openr_host::ocf_test {
namespace {

OcfResult Parse(std::string_view text) { return ParseOcf("mover.ocf", text); }

std::string ErrorIn(std::string_view text) {
  const OcfResult result = Parse(text);
  EXPECT_FALSE(result.ocf.has_value());
  return result.diagnostics.empty() ? "" : Render(result.diagnostics[0]);
}

std::string WarningIn(std::string_view text) {
  const OcfResult result = Parse(text);
  EXPECT_TRUE(result.ocf.has_value());
  return result.diagnostics.empty() ? "" : Render(result.diagnostics[0]);
}

TEST(OcfTest, ShortFormIsRead) {
  const OcfResult result = Parse("object jointMover 3072 16384 144 nocache notlb kernel\n");
  ASSERT_TRUE(result.ocf.has_value());
  EXPECT_EQ(result.ocf->name, "jointMover");
  EXPECT_EQ(result.ocf->module, "jointMover");
  EXPECT_EQ(result.ocf->metaspace, "mCOOP");
  EXPECT_EQ(result.ocf->stack_bytes, 3072);
  EXPECT_EQ(result.ocf->heap_bytes, 16384);
  EXPECT_EQ(result.ocf->priority, 144);
  EXPECT_FALSE(result.ocf->is_cached);
  EXPECT_FALSE(result.ocf->is_translated);
  EXPECT_FALSE(result.ocf->is_user_mode);
  EXPECT_TRUE(result.diagnostics.empty());
}

TEST(OcfTest, LongFormIsRead) {
  const OcfResult result = Parse("object a m mCOOP pic pid none 4k 16K none -1 128 cache tlb user");
  ASSERT_TRUE(result.ocf.has_value());
  EXPECT_EQ(result.ocf->name, "a");
  EXPECT_EQ(result.ocf->module, "m");
  EXPECT_EQ(result.ocf->stack_bytes, 4096);
  EXPECT_EQ(result.ocf->heap_bytes, 16384);
  EXPECT_EQ(result.ocf->install_selector, "-1");
  EXPECT_EQ(result.ocf->priority, 128);
  EXPECT_TRUE(result.ocf->is_user_mode);
}

TEST(OcfTest, RecordMaySpanLinesWithCommentsAnywhere) {
  const OcfResult result =
      Parse("# mover\r\nobject a # name\r\n3072 16384\r\n#object b\r\n128 cache tlb user#end");
  ASSERT_TRUE(result.ocf.has_value());
  EXPECT_EQ(result.ocf->place.line, 2);
  EXPECT_EQ(result.ocf->place.column, 8);
}

TEST(OcfTest, EmptyFileGetsAnExample) {
  EXPECT_EQ(ErrorIn("# nothing\n"),
            "mover.ocf: no description; write: object NAME 3072 16384 128 cache tlb user");
}

TEST(OcfTest, FirstWordMustBeObject) {
  EXPECT_EQ(ErrorIn("Object a 3072 16384 128 cache tlb user\n"),
            "mover.ocf:1: the first word is 'Object', must be 'object'; did you mean 'object'?\n"
            "Object a 3072 16384 128 cache tlb user\n"
            "^");
}

TEST(OcfTest, WrongNumberOfFieldsIsRefused) {
  EXPECT_EQ(ErrorIn("object a 3072 16384 128 cache tlb\n"),
            "mover.ocf:1: 6 fields after 'object', must be 7 (NAME STACK HEAP PRIORITY CACHE TLB "
            "MODE) or 14 (long form)\n"
            "object a 3072 16384 128 cache tlb\n"
            "^");
}

TEST(OcfTest, SizeThatIsNoNumberIsRefused) {
  EXPECT_EQ(ErrorIn("object a 3072b 16384 128 cache tlb user\n"),
            "mover.ocf:1: stack size '3072b' is not a number of bytes above 0, such as 3072 or "
            "16K\n"
            "object a 3072b 16384 128 cache tlb user\n"
            "         ^");
  for (const char* size : {"0", "-1", "k", "99999999999999999999", "2097153K", "0x100"}) {
    SCOPED_TRACE(size);
    ErrorIn(std::string("object a 3072 ") + size + " 128 cache tlb user\n");
  }
}

TEST(OcfTest, PriorityHasEightBits) {
  EXPECT_EQ(Parse("object a 3072 16384 0 cache tlb user").ocf->priority, 0);
  EXPECT_EQ(Parse("object a 3072 16384 255 cache tlb user").ocf->priority, 255);
  EXPECT_EQ(ErrorIn("object a 3072 16384 256 cache tlb user\n"),
            "mover.ocf:1: priority '256' is not a number from 0 to 255; 128 is the usual one\n"
            "object a 3072 16384 256 cache tlb user\n"
            "                    ^");
}

TEST(OcfTest, ModeIsUserOrKernel) {
  EXPECT_EQ(ErrorIn("object a 3072 16384 128 cache tlb usr\n"),
            "mover.ocf:1: mode is 'usr', must be 'user' or 'kernel'; did you mean 'user'?\n"
            "object a 3072 16384 128 cache tlb usr\n"
            "                                  ^");
}

TEST(OcfTest, AllWrongFieldsAreReported) {
  EXPECT_EQ(Parse("object a x x x cache x x").diagnostics.size(), 5u);
}

TEST(OcfTest, OverlongNameIsRefused) {
  const auto with_name = [](int size) {
    return "object " + std::string(size, 'n') + " 3072 16384 128 cache tlb user";
  };
  EXPECT_TRUE(Parse(with_name(63)).ocf.has_value());
  EXPECT_EQ(ErrorIn(with_name(64)), "mover.ocf:1: object name of 64 characters, the limit is 63\n" +
                                        with_name(64) + "\n       ^");
}

TEST(OcfTest, NameOutsideAsciiIsRefused) {
  EXPECT_EQ(ErrorIn("object d\xc3\xb6g 3072 16384 128 cache tlb user\n"),
            "mover.ocf:1: object name with a character that is not plain ASCII\n"
            "object d\xc3\xb6g 3072 16384 128 cache tlb user\n"
            "       ^");
}

TEST(OcfTest, KnownSlipInTheHeapSizeIsAWarning) {
  EXPECT_EQ(WarningIn("object a 3072 16386 128 cache tlb user\n"),
            "mover.ocf:1: warning: heap step of 16386 bytes; did you mean 16384?\n"
            "object a 3072 16386 128 cache tlb user\n"
            "              ^");
  EXPECT_NE(WarningIn("object a a mCOOP pic pid none 3072 16386 none -1 128 cache tlb user"), "");
}

TEST(OcfTest, UnknownCacheWordCountsAsNocacheWithAWarning) {
  EXPECT_FALSE(Parse("object a 3072 16384 128 cashe tlb user").ocf->is_cached);
  EXPECT_EQ(WarningIn("object a 3072 16384 128 cashe tlb user\n"),
            "mover.ocf:1: warning: 'cashe' counts as 'nocache'; did you mean 'cache'?\n"
            "object a 3072 16384 128 cashe tlb user\n"
            "                        ^");
}

TEST(OcfTest, UserModeWithoutVirtualMemoryIsAWarning) {
  EXPECT_EQ(WarningIn("object a 3072 16384 128 cache notlb user\n"),
            "mover.ocf:1: warning: 'user' mode needs 'tlb' on a robot with memory protection\n"
            "object a 3072 16384 128 cache notlb user\n"
            "                              ^");
}

}  // namespace
}  // namespace openr_host::ocf_test
