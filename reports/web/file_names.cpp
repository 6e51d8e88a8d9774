#include "reports/web/file_names.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace crossgrain::reports {
namespace {

constexpr std::size_t longest = 160;  // file systems take 255 bytes, temporary names need some

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("=._+-").find(c) != std::string_view::npos;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string name;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        if (!name.empty()) name += '-';
        for (const char c : part)
            name += is_plain(c) ? c : '_';
    }
    if (name.empty() || name.front() == '.') name.insert(0, "_");  // not hidden, not ".."
    if (name.size() > longest) name.resize(longest);
    return name;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

}  // namespace

std::string FileNames::next(const std::vector<std::string>& parts, std::string_view extension) {
    const std::string stem = joined(parts);
    std::string name = fmt::format("{}{}", stem, extension);
    for (int copy = 2; !taken_.insert(lower(name)).second; ++copy)
        name = fmt::format("{}-{}{}", stem, copy, extension);
    return name;
}

}  // namespace crossgrain::reports
