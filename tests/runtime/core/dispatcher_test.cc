// Order, waiting, limits: what the dispatcher promises.
#include "runtime/core/dispatcher.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "runtime/core/stalls.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

class DispatcherTest : public testing::Test {
 protected:
  DispatcherTest() { system.AddRobot("ERS-210", nullptr); }

  Recorder* Add(const std::string& name, int priority = 128) {
    Recorder* const object = system.AddObject<Recorder>(0, name, &log);
    object->host().set_priority(priority);
    return object;
  }
  int32_t Post(Recorder* target, int value, int64_t delay_us = 0,
               MessageClass message_class = MessageClass::kObject) {
    return PostTo(target, value, delay_us, message_class);
  }

  Log log;
  System system;
};

TEST_F(DispatcherTest, DueTimeComesFirst) {
  Recorder* a = Add("a");
  Post(a, 1, 20);
  Post(a, 2, 10);
  Post(a, 3);
  system.RunFor(100);
  EXPECT_EQ(log, (Log{"a:3@0", "a:2@10", "a:1@20"}));
  EXPECT_EQ(system.now_us(), 100);
}

TEST_F(DispatcherTest, ThenClassThenPriorityThenNumber) {
  Recorder* low = Add("low", 16);
  Recorder* high = Add("high", 144);
  Post(low, 1);
  Post(low, 2, 0, MessageClass::kVector);
  Post(high, 3);
  Post(low, 4, 0, MessageClass::kInput);
  Post(low, 5, 0, MessageClass::kFrame);
  Post(high, 6);
  system.RunFor(1);
  EXPECT_EQ(log, (Log{"low:5@0", "low:4@0", "low:2@0", "high:3@0", "high:6@0", "low:1@0"}));
}

TEST_F(DispatcherTest, TheSameOrderHoldsForMessagesThatWereDueLater) {
  Recorder* low = Add("low", 16);
  Recorder* high = Add("high", 144);
  Post(low, 1, 50);
  Post(high, 2, 50);
  Post(low, 3, 50, MessageClass::kFrame);
  system.RunFor(50);
  EXPECT_EQ(log, (Log{"low:3@50", "high:2@50", "low:1@50"}));
}

TEST_F(DispatcherTest, StepDeliversOneMessageAndSaysWhenThereIsNone) {
  Recorder* a = Add("a");
  Post(a, 1);
  Post(a, 2, 7);
  EXPECT_TRUE(system.Step());
  EXPECT_EQ(log, Log{"a:1@0"});
  EXPECT_TRUE(system.Step());
  EXPECT_EQ(system.now_us(), 7);
  EXPECT_FALSE(system.Step());
}

TEST_F(DispatcherTest, RunUntilAPredicateStopsAtOnceAndKeepsItsBudget) {
  Recorder* a = Add("a");
  for (int i = 1; i <= 5; ++i) Post(a, i, i * 10);
  EXPECT_TRUE(system.RunUntil([&] { return log.size() == 3; }, 1000));
  EXPECT_EQ(system.now_us(), 30);
  EXPECT_FALSE(system.RunUntil([] { return false; }, 1000));
  EXPECT_EQ(system.now_us(), 1030);
}

// Its table of entries is gone with its code, so the dispatcher must not use the table any more.
TEST_F(DispatcherTest, AnObjectWhoseConstructorHasThrownHasNoEntries) {
  struct Thrower : CodeObject {
    Thrower() {
      AddExtra("Extra", [](void*) {});
      throw std::runtime_error("no");
    }
  };
  EXPECT_THROW(system.AddObject<Thrower>(0, "thrower"), std::runtime_error);
  const Object* const object = system.object_table().Find(0, "thrower");
  ASSERT_NE(object, nullptr);
  EXPECT_EQ(FindCodeEntry(*object, oentryBASE), nullptr);
}

TEST_F(DispatcherTest, APredicateThatIsTrueAlreadyLetsNoMessageThrough) {
  Post(Add("a"), 1);
  EXPECT_TRUE(system.RunUntil([] { return true; }, 1000));
  EXPECT_EQ(log, Log{});
}

// Such code runs on the stack of a fiber, and no exception passes from one stack to another.
TEST_F(DispatcherTest, AnExceptionOutsideOfHandlersReachesTheCallerOfTheRun) {
  Recorder* a = Add("a");
  Post(a, 1);
  const auto fail = []() -> bool { throw std::runtime_error("no"); };
  EXPECT_THROW(system.RunUntil(fail, 1000), std::runtime_error);
  EXPECT_EQ(log, Log{});
  system.RunFor(1000);
  EXPECT_EQ(log, Log{"a:1@0"});
}

