#include "native/base/file_stem.hpp"

namespace crossgrain {
namespace {

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("=._+-").find(c) != std::string_view::npos;
}

}  // namespace

std::string file_stem(const std::vector<std::string>& parts, std::size_t longest) {
    std::string name;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        if (!name.empty()) name += '-';
        for (const char c : part)
            name += is_plain(c) ? c : '_';
    }
    // Not hidden, not "..", and no option of a program.
    if (name.empty() || name.front() == '.' || name.front() == '-') name.insert(0, "_");
    if (name.size() > longest) name.resize(longest);
    return name;
}

}  // namespace crossgrain
