#include "cases/catalog/reference.hpp"

#include "cases/toml/keyed_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

namespace crossgrain::catalog {
namespace {

struct Spelling {
    std::string_view prefix, form;
};

Spelling spelling_of(Reference::Kind kind) {
    switch (kind) {
    case Reference::Kind::closed_form:
        return {"analytic:", "\"analytic:...\""};
    case Reference::Kind::published:
        return {"published:", "\"published:<file>/<name>\""};
    case Reference::Kind::converged:
        return {"converged:", "\"converged:<variant>\""};
    }
    return {};
}

}  // namespace

std::string to_string(const Reference& reference) {
    if (reference.name.empty()) return {};
    return std::string(spelling_of(reference.kind).prefix) + reference.name;
}

Reference read_reference(const toml_input::KeyedTable& t,
                         std::initializer_list<Reference::Kind> kinds) {
    const std::string text = t.text("against");
    std::vector<std::string_view> forms;
    for (const Reference::Kind kind : kinds) {
        const Spelling spelling = spelling_of(kind);
        const std::size_t length = spelling.prefix.size();
        if (text.starts_with(spelling.prefix) && text.size() > length) {
            return {.kind = kind, .name = text.substr(length)};
        }
        forms.push_back(spelling.form);
    }
    throw t.error("against", "names no reference", fmt::format("\"{}\"", text),
                  fmt::format("{}", fmt::join(forms, " or ")));
}

}  // namespace crossgrain::catalog