TEST_F(DispatcherTest, ACallWaitsForItsAnswerAndBlocksOnlyTheCaller) {
  Recorder* caller = Add("caller");
  Recorder* callee = Add("callee");
  Recorder* third = Add("third");
  ReplyTicket ticket;
  callee->on_message = [&](int) { ticket = system.requests().TakeTicket(); };
  caller->on_message = [&](int value) {
    if (value != 1) return;
    int answer = 0;
    const int question = 7;
    EXPECT_EQ(system.requests().Call(callee->host().id, callee->entry, &question, sizeof question,
                                     &answer, sizeof answer),
              sSUCCESS);
    log.push_back(fmt::format("answer {}@{}", answer, system.now_us()));
  };
  Post(caller, 1);
  Post(caller, 2);  // waits for its object
  Post(third, 3);
  system.RunFor(100);
  EXPECT_EQ(log, (Log{"caller:1@0", "third:3@0", "callee:7@0"}));
  EXPECT_EQ(DescribeWaits(system),
            (Log{"caller waits for the answer of callee (Entry) since t=0.000 s"}));
  const int answer = 42;
  RunAs(callee,
        [&] { EXPECT_EQ(system.requests().Reply(ticket, &answer, sizeof answer), sSUCCESS); });
  system.RunFor(100);
  EXPECT_EQ(log, (Log{"caller:1@0", "third:3@0", "callee:7@0", "answer 42@100", "caller:2@100"}));
}

TEST_F(DispatcherTest, CallsMayBeNestedOverSeveralObjects) {
  Recorder* a = Add("a");
  Recorder* b = Add("b");
  Recorder* c = Add("c");
  const auto ask = [&](Recorder* whom, int value) {
    int answer = 0;
    system.requests().Call(whom->host().id, whom->entry, &value, sizeof value, &answer,
                           sizeof answer);
    return answer;
  };
  const auto reply = [&](int value) {
    system.requests().Reply(system.requests().TakeTicket(), &value, sizeof value);
  };
  int result = 0;
  c->on_message = [&](int value) { reply(value * 10); };
  b->on_message = [&](int value) { reply(ask(c, value + 1) + 1); };
  a->on_message = [&](int value) { result = ask(b, value) + ask(c, value); };
  Post(a, 4);
  system.RunFor(1);
  EXPECT_EQ(result, 51 + 40);
}

TEST_F(DispatcherTest, ACallGivesUpAfterItsTimeout) {
  Recorder* caller = Add("caller");
  Recorder* silent = Add("silent");
  int32_t error = 0;
  caller->on_message = [&](int value) {
    error = system.requests().Call(silent->host().id, silent->entry, &value, sizeof value, nullptr,
                                   0, 500);
    log.push_back(fmt::format("gave up @{}", system.now_us()));
  };
  Post(caller, 1);
  system.RunFor(1000);
  EXPECT_EQ(error, sTIMEOUT);
  EXPECT_EQ(log.back(), "gave up @500");
}

TEST_F(DispatcherTest, ACallIgnoresItsTimeoutWhileTheCalleeWaitsForWallTime) {
  Recorder* caller = Add("caller");
  Recorder* callee = Add("callee");
  ReplyTicket ticket;
  callee->on_message = [&](int) { ticket = system.requests().TakeTicket(); };
  callee->host().wait().set_untimed(true);
  int32_t error = sFAIL;
  caller->on_message = [&](int value) {
    error = system.requests().Call(callee->host().id, callee->entry, &value, sizeof value, nullptr,
                                   0, 500);
    log.push_back(fmt::format("answer @{}", system.now_us()));
  };
  Post(caller, 1);
  system.RunFor(2000);
  EXPECT_EQ(log, (Log{"caller:1@0", "callee:1@0"}));
  RunAs(callee, [&] { system.requests().Reply(ticket, nullptr, 0); });
  system.RunFor(1);
  EXPECT_EQ(error, sSUCCESS);
  EXPECT_EQ(log.back(), "answer @2000");
}

// An object can have 32 events, so an event that can never come must not count.
TEST_F(DispatcherTest, AReplyEventEndsWithItsReplyBox) {
  Recorder* a = Add("a");
  RunAs(a, [&] {
    SystemCalls& calls = system.calls();
    const uint64_t closed = system.requests().OpenBox();
    const uint64_t open = system.requests().OpenBox();
    for (const uint64_t box : {closed, open})
      calls.AddReplyEvent({a->host().id, a->host().id, a->entry, {}}, box);
    calls.AddTimedEvent({a->host().id, a->host().id, a->entry, {}}, 1000, 0);
    EXPECT_EQ(calls.CountEvents(), 3);
    calls.CloseBox(closed);
    EXPECT_EQ(calls.CountEvents(), 2);
  });
}

