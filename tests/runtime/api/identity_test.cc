// Tests of the small values that are ids: OID, RID, EventID, OServiceEntry, OMemoryLocator.
#include <EventID.h>
#include <OID.h>
#include <OPENR/OMemoryLocator.h>
#include <OPENR/OPENR.h>
#include <RID.h>
#include <gtest/gtest.h>

#include <sstream>

namespace {

OID Oid(size_t number) { return OID(reinterpret_cast<void*>(number)); }

TEST(OidTest, TheDefaultIsInvalid) {
  EXPECT_FALSE(OID().IsValid());
  EXPECT_TRUE(OID() == OID_UNDEF);
  EXPECT_TRUE(Oid(0x80000042).IsValid());
}

TEST(OidTest, OrderIsThatOfTheNumbers) {
  EXPECT_TRUE(Oid(1) < Oid(2));
  EXPECT_TRUE(Oid(2) >= Oid(2));
  EXPECT_TRUE(Oid(3) > Oid(2));
  EXPECT_TRUE(Oid(3) != Oid(2));
}

TEST(OidTest, MakeInvalidForgetsTheAddress) {
  OID oid = Oid(5);
  oid.MakeInvalid();
  EXPECT_TRUE(oid == OID());
}

TEST(ServiceEntryTest, NeedsObjectAndSelectorToBeValid) {
  EXPECT_FALSE(OServiceEntry().IsValid());
  EXPECT_FALSE(OServiceEntry(Oid(1), UNDEF).IsValid());
  EXPECT_FALSE(OServiceEntry(OID(), 4).IsValid());
  EXPECT_TRUE(OServiceEntry(Oid(1), 4).IsValid());
}

TEST(ServiceEntryTest, OrderIsByObjectThenSelector) {
  EXPECT_TRUE(OServiceEntry(Oid(1), 9) < OServiceEntry(Oid(2), 4));
  EXPECT_TRUE(OServiceEntry(Oid(1), 4) < OServiceEntry(Oid(1), 5));
  EXPECT_FALSE(OServiceEntry(Oid(1), 4) < OServiceEntry(Oid(1), 4));
  EXPECT_TRUE(OServiceEntry(Oid(1), 4) != OServiceEntry(Oid(1), 5));
}

TEST(ServiceEntryTest, SetAndMakeInvalidReplaceBoth) {
  OServiceEntry entry;
  entry.Set(Oid(3), 7);
  EXPECT_TRUE(entry == OServiceEntry(Oid(3), 7));
  entry.MakeInvalid();
  EXPECT_TRUE(entry == OServiceEntry());
}

TEST(RidTest, IsValidAsLongAsItsMailer) {
  RID rid(Oid(3), 12);
  EXPECT_TRUE(rid.IsValid());
  EXPECT_EQ(rid.GetValue(), 12u);
  EXPECT_TRUE(rid != RID(Oid(3), 13));
  rid.MakeInvalid();
  EXPECT_TRUE(rid == RID());
  EXPECT_FALSE(rid.IsValid());
}

TEST(RidTest, MailerAndValueCanBeReadAsPlainData) {
  const RID rid(Oid(3), 12);
  const BaseTID& plain = rid;
  EXPECT_EQ(plain.mailer.address, Oid(3).GetAddress());
  EXPECT_EQ(plain.value, 12u);
}

TEST(EventIdTest, TheDefaultIsInvalidAndAValueMakesItValid) {
  EventID event;
  EXPECT_FALSE(event.IsValid());
  event.SetValue(7);
  EXPECT_TRUE(event.IsValid());
  EXPECT_EQ(event.GetValue(), 7u);
  EXPECT_EQ(event.value, 7u);
  EXPECT_TRUE(event == EventID(7));
  EXPECT_TRUE(event != EventID(8));
  event.MakeInvalid();
  EXPECT_TRUE(event == EventID());
}

TEST(MemoryLocatorTest, TheDefaultIsInvalid) {
  EXPECT_TRUE(OMemoryLocator().IsInvalid());
  EXPECT_FALSE(OMemoryLocator(0, 0).IsInvalid());
}

TEST(MemoryLocatorTest, OrderIsByRegionThenOffset) {
  EXPECT_TRUE(OMemoryLocator(1, 9) < OMemoryLocator(2, 0));
  EXPECT_TRUE(OMemoryLocator(1, 0) < OMemoryLocator(1, 9));
  EXPECT_TRUE(OMemoryLocator(1, 9) == OMemoryLocator(1, 9));
}

TEST(MemoryLocatorTest, StreamsRegionAndOffset) {
  std::ostringstream out;
  out << OMemoryLocator(3, 192);
  EXPECT_EQ(out.str(), "(mid:3,offset:192)");
}

}  // namespace
