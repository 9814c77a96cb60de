// The graph of a System as plain data: objects, services, connections.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

class System;

struct GraphService {
  std::string name;  // full name, of four parts
  bool is_subject = true;
};

struct GraphObject {
  int robot = 0;
  std::string name;
  std::string path;   // path of the image; empty for parts of the system
  std::string state;  // see Object::state
  bool is_system = false;
  std::vector<GraphService> services;  // sorted by name
};

struct GraphConnection {
  int robot = 0;
  std::string subject, observer;  // names of services
  std::string where;              // "CONNECT.CFG:4"
  bool connected = false;         // false: the runtime refused the line
  uint64_t events = 0;            // number of events sent so far
};

struct GraphView {
  double virtual_time_s = 0;
  std::vector<GraphObject> objects;          // objects with services
  std::vector<GraphConnection> connections;  // in the order of CONNECT.CFG
};

// Collects the objects, services and connections of `system`.  REQUIRES: the system has booted.
GraphView CollectGraph(System* system);

nlohmann::ordered_json GraphToJson(const GraphView& graph);

// Returns the graph in the language of Graphviz.
std::string GraphToDot(const GraphView& graph);

}  // namespace openr_host