TEST_F(DispatcherTest, TimeEventsThatWereTakenAwayAreDueAtTheEarliestWhenTheyAreBack) {
  Recorder* a = Add("a");
  const auto order = [&](int value, int64_t first_us) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(&value);
    const ObjectId id = a->host().id;
    system.time_events().AddTimed({id, id, a->entry, {bytes, bytes + sizeof value}}, first_us, 0);
  };
  order(1, 10);
  const uint32_t last = system.time_events().last_id();
  order(2, 20);
  order(3, 150);
  TimeEvents::Events taken = system.time_events().TakeNewerThan(last);
  system.RunFor(100);
  EXPECT_EQ(log, Log{"a:1@10"});
  system.time_events().PutBack(std::move(taken));
  system.RunFor(100);
  EXPECT_EQ(log, (Log{"a:1@10", "a:2@100", "a:3@150"}));
}

TEST_F(DispatcherTest, AReplyEventEndsWhenAHandlerThatWaitsReceivesTheReply) {
  Recorder* asker = Add("asker");
  Recorder* other = Add("other");
  const ObjectId id = asker->host().id;
  other->on_message = [&](int value) {
    system.requests().Reply(system.requests().TakeTicket(), &value, sizeof value);
  };
  asker->on_message = [&](int value) {
    OwnedMessage request = system.NewMessage(other->host().id, other->entry);
    std::memcpy(request->payload, &value, sizeof value);
    request->size = sizeof value;
    uint64_t box = 0;
    ASSERT_EQ(system.requests().Send(std::move(request), &box), sSUCCESS);
    system.calls().AddReplyEvent({id, id, asker->entry, {}}, box);
    EXPECT_EQ(system.calls().CountEvents(), 1);
    int reply = 0;
    system.requests().Wait(box, &reply, sizeof reply, nullptr, -1, "a reply");
    log.push_back(fmt::format("reply {}, {} events", reply, system.calls().CountEvents()));
  };
  Post(asker, 1);
  system.RunFor(100);
  EXPECT_EQ(log, (Log{"asker:1@0", "other:1@0", "reply 1, 0 events"}));
}

TEST_F(DispatcherTest, AHandlerCanBeAbandonedAndItsObjectGoesOn) {
  Recorder* a = Add("a");
  a->on_message = [&](int value) {
    if (value != 1) return;
    system.AbandonHandler();
    log.push_back("never");
  };
  for (int i = 1; i <= 3; ++i) Post(a, i);
  system.RunFor(1);
  EXPECT_EQ(log, (Log{"a:1@0", "a:2@0", "a:3@0"}));
}

TEST_F(DispatcherTest, AMessageThatIsNotQueuedGoesBackToThePool) {
  const void* first = nullptr;
  {
    const OwnedMessage message = system.NewMessage(kNoObject, 0);
    first = message.get();
  }
  EXPECT_EQ(system.NewMessage(kNoObject, 0).get(), first);
  EXPECT_EQ(system.Post(system.NewMessage(99, 0)), sINVALIDOID);
  EXPECT_EQ(system.NewMessage(kNoObject, 0).get(), first);
}

TEST_F(DispatcherTest, ExceptionsBelongToTheHandlerThatWaits) {
  Recorder* a = Add("a");
  Recorder* b = Add("b");
  b->on_message = [&](int value) {
    try {
      throw value;
    } catch (int caught) {
      system.requests().Reply(system.requests().TakeTicket(), &caught, sizeof caught);
    }
  };
  a->on_message = [&](int value) {
    try {
      throw std::runtime_error("kept");
    } catch (const std::runtime_error& e) {
      int answer = 0;
      system.requests().Call(b->host().id, b->entry, &value, sizeof value, &answer, sizeof answer);
      log.push_back(fmt::format("{} {}", e.what(), answer));
    }
  };
  Post(a, 5);
  system.RunFor(1);
  EXPECT_EQ(log.back(), "kept 5");
}

TEST_F(DispatcherTest, ObjectsThatAnswerEachOtherWithoutWaitingDoNotStopTheClock) {
  Recorder* a = Add("a");
  Recorder* b = Add("b");
  a->on_message = [&](int) { log.clear(), Post(b, 1); };
  b->on_message = [&](int) { log.clear(), Post(a, 1); };
  Post(a, 1);
  system.RunFor(1000);
  EXPECT_EQ(system.now_us(), 1000);
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("from here each message takes 1 us"),
            std::string::npos);
}

