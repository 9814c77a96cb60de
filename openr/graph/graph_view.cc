#include "openr/graph/graph_view.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "runtime/base/assert.h"
#include "runtime/core/connection_state.h"
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

const SubjectState* FindSubject(const System& system, const Robot& robot,
                                const std::string& service) {
  const auto found = robot.directory.find(service);
  if (found == robot.directory.end()) return nullptr;
  const Object* const object = system.object(found->second.first);
  for (const auto& subject : object->subjects) {
    if (subject->service == service) return subject.get();
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
    seen.state = object->state;
    seen.is_system = object->is_system;
    seen.services = ServicesOf(system.robot(object->robot), object->id);
    if (!seen.services.empty() || object->is_image) graph.objects.push_back(std::move(seen));
  }
  std::map<std::pair<int, std::string>, size_t> links_used;
  for (const Connection& wire : system.connections()) {
    const Robot& robot = system.robot(wire.robot);
    GraphConnection seen{wire.robot, wire.subject, wire.observer, wire.where, false, 0};
    const SubjectState* const subject = FindSubject(system, robot, wire.subject);
    // Finds the ObserverLink of this connection by its index: the subject has one link for each of
    // its connections, in the order of the lines in CONNECT.CFG.  Does not count a line that names
    // an unknown observer, because such a line makes no link.
    if (subject != nullptr && robot.directory.contains(wire.observer)) {
      const size_t link = links_used[{wire.robot, wire.subject}]++;
      seen.connected = link < subject->links.size();
      if (seen.connected) seen.events = subject->links[link].sent;
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
