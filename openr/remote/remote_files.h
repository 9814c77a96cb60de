// Moves files between this computer and the Memory Stick of a robot, by the remote control.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "RemoteFiles.h"
#include "RemoteProtocol.h"

namespace openr_host {

class RemoteClient;

// The functions below throw the errors of RemoteClient.  They make the client use version 2 of the
// protocol; an older robot refuses that.

// Returns the robot's INFO, which in version 2 says which files the robot takes.
RcInfo AskFileInfo(RemoteClient* client);

// Returns all motions on the stick, sorted by name.  `frame` gets the number of the frame of the
// last answer.
std::vector<RcListEntry> ListMotions(RemoteClient* client, uint32_t* frame);

// Sends a file and returns the frame of the last answer.  Calls `progress` with the number of bytes
// that the robot has taken, again and again.
uint32_t UploadFile(RemoteClient* client, RcFileKind kind, const std::string& name,
                    const std::string& bytes, const std::function<void(size_t done)>& progress);

// Returns the bytes of a file of the stick.  Throws std::runtime_error when the file changes
// meanwhile.
std::string DownloadFile(RemoteClient* client, RcFileKind kind, const std::string& name,
                         uint32_t* frame);

}  // namespace openr_host
