#include "cases/scene/exclusive_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace crossgrain::scene {

std::string exactly_one(const toml_input::TomlTable& t, const std::vector<std::string>& keys) {
    std::string found;
    for (const auto& key : keys) {
        if (!t.has(key)) continue;
        if (!found.empty()) {
            throw t.error(key, "contradicts", fmt::format("'{}' as well", t.dotted(found)),
                          "one of the two", "remove one");
        }
        found = key;
    }
    if (found.empty()) {
        throw t.missing(keys.front(), fmt::format("one of '{}'", fmt::join(keys, "', '")));
    }
    return found;
}

}  // namespace crossgrain::scene
