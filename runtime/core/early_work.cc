#include "runtime/core/early_work.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/cpu.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

std::vector<uint32_t> RegionsOf(const System& system, ObjectId owner) {
  std::vector<uint32_t> regions;
  system.regions().ForEachOf(
      owner, [&regions](uint32_t region, char*, size_t) { regions.push_back(region); });
  return regions;
}

// The names and services that the objects with one id have registered.
struct Registered {
  std::map<std::string, ObjectId> names;
  std::map<std::string, std::pair<ObjectId, uint32_t>> services;
};

// Moves the entries of `map` for which `matches` returns true to a new map, and returns it.
template <typename Map, typename Matches>
Map TakeEntries(Map* map, const Matches& matches) {
  Map taken;
  for (auto next = map->begin(); next != map->end();) {
    const auto entry = next++;
    if (matches(*entry)) taken.insert(map->extract(entry));
  }
  return taken;
}

Registered TakeRegistered(Robot* robot, ObjectId id) {
  return {
      TakeEntries(&robot->names, [id](const auto& entry) { return entry.second == id; }),
      TakeEntries(&robot->directory, [id](const auto& entry) { return entry.second.first == id; })};
}

void ReportTaken(const Object* object, const std::string& name) {
  object->system->AddFindingAbout(
      object, Severity::kError,
      fmt::format("a constructor has registered '{}', but another object has registered this name "
                  "before the object was in its place; that object keeps it",
                  name));
}

}  // namespace

EarlyWork CollectEarlyWork(Object* fresh, Object* old, const std::function<void()>& load) {
  System* const system = fresh->system;
  Robot& robot = system->robot(fresh->robot);
  const ObjectId id = fresh->id;
  const std::vector<uint32_t> old_regions = RegionsOf(*system, id);
  const uint32_t last_event = system->time_events().last_id();
  // Hides the names and services of the old object, because the new object registers the same
  // names.
  Registered of_old = TakeRegistered(&robot, id);
  // Makes both objects open reply boxes with different numbers.  Otherwise one object could get the
  // reply to a request of the other.
  fresh->boxes().set_last(old->boxes().last());
  // Makes the new object busy, so that the messages of its constructors stay in its outbox.
  fresh->delivery().set_busy(true);
  try {
    load();
  } catch (...) {
    // Gives the old object, which stays, its names and services back.
    TakeRegistered(&robot, id);
    robot.names.merge(of_old.names);
    robot.directory.merge(of_old.services);
    throw;
  }
  old->boxes().set_last(std::max(old->boxes().last(), fresh->boxes().last()));
  EarlyWork work;
  for (const uint32_t region : RegionsOf(*system, id)) {
    if (std::find(old_regions.begin(), old_regions.end(), region) != old_regions.end()) continue;
    system->regions().SetOwner(region, kNoObject);
    work.regions.push_back(region);
  }
  work.events = system->time_events().TakeNewerThan(last_event);
  const Registered of_fresh = TakeRegistered(&robot, id);
  for (const auto& [name, object] : of_fresh.names) work.names.push_back(name);
  for (const auto& [name, entry] : of_fresh.services)
    work.services.emplace_back(name, entry.second);
  robot.names.merge(of_old.names);
  robot.directory.merge(of_old.services);
  return work;
}

void RestoreEarlyWork(Object* fresh) {
  System* const system = fresh->system;
  Robot& robot = system->robot(fresh->robot);
  EarlyWork work = fresh->TakeEarlyWork();
  for (const uint32_t region : work.regions) system->regions().SetOwner(region, fresh->id);
  system->time_events().PutBack(std::move(work.events));
  for (const std::string& name : work.names) {
    if (!robot.names.emplace(name, fresh->id).second) ReportTaken(fresh, name);
  }
  for (const auto& [name, selector] : work.services) {
    if (!robot.directory.emplace(name, std::pair(fresh->id, selector)).second)
      ReportTaken(fresh, name);
  }
  fresh->delivery().set_busy(false);
  const CurrentScope scope(system, fresh);
  PostOutbox(fresh);
}

void DropEarlyWork(Object* fresh) {
  for (const uint32_t region : fresh->TakeEarlyWork().regions)
    fresh->system->regions().Delete(region);
}

}  // namespace openr_host
