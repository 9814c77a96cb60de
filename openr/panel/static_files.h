// Finds the files of the built page.
#pragma once

#include <string>

namespace openr_host {

// Returns the path of the file that the path of an URL means ("/" is index.html); "" if there is no
// such file below `folder`.  Parts of the path that begin with a dot lead nowhere.
std::string FindStaticFile(const std::string& folder, const std::string& url_path);

// Returns the content type of a file by the extension of its name.
std::string ContentTypeOf(const std::string& file);

// Returns the value of the header Cache-Control for the path of an URL.  The names of files in
// /assets have a hash of their content, so these files never change.
std::string CacheControlOf(const std::string& url_path);

}  // namespace openr_host
