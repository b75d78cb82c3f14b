// Files that come with the programs, such as scenes and stored surfaces: found from the build folder and when installed.
#pragma once

#include <string>
#include <string_view>

namespace fyd::sim {

/// The folder of these files: `share/fyd-console` beside the folder of the program, where a package installs them and a
/// build folder has a link to `resources`. Not checked whether it is there.
[[nodiscard]] std::string resourceFolder();

/// The file that somebody means by `given`: itself where it exists or names a folder; else the one of this name, with or
/// without its ending .toml, in `kind` (such as "scenes") of the resources.
/// @return `given` where there is neither, so that an error names what was asked for
[[nodiscard]] std::string findResource(const std::string& given, std::string_view kind);

}  // namespace fyd::sim
