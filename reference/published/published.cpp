#include "reference/published/published.hpp"

#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <array>

namespace crossgrain::published {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 3> trends{"constant", "increasing", "decreasing"};

PublishedValue read_value(const TomlTable& t, const std::string& name, const std::string& source) {
    PublishedValue value{.id = name,
                         .quantity = t.text("quantity"),
                         .source = source,
                         .place = t.text("place"),
                         .obtained = t.text("obtained")};
    if (t.has("trend")) {
        value.trend = trends[t.choice("trend", trends)];
    } else {
        value.value = t.number("value", Range::any());
        value.error = t.number("error", Range::not_negative());
    }
    t.reject_unknown_keys();
    return value;
}

}  // namespace

PublishedValues::PublishedValues(const std::filesystem::path& directory) {
    if (!std::filesystem::is_directory(directory)) {
        throw CaseError({.file = directory.string(),
                         .problem = "is no directory",
                         .expected = "the published values that come with the program"});
    }
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".toml") continue;
        const toml::table root = toml_input::parse_toml_file(entry.path().string());
        const TomlTable file(entry.path().string(), "", {&root});
        const std::string source = file.text("source");
        const TomlTable values = file.table("value");
        for (const auto& name : values.keys()) {
            const std::string id = entry.path().stem().string() + "/" + name;
            values_.emplace(id, read_value(values.table(name), id, source));
        }
        file.reject_unknown_keys();
    }
}

std::optional<PublishedValue> PublishedValues::find(const std::string& id) const {
    const auto found = values_.find(id);
    if (found == values_.end()) return std::nullopt;
    return found->second;
}

}  // namespace crossgrain::published
