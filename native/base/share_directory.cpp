#include "native/base/share_directory.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace crossgrain {

std::filesystem::path share_directory() {
    namespace fs = std::filesystem;
    if (const char* given = std::getenv("CROSSGRAIN_SHARE"); given != nullptr && *given != '\0')
        return given;
    std::error_code error;
    const fs::path binary = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& candidate :
         {binary / "share/crossgrain", binary.parent_path() / "share/crossgrain"}) {
        if (fs::is_directory(candidate / "catalog", error)) return candidate;
    }
    throw CaseError({.problem = "the catalogue of cases is missing",
                     .expected = fmt::format("{}/share/crossgrain", binary.string()),
                     .hint = "build the project or set CROSSGRAIN_SHARE"});
}

}  // namespace crossgrain
