#include "adapters/registry/program_version.hpp"

#include "adapters/registry/source_digests.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

std::string program_version() {
    return fmt::format("{} (source {})", CROSSGRAIN_VERSION, source_digest);
}

std::string release_version() {
    return CROSSGRAIN_VERSION;
}

}  // namespace crossgrain::adapters