TEST_F(DispatcherTest, DeliveriesAtOneInstantAreCountedOverSeveralRuns) {
  System limited({.free_deliveries = 3});
  Recorder* a = limited.AddObject<Recorder>(0, "a", &log);
  a->on_message = [&](int) { PostTo(a, 1); };
  PostTo(a, 1);
  for (int i = 0; i < 6; ++i) limited.Step();
  EXPECT_EQ(log, (Log{"a:1@0", "a:1@0", "a:1@0", "a:1@0", "a:1@1", "a:1@2"}));
  EXPECT_EQ(limited.findings().all().size(), 1u);

  // A step of more than 1 us begins the count anew.
  a->on_message = nullptr;
  limited.RunFor(10);
  a->on_message = [&](int) { PostTo(a, 2); };
  PostTo(a, 2);
  log.clear();
  for (int i = 0; i < 5; ++i) limited.Step();
  EXPECT_EQ(log, (Log{"a:2@12", "a:2@12", "a:2@12", "a:2@12", "a:2@13"}));
}

TEST_F(DispatcherTest, AReplyDoesNotCountAsADeliveryAtOneInstant) {
  System limited({.free_deliveries = 4});
  Recorder* asks = limited.AddObject<Recorder>(0, "asks", &log);
  Recorder* answers = limited.AddObject<Recorder>(0, "answers", &log);
  answers->on_message = [&](int value) {
    limited.requests().Reply(limited.requests().TakeTicket(), &value, sizeof value);
  };
  asks->on_message = [&](int value) {
    if (value != 1) return;
    int answer = 0;
    limited.requests().Call(answers->host().id, answers->entry, &value, sizeof value, &answer,
                            sizeof answer);
    PostTo(asks, 2);
  };
  PostTo(asks, 1);
  limited.RunFor(0);
  EXPECT_EQ(log, (Log{"asks:1@0", "answers:1@0", "asks:2@0"}));
  EXPECT_TRUE(limited.findings().all().empty());
}

TEST_F(DispatcherTest, TheThirtyThirdWaitingMessageIsReportedAndRefusedWhenStrict) {
  Recorder* a = Add("a");
  for (int i = 0; i < 32; ++i) EXPECT_EQ(Post(a, i), sSUCCESS);
  EXPECT_TRUE(system.findings().all().empty());
  EXPECT_EQ(Post(a, 32), sSUCCESS);
  ASSERT_EQ(system.findings().all().size(), 1u);

  System strict({.strict = true});
  Log strict_log;
  Recorder* b = strict.AddObject<Recorder>(0, "b", &strict_log);
  int32_t last = sSUCCESS;
  for (int i = 0; i < 33; ++i) last = strict.Post(strict.NewMessage(b->host().id, b->entry));
  EXPECT_EQ(last, sFULLMSGQENTRY);
  strict.RunFor(1);
  EXPECT_EQ(strict_log.size(), 32u);
}

TEST_F(DispatcherTest, ASelectorWithoutEntryIsAFinding) {
  Recorder* a = Add("a");
  system.Post(system.NewMessage(a->host().id, 60));
  system.RunFor(1);
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("selector is out of range: sel=60"),
            std::string::npos);
}

TEST_F(DispatcherTest, HowARunIsSlicedDoesNotShowInItsHashes) {
  const auto run = [](int64_t slice_us) {
    Log log;
    System system({.seed = 3});
    Recorder* a = system.AddObject<Recorder>(0, "a", &log);
    Recorder* b = system.AddObject<Recorder>(0, "b", &log);
    const auto post = [&](Recorder* to, int value, int64_t delay_us) {
      OwnedMessage message = system.NewMessage(to->host().id, to->entry);
      std::memcpy(message->payload, &value, sizeof value);
      message->size = sizeof value;
      system.Post(std::move(message), delay_us);
    };
    a->on_message = [&](int value) { post(b, value + 1, 13); };
    b->on_message = [&](int value) { post(a, value * 2 % 1009, value % 7); };
    post(a, 1, 0);
    while (system.now_us() < 10'000) system.RunFor(slice_us);
    return std::pair(system.trace_hash(), system.state_hash());
  };
  const auto whole = run(10'000);
  EXPECT_EQ(run(10), whole);
  EXPECT_EQ(run(2'500), whole);
  EXPECT_EQ(run(1), whole);
}

}  // namespace
}  // namespace openr_host
