#include "adapters/registry/program_version.hpp"

#include "adapters/registry/source_digest.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

std::string program_version() {
    return fmt::format("{} (source {})", CROSSGRAIN_VERSION, source_digest);
}

}  // namespace crossgrain::adapters
