// All orders of small graphs, counted by hand.
#include <gtest/gtest.h>

#include "tests/planted/planted.h"

namespace openr_host {
namespace {

// Counts the messages it gets; tells `next`, if any, of each.
class Node : public Actor {
 public:
  Node() {
    entry = AddExtra("Entry", [this](void*) {
      ++count_;
      if (next != nullptr) Post(next->host().id, next->entry);
    });
  }
  const Node* next = nullptr;
  Selector entry;

 private:
  int count_ = 0;
};

// Sends one message to each of its targets at one instant, after the start.
class Source : public Actor {
 public:
  explicit Source(std::vector<Node*> targets) : targets_(std::move(targets)) {
    begin_ = AddExtra("Begin", [this](void*) {
      for (const Node* target : targets_) Post(target->host().id, target->entry);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, begin_, 10'000);
    return oSUCCESS;
  }

 private:
  const std::vector<Node*> targets_;
  Selector begin_;
};

// `count` nodes that are told at once; all of them tell one collector if `collect`.
ExplorePlan StarPlan(int count, bool collect, bool reduce) {
  const auto build = [count, collect](System* system) {
    std::vector<Node*> nodes;
    for (int i = 0; i < count; ++i) {
      nodes.push_back(system->AddObject<Node>(0, "node" + std::to_string(i)));
    }
    Node* const collector = system->AddObject<Node>(0, "collector");
    if (collect) {
      for (Node* node : nodes) node->next = collector;
    }
    system->AddObject<Source>(0, "source", nodes);
  };
  ExplorePlan plan = PlanOf(SceneOf(build));
  plan.run.for_us = 50'000;
  plan.runs = 100'000;
  plan.reduce = reduce;
  return plan;
}

int64_t Factorial(int n) { return n <= 1 ? 1 : n * Factorial(n - 1); }

// Returns the number of orders in which `nodes` + 2 objects can be started.
int64_t Starts(int nodes) { return Factorial(nodes + 2); }

TEST(SearchTest, ReceiversThatTouchNothingInCommonHaveOneOrder) {
  const Json reduced = SearchOrders(StarPlan(2, false, true));
  EXPECT_EQ(reduced["orders"], Starts(2));
  EXPECT_TRUE(reduced["complete"]);
  EXPECT_EQ(reduced["covered"], 1.0);
  const Json all = SearchOrders(StarPlan(2, false, false));
  EXPECT_EQ(all["orders"], Starts(2) * Factorial(2));
  EXPECT_EQ(all["cut"], 0);
}

TEST(SearchTest, ReceiversThatTellTheSameOneHaveAllOrders) {
  EXPECT_EQ(SearchOrders(StarPlan(2, true, true))["orders"], Starts(2) * Factorial(2));
}

// Three objects send to a collector: only the 3! orders in its queue count.
TEST(SearchTest, OnlyTheOrderInTheCommonQueueCounts) {
  const Json result = SearchOrders(StarPlan(3, true, true));
  EXPECT_EQ(result["orders"], Starts(3) * Factorial(3));
  EXPECT_GT(result["cut"], 0);
}

// Notes who comes in which order.
class Guestbook : public Actor {
 public:
  Guestbook() {
    for (int guest = 0; guest < 3; ++guest) {
      entries.push_back(AddExtra("Guest", [this, guest](void*) {
        page_ += static_cast<char>('0' + guest);
        Say(page_);
      }));
    }
  }
  std::vector<Selector> entries;

 private:
  std::string page_;
};

// Passes on what it gets, the first one by way of another.
class Guest : public Actor {
 public:
  Guest() {
    entry = AddExtra("Go", [this](void*) { Post(to, to_entry); });
  }
  Selector entry;
  ObjectId to = kNoObject;
  Selector to_entry = 0;
};

class Host : public Actor {
 public:
  explicit Host(std::vector<Guest*> guests) : guests_(std::move(guests)) {
    begin_ = AddExtra("Begin", [this](void*) {
      for (const Guest* guest : guests_) Post(guest->host().id, guest->entry);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, begin_, 10'000);
    return oSUCCESS;
  }

 private:
  const std::vector<Guest*> guests_;
  Selector begin_;
};

// Every outcome that is possible is still reached when the search leaves equal orders out.
TEST(SearchTest, EveryOutcomeIsReachedWithReduction) {
  const auto build = [](System* system) {
    auto* const book = system->AddObject<Guestbook>(0, "book");
    std::vector<Guest*> guests;
    for (int i = 0; i < 3; ++i) {
      guests.push_back(system->AddObject<Guest>(0, "guest" + std::to_string(i)));
      guests[static_cast<size_t>(i)]->to = book->host().id;
      guests[static_cast<size_t>(i)]->to_entry = book->entries[static_cast<size_t>(i)];
    }
    auto* const detour = system->AddObject<Guest>(0, "detour");
    detour->to = book->host().id;
    detour->to_entry = book->entries[0];
    guests[0]->to = detour->host().id;
    guests[0]->to_entry = detour->entry;
    system->AddObject<Host>(0, "host", guests);
  };
  for (const char* page : {"012", "021", "102", "120", "201", "210"}) {
    ExplorePlan plan =
        PlanOf(SceneOf(build), {std::string("finally objects.book.state != ") + page});
    plan.run.for_us = 50'000;
    const Broken broken = InAllOrders(plan);
    EXPECT_NE(broken.property, "") << page;
    EXPECT_LT(broken.runs, 100u) << page;
  }
}

TEST(SearchTest, ABoundStopsItAndTheShareCoveredIsTold) {
  ExplorePlan plan = StarPlan(2, true, true);
  plan.runs = Starts(2);  // half of the orders
  const Json result = SearchOrders(plan);
  EXPECT_EQ(result["runs"], Starts(2));
  EXPECT_FALSE(result["complete"]);
  EXPECT_EQ(result["stopped"], "at the bound of 24 runs");
  // The first of four objects to start has not changed yet: at least 1 of 8 is done, not all.
  EXPECT_GT(result["covered"].get<double>(), 0.125);
  EXPECT_LT(result["covered"].get<double>(), 0.9);
}

}  // namespace
}  // namespace openr_host
