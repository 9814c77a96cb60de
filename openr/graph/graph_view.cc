#include "openr/graph/graph_view.h"

#include <nlohmann/json.hpp>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/post_as_object.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

std::vector<GraphService> ServicesOf(const Robot& robot, ObjectId id) {
  std::vector<GraphService> services;
  for (const auto& [name, entry] : robot.directory) {
    if (entry.first == id) services.push_back({name, name.ends_with(".S")});
  }
  return services;
}

// Returns the subject's record of the connection `wire`; null if the connection was not made.
const ObserverLink* FindLink(const System& system, const Connection& wire) {
  const Robot& robot = system.robot(wire.robot);
  const auto found = robot.directory.find(wire.subject);
  const auto observer = FindService(system, wire.robot, wire.observer, ServiceSide::kObserver);
  if (found == robot.directory.end() || !observer) return nullptr;
  const OServiceEntry observer_id(OidOf(observer->object), observer->selector);
  for (const auto& subject : system.object(found->second.first)->subjects()) {
    if (subject->service == wire.subject) return subject->Find(observer_id);
  }
  return nullptr;
}

}  // namespace

GraphView CollectGraph(System* system_pointer) {
  ASSERT(system_pointer->booted());
  System& system = *system_pointer;
  GraphView graph;
  graph.virtual_time_s = static_cast<double>(system.now_us()) / 1e6;
  for (const auto& object : system.objects()) {
    if (object->robot >= system.robot_count()) continue;
    GraphObject seen;
    seen.robot = object->robot;
    seen.name = object->name;
    seen.path = object->path;
    seen.state = object->statistics().state();
    seen.is_system = object->is_system();
    seen.services = ServicesOf(system.robot(object->robot), object->id);
    if (!seen.services.empty() || object->is_image()) graph.objects.push_back(std::move(seen));
  }
  for (const Connection& wire : system.connections()) {
    GraphConnection seen{wire.robot, wire.subject, wire.observer, wire.where, false, 0};
    if (const ObserverLink* const link = FindLink(system, wire); link != nullptr) {
      seen.connected = true;
      seen.events = link->sent;
    }
    graph.connections.push_back(std::move(seen));
  }
  return graph;
}

nlohmann::ordered_json GraphToJson(const GraphView& graph) {
  using Json = nlohmann::ordered_json;
  Json json = {{"virtual_time_s", graph.virtual_time_s}};
  json["objects"] = Json::array();
  for (const GraphObject& object : graph.objects) {
    Json services = Json::array();
    for (const GraphService& service : object.services) {
      services.push_back(
          {{"name", service.name}, {"kind", service.is_subject ? "subject" : "observer"}});
    }
    json["objects"].push_back({{"robot", object.robot},
                               {"name", object.name},
                               {"image", object.path},
                               {"state", object.state},
                               {"services", services}});
  }
  json["connections"] = Json::array();
  for (const GraphConnection& wire : graph.connections) {
    json["connections"].push_back({{"robot", wire.robot},
                                   {"subject", wire.subject},
                                   {"observer", wire.observer},
                                   {"where", wire.where},
                                   {"connected", wire.connected},
                                   {"events", wire.events}});
  }
  return json;
}

}  // namespace openr_host
