// Where the program finds what belongs to it: next to itself, in the build tree as in an
// installed one.
#pragma once

#include <string>

namespace openr_host {

// The folder of the running program.
std::string ProgramFolder();

// The running program itself.
std::string ProgramFile();

// Its name if PATH leads to it, else the file: what a person writes in a shell.
std::string ProgramCall();

// The default stick: a folder that holds OPEN-R/.  Throws std::runtime_error naming the places
// looked at when it is nowhere.
std::string DefaultStick();

// The sources of our objects and, in stub.cfg/, their configuration.  Throws std::runtime_error
// when the program runs from where they are not.
std::string ObjectSources();

// File of the robot model `name` ("ers210").  Throws std::runtime_error that lists the models
// there are.
std::string ModelFile(const std::string& name);

// `name` itself where there is such a file, else the file of that name that came with the program
// if there is one ("ers210.cost"), else `name`.
std::string DataFile(const std::string& name);

// libopenr_render.so, or its bare name for the dynamic linker to look for.
std::string RenderLibrary();

}  // namespace openr_host
