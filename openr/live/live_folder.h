// The folder in which each run of this user has a socket, so that other commands can find the run.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// A run of this user that goes on, and that openr poke and openr attach can reach by its socket.
struct LiveRun {
  std::string name;    // value of --run-name, or the last part of the stick's path
  int process = 0;     // process id of openr run
  std::string socket;  // path of the run's socket
};

// Returns the folder of the sockets of all runs of this user.  Only this user can enter it.  Makes
// the folder if it is missing.  Throws std::runtime_error if the folder cannot be made, or if other
// users can enter it.
std::string LiveFolder();

// Returns the path of the socket of this process: "FOLDER/NAME.PROCESS".  Keeps letters, digits,
// '_' and '-' of `name`, and replaces all other characters by '_'.  Cuts the name to 40 characters,
// because the path of a socket can have at most 107 characters.
std::string LiveSocketPath(const std::string& name);

// Returns whether a process, such as the run that made the socket, has the socket at `path` open.
// Also returns true if no descriptor is left with which to find this out.
bool IsLiveSocketOpen(const std::string& path);

// Returns the runs of this user that go on, sorted by name.  Removes the sockets that no process
// has open and whose processes have ended, because a killed process could not remove its own
// socket.  Does not wait for any run.
std::vector<LiveRun> LiveRuns();

// Returns the run with the name or the process id `wanted`.  Throws std::runtime_error with the
// names of all runs if no run fits, or if several fit.
LiveRun FindLiveRun(const std::string& wanted);

}  // namespace openr_host
