// The graph of a System as plain data: objects, services, connections.  The command openr graph
// writes it as JSON or as a drawing.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

class System;

struct GraphService {
  // Full name of the service, such as "RCServer.Move.MoveCommand.S": the object, the name of the
  // service, the type of the data, and S (subject) or O (observer).
  std::string name;
  bool is_subject = true;
};

struct GraphObject {
  int robot = 0;
  std::string name;
  std::string path;   // path of the object's image; empty for parts of the system
  std::string state;  // TEXT in the last INFO line "state: TEXT" that the object printed
  bool is_system = false;
  std::vector<GraphService> services;  // services of the object, sorted by name
};

struct GraphConnection {
  int robot = 0;
  std::string subject, observer;  // names of the two connected services
  std::string where;              // place of the line that asks for the connection: "CONNECT.CFG:4"
  // True: the connection was made; false: the runtime refused the line at `where`.
  bool connected = false;
  uint64_t events = 0;  // number of messages that the subject sent to the observer so far
};

struct GraphView {
  double virtual_time_s = 0;
  // All objects of the stick, and those parts of the system that have services, such as the robot's
  // devices.
  std::vector<GraphObject> objects;
  std::vector<GraphConnection> connections;  // all connections, in the order of CONNECT.CFG
};

// Returns the objects, services and connections of `system`.  REQUIRES: the system has booted,
// because objects register and connect their services during the boot.
GraphView CollectGraph(System* system);

nlohmann::ordered_json GraphToJson(const GraphView& graph);

// Returns the drawing of a graph as text in the language of Graphviz.
std::string GraphToDot(const GraphView& graph);

}  // namespace openr_host
