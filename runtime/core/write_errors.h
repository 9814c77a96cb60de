// Reports files of the stick whose bytes could not all be written to the host's disk, for instance
// because the disk is full.  Programs often ignore such an error.
#pragma once

#include <cstdio>

#include "runtime/core/object.h"

namespace openr_host {

// Adds a warning that `file` does not contain all bytes which the current object has written to it.
// Adds only one warning for each file.  `error` is the errno of the write that failed, or 0 if it
// is not known.  With 0, adds the warning only if the disk is full.  Keeps errno, because the
// object reads it.
void ReportWriteError(OpenFiles::File* file, int error);

// Writes the bytes that `stream` still holds to its `file`.  Reports, as ReportWriteError() does,
// if this write or an earlier one to the stream has failed.  Keeps errno.
void FlushStream(std::FILE* stream, OpenFiles::File* file);

// Reports, as ReportWriteError() does, if an earlier write to the stream `file` of the current
// object has failed.  Called before the error mark of the stream is cleared.  Does nothing for a
// stream that is not a file of the object.
void ReportErrorMark(std::FILE* file);

// Writes to their files the bytes that are still in the buffers of the streams that `object` has
// left open.  Reports, as ReportWriteError() does, each file whose bytes could not all be written,
// now or earlier.  Called at the end of `openr run`, and before an object is replaced, because the
// replacement closes the object's streams without checking for errors.  Not called with --jobs,
// because the sticks are write-protected then.
void FlushStreams(Object* object);

}  // namespace openr_host
