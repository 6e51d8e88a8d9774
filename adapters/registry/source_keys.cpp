#include "adapters/registry/source_keys.hpp"

#include "adapters/registry/source_digests.hpp"
#include "native/base/digest.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace crossgrain::adapters {
namespace {

const SourceFolder& folder_named(std::span<const SourceFolder> table, const std::string& name) {
    const auto found = std::ranges::find(table, name, &SourceFolder::folder);
    if (found == table.end()) throw std::invalid_argument("no sources are known in " + name);
    return *found;
}

}  // namespace

std::set<std::string> with_needs(std::span<const SourceFolder> table,
                                 const std::vector<std::string>& folders) {
    std::set<std::string> all;
    std::vector<std::string> waiting = folders;
    while (!waiting.empty()) {
        const std::string folder = waiting.back();
        waiting.pop_back();
        if (!all.insert(folder).second) continue;
        std::istringstream needs(folder_named(table, folder).needs);
        for (std::string need; needs >> need;)
            waiting.push_back(need);
    }
    return all;
}

std::string source_key(std::span<const SourceFolder> table,
                       const std::vector<std::string>& folders) {
    std::string digests;
    for (const auto& folder : with_needs(table, folders))
        digests += folder + " " + folder_named(table, folder).digest + "\n";
    return sha256(digests);
}

std::string source_key(const std::vector<std::string>& folders) {
    return source_key(source_folders, folders);
}

std::span<const SourceFolder> built_sources() {
    return source_folders;
}

}  // namespace crossgrain::adapters
