#include "reports/web/file_names.hpp"

#include "native/base/file_stem.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace crossgrain::reports {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

}  // namespace

std::string FileNames::next(const std::vector<std::string>& parts, std::string_view extension) {
    const std::string stem = file_stem(parts);
    std::string name = fmt::format("{}{}", stem, extension);
    for (int copy = 2; !taken_.insert(lower(name)).second; ++copy)
        name = fmt::format("{}-{}{}", stem, copy, extension);
    return name;
}

}  // namespace crossgrain::reports
