// The folder in which each run of this user has a socket, so that other commands find the run.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// A run of this user that goes on, and that openr poke and openr attach can reach through its
// socket.
struct LiveRun {
  std::string name;    // --run-name, or the last part of the stick's path
  int process = 0;     // process id of openr run
  std::string socket;  // path of its socket
};

// Returns the folder of the sockets, which only this user can enter, and makes it if it is missing.
// Throws std::runtime_error if it cannot be made, or if others can enter it.
std::string LiveFolder();

// Returns the path of the socket of this process: "FOLDER/NAME.PROCESS".  Other characters of
// `name` than letters, digits, '_' and '-' become '_', and it is cut to 40 characters, because the
// path of a socket has 107 at most.
std::string LiveSocketPath(const std::string& name);

// Returns the runs of this user that go on, sorted by name.  Removes the sockets of processes that
// have ended, because a process that was killed has not removed its own.
std::vector<LiveRun> LiveRuns();

// Returns the run that the user means: `wanted` is its name or its process id.  Throws
// std::runtime_error with the names of all runs if no run fits, or several do.
LiveRun FindLiveRun(const std::string& wanted);

}  // namespace openr_host
